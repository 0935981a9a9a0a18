#pragma once

#include "core/pack.hpp"

#include <numbers>
#include <string_view>

namespace eisph {

// Smoothing kernels W(r, h) with q = r/h and a support radius of 2 h. Each is a type with
//   normalisation<Dim>()   alpha h^Dim, dimensionless
//   value(q)               W / alpha
//   derivative(q)          (dW/dq) / alpha
//   gradient(q, 1/q)       (dW/dq)/q / alpha, so that grad W = alpha/h gradient xi_ij with xi = x/h
// that operators on pairs take as a template parameter; with_kernel() turns a choice made at run time into
// such a type once per loop.

inline constexpr double kKernelSupport = 2.0;  ///< support radius / smoothing length, of all kernels

enum class KernelKind { WendlandC2, WendlandC4, CubicSpline };

/// W = alpha (1 - q/2)^4 (1 + 2 q) (Wendland 1995; in SPH Robinson & Monaghan 2012), alpha = 7/(4 pi h^2) in
/// two and 21/(16 pi h^3) in three dimensions. Its Fourier transform is positive: particles do not pair
/// however many neighbours they have (Dehnen & Aly 2012).
struct WendlandC2 {
  template <int Dim>
  static constexpr double normalisation() {
    static_assert(Dim == 2 || Dim == 3);
    return Dim == 2 ? 7.0 / (4.0 * std::numbers::pi) : 21.0 / (16.0 * std::numbers::pi);
  }
  template <class Real>
  static Real value(Real q) {
    const Real rest = positive_part(splat<Real>(1.0) - splat<Real>(0.5) * q);
    const Real squared = rest * rest;
    return squared * squared * (splat<Real>(1.0) + splat<Real>(2.0) * q);
  }
  template <class Real>
  static Real derivative(Real q) {
    return q * gradient(q, q);
  }
  template <class Real>
  static Real gradient(Real q, Real /*inverse_q*/) {
    const Real rest = positive_part(splat<Real>(1.0) - splat<Real>(0.5) * q);
    return splat<Real>(-5.0) * rest * rest * rest;
  }
};

/// W = alpha (1 - q/2)^6 (1 + 3 q + 35/12 q^2), alpha = 9/(4 pi h^2) in two and 495/(256 pi h^3) in three
/// dimensions.
struct WendlandC4 {
  template <int Dim>
  static constexpr double normalisation() {
    static_assert(Dim == 2 || Dim == 3);
    return Dim == 2 ? 9.0 / (4.0 * std::numbers::pi) : 495.0 / (256.0 * std::numbers::pi);
  }
  template <class Real>
  static Real value(Real q) {
    const Real rest = positive_part(splat<Real>(1.0) - splat<Real>(0.5) * q);
    const Real squared = rest * rest;
    const Real polynomial = splat<Real>(1.0) + q * (splat<Real>(3.0) + splat<Real>(35.0 / 12.0) * q);
    return squared * squared * squared * polynomial;
  }
  template <class Real>
  static Real derivative(Real q) {
    return q * gradient(q, q);
  }
  template <class Real>
  static Real gradient(Real q, Real /*inverse_q*/) {
    const Real rest = positive_part(splat<Real>(1.0) - splat<Real>(0.5) * q);
    const Real squared = rest * rest;
    return splat<Real>(-14.0 / 3.0) * squared * squared * rest * (splat<Real>(1.0) + splat<Real>(2.5) * q);
  }
};

/// The cubic spline of the thesis (3.14), its second branch corrected to the third power:
///   W = alpha [1 - 3/2 q^2 + 3/4 q^3]  for q < 1,   alpha/4 (2 - q)^3  for 1 <= q < 2,   0 beyond,
/// alpha = 10/(7 pi h^2) in two and 1/(pi h^3) in three dimensions. Written without branches as
///   W = alpha/4 [(2 - q)_+^3 - 4 (1 - q)_+^3].
struct CubicSpline {
  template <int Dim>
  static constexpr double normalisation() {
    static_assert(Dim == 2 || Dim == 3);
    return Dim == 2 ? 10.0 / (7.0 * std::numbers::pi) : 1.0 / std::numbers::pi;
  }
  template <class Real>
  static Real value(Real q) {
    const Real outer = positive_part(splat<Real>(2.0) - q);
    const Real inner = positive_part(splat<Real>(1.0) - q);
    return splat<Real>(0.25) * outer * outer * outer - inner * inner * inner;
  }
  template <class Real>
  static Real derivative(Real q) {
    const Real outer = positive_part(splat<Real>(2.0) - q);
    const Real inner = positive_part(splat<Real>(1.0) - q);
    return splat<Real>(3.0) * inner * inner - splat<Real>(0.75) * outer * outer;
  }
  template <class Real>
  static Real gradient(Real q, Real inverse_q) {
    return derivative(q) * inverse_q;
  }
};

/// Calls body(kernel) with an object of the type that `kind` stands for, and returns what it returns.
template <class Body>
inline decltype(auto) with_kernel(KernelKind kind, const Body& body) {
  switch (kind) {
    case KernelKind::WendlandC4:
      return body(WendlandC4{});
    case KernelKind::CubicSpline:
      return body(CubicSpline{});
    case KernelKind::WendlandC2:
      break;
  }
  return body(WendlandC2{});
}

/// alpha h^Dim of a kernel chosen at run time.
template <int Dim>
inline double kernel_normalisation(KernelKind kind) {
  return with_kernel(kind, [](auto kernel) { return decltype(kernel)::template normalisation<Dim>(); });
}

}  // namespace eisph
