#pragma once

#include "core/pack.hpp"

#include <numbers>

namespace eisph {

/// The cubic spline kernel (thesis (3.14), its second branch corrected to the third power), with q = r/h:
///   W = alpha [1 - 3/2 q^2 + 3/4 q^3]  for q < 1,   alpha/4 (2 - q)^3  for 1 <= q < 2,   0 beyond,
/// alpha = 10/(7 pi h^2) in two and 1/(pi h^3) in three dimensions. Written without branches as
///   W = alpha/4 [(2 - q)_+^3 - 4 (1 - q)_+^3].
/// The functions below leave alpha and the powers of h to the caller.
namespace cubic_spline {

inline constexpr double kSupport = 2.0;  ///< support radius / smoothing length

/// alpha h^Dim, dimensionless.
template <int Dim>
constexpr double normalisation() {
  static_assert(Dim == 2 || Dim == 3);
  return Dim == 2 ? 10.0 / (7.0 * std::numbers::pi) : 1.0 / std::numbers::pi;
}

/// W / alpha
template <class Real>
inline Real value(Real q) {
  const Real outer = positive_part(splat<Real>(2.0) - q);
  const Real inner = positive_part(splat<Real>(1.0) - q);
  return splat<Real>(0.25) * outer * outer * outer - inner * inner * inner;
}

/// (dW/dq) / alpha
template <class Real>
inline Real derivative(Real q) {
  const Real outer = positive_part(splat<Real>(2.0) - q);
  const Real inner = positive_part(splat<Real>(1.0) - q);
  return splat<Real>(3.0) * inner * inner - splat<Real>(0.75) * outer * outer;
}

}  // namespace cubic_spline
}  // namespace eisph
