#pragma once

#include "core/kernel.hpp"

namespace eisph {

// Sums over neighbours (method of De Castro 2019, section 3.3, and the corrections stated with each one).
// Lengths are in units of the smoothing length: xi = x / h, so grad W = alpha/h (dW/dq)/q xi_ij and the
// support radius is 2. Each operator adds the contribution of one neighbour (Real = float or double) or of
// a pack of them (Real = Pack); factors common to all neighbours (alpha, powers of h, density) are applied
// once per particle by the caller.

/// Keeps q positive for particles at the same place, whose contributions vanish or are finite: no eta is
/// needed in denominators.
inline constexpr double kTinySquared = 1e-12;

template <int Dim, class Real>
struct Vector {
  Real x[Dim];
};

template <int Dim, class Real>
inline Vector<Dim, Real> zero_vector() {
  Vector<Dim, Real> vector;
  for (Real& component : vector.x) component = splat<Real>(0.0);
  return vector;
}

/// xi_i - xi_j and what the kernel makes of it.
template <int Dim, class Real, class Kernel>
struct PairGeometry {
  Vector<Dim, Real> offset;  ///< xi_i - xi_j
  Real squared;              ///< q^2
  Real q;
  Real inverse_q;
  Real gradient;  ///< (dW/dq)/q / alpha, not positive; grad W = alpha/h gradient xi_ij

  /// W / alpha
  [[nodiscard]] Real value() const { return Kernel::value(q); }
};

template <int Dim, class Real, class Kernel>
inline PairGeometry<Dim, Real, Kernel> pair_geometry(const Vector<Dim, Real>& xi_i,
                                                     const Vector<Dim, Real>& xi_j) {
  PairGeometry<Dim, Real, Kernel> pair;
  pair.squared = splat<Real>(kTinySquared);
  for (int d = 0; d < Dim; ++d) {
    pair.offset.x[d] = xi_i.x[d] - xi_j.x[d];
    pair.squared += pair.offset.x[d] * pair.offset.x[d];
  }
  pair.inverse_q = reciprocal_sqrt(pair.squared);
  pair.q = pair.squared * pair.inverse_q;
  pair.gradient = Kernel::gradient(pair.q, pair.inverse_q);
  return pair;
}

/// Sums of the pressure equation (thesis (3.34), (3.35) at constant density, without eta):
/// A_ij = (2/rho0) V_j x_ij . grad W_ij / r^2.
template <class Real>
struct LaplacianSums {
  Real coefficient = splat<Real>(0.0);  ///< sum A_ij, without 2 alpha/(rho0 h^2)
  Real pressure = splat<Real>(0.0);     ///< sum A_ij P_j, likewise, Pa

  template <int Dim, class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j, Real pressure_j) {
    const Real a = volume_j * pair.gradient;
    coefficient += a;
    pressure += a * pressure_j;
  }
};

/// Number density sum V_j W_ij, without alpha. Neighbour lists leave the particle itself out.
template <class Real>
struct DensitySum {
  Real value = splat<Real>(0.0);

  template <int Dim, class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j) {
    value += volume_j * pair.value();
  }
};

/// Viscous term after Monaghan (thesis (3.24) with the sign as corrected, without eta):
/// nu lap u = 2 (D + 2) nu sum V_j (u_ij . x_ij)/r^2 grad W_ij; here without 2 (D + 2) nu
/// alpha/h^2.
template <int Dim, class Real>
struct ViscousSum {
  Vector<Dim, Real> value = zero_vector<Dim, Real>();

  template <class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j, const Vector<Dim, Real>& u_i,
           const Vector<Dim, Real>& u_j) {
    Real approach = splat<Real>(0.0);
    for (int d = 0; d < Dim; ++d) approach += (u_i.x[d] - u_j.x[d]) * pair.offset.x[d];
    add(pair, volume_j * approach * pair.gradient);
  }
  /// The same with the pair's term of DivergenceSum for u, the other way round: V_j u_ij . grad W_ij.
  template <class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real closing) {
    const Real scale = closing * pair.inverse_q * pair.inverse_q;
    for (int d = 0; d < Dim; ++d) value.x[d] += scale * pair.offset.x[d];
  }
};

/// Viscous term after Morris, Fox & Zhu (1997): nu lap u = 2 nu sum V_j (x_ij . grad W_ij)/r^2
/// u_ij; here without 2 nu alpha/h^2. Of a shear flow along the axes of a lattice Monaghan's form finds 0.78
/// of the Laplacian (quintic spline, h = 1.4 dx in the plane), across them 1.22; this one finds the same in
/// all directions, but turns free bodies of fluid less freely: it does not conserve angular momentum.
template <int Dim, class Real>
struct VelocityLaplacianSum {
  Vector<Dim, Real> value = zero_vector<Dim, Real>();

  template <class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j, const Vector<Dim, Real>& u_i,
           const Vector<Dim, Real>& u_j) {
    const Real scale = volume_j * pair.gradient;
    for (int d = 0; d < Dim; ++d) value.x[d] += scale * (u_i.x[d] - u_j.x[d]);
  }
};

/// Divergence sum V_j (s_j - s_i) . grad W_ij (thesis (3.22) divided by density), without alpha/h.
template <class Real>
struct DivergenceSum {
  Real value = splat<Real>(0.0);

  /// Returns the pair's term.
  template <int Dim, class Kernel>
  Real add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j, const Vector<Dim, Real>& s_i,
           const Vector<Dim, Real>& s_j) {
    Real opening = splat<Real>(0.0);
    for (int d = 0; d < Dim; ++d) opening += (s_j.x[d] - s_i.x[d]) * pair.offset.x[d];
    const Real term = volume_j * pair.gradient * opening;
    value += term;
    return term;
  }
};

/// Pressure gradient sum V_j (P_i + P_j) grad W_ij (thesis (3.23) at constant density), without alpha/h, Pa.
template <int Dim, class Real>
struct PressureGradientSum {
  Vector<Dim, Real> value = zero_vector<Dim, Real>();

  template <class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j, Real pressure_i, Real pressure_j) {
    const Real scale = volume_j * (pressure_i + pressure_j) * pair.gradient;
    for (int d = 0; d < Dim; ++d) value.x[d] += scale * pair.offset.x[d];
  }
};

/// Difference form of a gradient, sum V_j (f_j - f_i) grad W_ij, without alpha/h.
template <int Dim, class Real>
struct ScalarGradientSum {
  Vector<Dim, Real> value = zero_vector<Dim, Real>();

  template <class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j, Real difference) {
    const Real scale = volume_j * difference * pair.gradient;
    for (int d = 0; d < Dim; ++d) value.x[d] += scale * pair.offset.x[d];
  }
};

/// Gradient of the number density, sum V_j grad W_ij, without alpha/h.
template <int Dim, class Real>
struct ConcentrationGradientSum {
  Vector<Dim, Real> value = zero_vector<Dim, Real>();

  template <class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j) {
    const Real scale = volume_j * pair.gradient;
    for (int d = 0; d < Dim; ++d) value.x[d] += scale * pair.offset.x[d];
  }
};

/// First moments of the gradient, sum V_j (x_j - x_i) (x) grad W_ij, without alpha: the matrix whose inverse
/// makes the difference form exact for linear fields. Symmetric; entries xx, yy, (zz,) xy, (xz, yz).
template <int Dim, class Real>
struct MomentSum {
  static constexpr int kEntries = Dim * (Dim + 1) / 2;
  Vector<kEntries, Real> value = zero_vector<kEntries, Real>();

  template <class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j) {
    const Real scale = volume_j * pair.gradient;
    int entry = Dim;
    for (int a = 0; a < Dim; ++a) {
      value.x[a] -= scale * pair.offset.x[a] * pair.offset.x[a];
      for (int b = a + 1; b < Dim; ++b) value.x[entry++] -= scale * pair.offset.x[a] * pair.offset.x[b];
    }
  }
};

/// Diffusion of a scalar f, 2 sum V_j psi_ij x_ji . grad W_ij / r^2 (Molteni & Colagrossi 2009) with
/// psi_ij = f_j - f_i, or less the mean of the gradients at i and j along x_ji (Antuono et al. 2010); without
/// -2 alpha / h^2.
template <class Real>
struct DiffusionSum {
  Real value = splat<Real>(0.0);

  template <int Dim, class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j, Real difference) {
    value += volume_j * difference * pair.gradient;
  }

  /// `gradients`: the sum of those at i and j, in units of f per smoothing length.
  template <int Dim, class Kernel>
  void add(const PairGeometry<Dim, Real, Kernel>& pair, Real volume_j, Real difference,
           const Vector<Dim, Real>& gradients) {
    Real along = splat<Real>(0.0);
    for (int d = 0; d < Dim; ++d) along += gradients.x[d] * pair.offset.x[d];
    add(pair, volume_j, difference + splat<Real>(0.5) * along);
  }
};

}  // namespace eisph
