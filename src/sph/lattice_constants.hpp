#pragma once

#include "core/kernel.hpp"

namespace eisph {

/// Sums over the undisturbed lattice, that normalise those of the flow.
struct LatticeConstants {
  double number_density = 0.0;  ///< sum V W, the particle itself included, dimensionless
  double laplacian = 0.0;       ///< sum |A| rho0 h^2, dimensionless (2D 4.38, 3D 5.28 at h = 1.32 dx)
  double spread = 0.0;          ///< mean of x^2 weighted with W, h^2 of the lattice
  int neighbours = 0;           ///< within the support, without the particle itself
  /// Largest eigenvalues of the viscous sums over all plane waves of velocity, times h^2 / nu, dimensionless:
  /// of VelocityLaplacianSum and of ViscousSum.
  double viscous_eigenvalue = 0.0;
  double radial_viscous_eigenvalue = 0.0;
};

/// For the square or cubic lattice of given h/dx.
template <int Dim>
LatticeConstants lattice_constants(KernelKind kernel, double smoothing_ratio);

}  // namespace eisph
