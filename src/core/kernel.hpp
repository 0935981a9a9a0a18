#pragma once

#include "core/pack.hpp"

#include <numbers>
#include <string_view>

namespace eisph {

// Smoothing kernels W(r, h) with q = r/h and a support radius of 2 h. Each is a type with
//   kReach                 r/h up to which it is felt: neighbours that are farther are not listed
//   normalisation<Dim>()   alpha h^Dim, dimensionless
//   value(q)               W / alpha
//   derivative(q)          (dW/dq) / alpha
//   gradient(q, 1/q)       (dW/dq)/q / alpha, so that grad W = alpha/h gradient xi_ij with xi = x/h
// that operators on pairs take as a template parameter; with_kernel() turns a choice made at run time into
// such a type once per loop.

inline constexpr double kKernelSupport = 2.0;  ///< support radius / smoothing length, of all kernels

enum class KernelKind { QuinticSpline, WendlandC2, CubicSpline };

/// The quintic spline (Schoenberg 1946; Morris, Fox & Zhu 1997) over a support of 2 h: with s = 3 q / 2
///   W = alpha [(3 - s)_+^5 - 6 (2 - s)_+^5 + 15 (1 - s)_+^5],
/// alpha = 63/(1912 pi h^2) in two and 9/(320 pi h^3) in three dimensions. The h of the literature, whose
/// support is 3 h, is 2/3 of ours.
///
/// The sum of V W over a lattice changes least of all kernels here when the lattice is sheared: with h = 1.4
/// dx in the plane by 1e-4 where it is stretched by a tenth, Wendland C2 of the same support by 15e-4. What
/// changes is work against the pressure: it makes a stiff and brittle solid of water under pressure, which
/// eats waves.
///
/// Here with a term more, that takes it to zero with its slope at 1.8 h:
///   W = alpha [... + c (q^2 - 1.8^2) / 3.6 - 0.3^5],  c = 7.5 0.3^4,
/// a thousandth of W(0), by which alpha changes by half a per cent. Of the neighbours within 2 h in space at
/// h = 1.32 dx a quarter is farther; simply left out they would make noise of every particle that comes or
/// goes, and stir water at rest by millimetres per second.
struct QuinticSpline {
  static constexpr double kReach = 1.8;
  template <int Dim>
  static constexpr double normalisation() {
    static_assert(Dim == 2 || Dim == 3);
    return (Dim == 2 ? 0.03305515937977829 : 0.02827613267182139) / std::numbers::pi;
  }
  template <class Real>
  static Real value(Real q) {
    const Branches<Real> branch(q);
    const Real& e = branch.outer;
    return e * e * (splat<Real>(kA) + e * (splat<Real>(kB) + e * (splat<Real>(kC) + e * splat<Real>(kC)))) -
           splat<Real>(6.0 / power_of_5(kMiddle)) * branch.middle * square(square(branch.middle)) +
           splat<Real>(15.0 / power_of_5(kInner)) * branch.inner * square(square(branch.inner));
  }
  template <class Real>
  static Real derivative(Real q) {
    const Branches<Real> branch(q);
    const Real& e = branch.outer;
    const Real slope = splat<Real>(2.0 * kA) +
                       e * (splat<Real>(3.0 * kB) + e * (splat<Real>(4.0 * kC) + e * splat<Real>(5.0 * kC)));
    return square(square(branch.middle)) - square(square(branch.inner)) - e * slope;
  }
  template <class Real>
  static Real gradient(Real q, Real inverse_q) {
    return derivative(q) * inverse_q;
  }

 private:
  // Fourth roots of the factors 45 and 225/2 of the fourth powers in the derivative: they stand in the
  // branches.
  static constexpr double kMiddle = 2.5900200641113513;
  static constexpr double kInner = 3.2567778121631528;
  // (3 - s)^5 and the further term in powers of e = 1.8 - q, e^2 (A + B e + C e^2 + C e^3): small differences
  // of large numbers otherwise.
  static constexpr double kA = 0.624375;
  static constexpr double kB = 3.0375;
  static constexpr double kC = 7.59375;

  template <class Real>
  struct Branches {
    Real outer, middle, inner;
    explicit Branches(Real q)
        : outer(positive_part(splat<Real>(kReach) - q)),
          middle(positive_part(splat<Real>(2.0 * kMiddle) - splat<Real>(1.5 * kMiddle) * q)),
          inner(positive_part(splat<Real>(kInner) - splat<Real>(1.5 * kInner) * q)) {}
  };
  template <class Real>
  static Real square(Real x) {
    return x * x;
  }
  static constexpr double power_of_5(double x) { return x * x * x * x * x; }
};

/// W = alpha (1 - q/2)^4 (1 + 2 q) (Wendland 1995; in SPH Robinson & Monaghan 2012), alpha = 7/(4 pi h^2) in
/// two and 21/(16 pi h^3) in three dimensions. Its Fourier transform is positive: particles do not pair
/// however many neighbours they have (Dehnen & Aly 2012).
struct WendlandC2 {
  static constexpr double kReach = kKernelSupport;
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

/// The cubic spline of the thesis (3.14), its second branch corrected to the third power:
///   W = alpha [1 - 3/2 q^2 + 3/4 q^3]  for q < 1,   alpha/4 (2 - q)^3  for 1 <= q < 2,   0 beyond,
/// alpha = 10/(7 pi h^2) in two and 1/(pi h^3) in three dimensions. Written without branches as
///   W = alpha/4 [(2 - q)_+^3 - 4 (1 - q)_+^3].
struct CubicSpline {
  static constexpr double kReach = kKernelSupport;
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
    case KernelKind::WendlandC2:
      return body(WendlandC2{});
    case KernelKind::CubicSpline:
      return body(CubicSpline{});
    case KernelKind::QuinticSpline:
      break;
  }
  return body(QuinticSpline{});
}

/// r/h up to which neighbours are listed.
inline double kernel_reach(KernelKind kind) {
  return with_kernel(kind, [](auto kernel) { return decltype(kernel)::kReach; });
}

/// W(0) / alpha
inline double kernel_at_zero(KernelKind kind) {
  return with_kernel(kind, [](auto kernel) { return decltype(kernel)::value(0.0); });
}

/// h / dx unless a scene says otherwise: few neighbours, no pairs, and a lattice that yields easily. That of
/// the cubic spline is the thesis's; with it particles pair.
inline double default_smoothing_ratio(KernelKind kind, int dimension) {
  switch (kind) {
    case KernelKind::WendlandC2:
      return dimension == 2 ? 1.32 : 1.2;
    case KernelKind::CubicSpline:
      return 1.32;
    case KernelKind::QuinticSpline:
      break;
  }
  return dimension == 2 ? 1.42 : 1.32;
}

/// Number density below which a particle is on the free surface unless a scene says otherwise. The first row
/// of a lattice has 0.76 (cubic spline, h = 1.32 dx) to 0.86 (quintic spline, 1.2 dx), the second 0.99 and
/// more. With a threshold too high water at rest sinks together, too low it swells: with the quintic spline
/// by 0.2 % for each 0.02 in 20 rows.
inline double default_free_surface_threshold(KernelKind kind, int dimension) {
  if (kind != KernelKind::QuinticSpline) return 0.9;
  return dimension == 2 ? 0.93 : 0.91;
}

/// alpha h^Dim of a kernel chosen at run time.
template <int Dim>
inline double kernel_normalisation(KernelKind kind) {
  return with_kernel(kind, [](auto kernel) { return decltype(kernel)::template normalisation<Dim>(); });
}

}  // namespace eisph
