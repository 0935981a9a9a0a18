#pragma once

#include "core/scene.hpp"
#include "sph/lattice_constants.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eisph {

/// Artificial viscosity as a kinematic one: nu_a = alpha_v h c0 / (2 (D + 2)), c0 = 10 sqrt(g H). m^2/s
inline double artificial_kinematic_viscosity(const Scene& scene) {
  const double sound_speed = 10.0 * scene.reference_speed() / std::numbers::sqrt2;
  return scene.artificial_viscosity * scene.smoothing_length() * sound_speed / (2.0 * (scene.dimension + 2));
}

/// Viscous limit of the time step, s. An explicit step shortens a wave of velocity by lambda dt, lambda being
/// its eigenvalue under the viscous sums: it overshoots from 1 on and grows from 2 on. With the largest
/// eigenvalues of the lattice the step keeps to kViscousPart of 2, as scattered particles have somewhat
/// larger ones. The limit of the thesis (3.46), 0.5 h^2/nu, is four times as long as 2/lambda.
inline constexpr double kViscousPart = 0.6;
inline double viscous_time_step(const Scene& scene, const LatticeConstants& lattice) {
  const double h = scene.smoothing_length();
  const double rate =
      lattice.radial_viscous_eigenvalue * artificial_kinematic_viscosity(scene) +
      std::max(lattice.viscous_eigenvalue, lattice.radial_viscous_eigenvalue) * scene.kinematic_viscosity;
  return kViscousPart * 2.0 * h * h / rate;
}

/// Largest admissible time step of the incompressible schemes, s: phi dx / Umax with the largest of the
/// present speed, the initial one and the weighted reference speed, and the viscous limit; or the fixed step
/// of the scene.
inline double admissible_time_step(const Scene& scene, const LatticeConstants& lattice, double speed_max) {
  if (scene.scheme.time_step_mode == TimeStepMode::Fixed) return scene.scheme.time_step;
  const double weighted = scene.scheme.reference_speed_weight * scene.reference_speed();
  const double speed = std::max({weighted, scene.initial_speed(), speed_max});
  double step = scene.scheme.phi * scene.particle_spacing / speed;
  const bool viscous = scene.kinematic_viscosity > 0.0 || scene.artificial_viscosity > 0.0;
  if (viscous) step = std::min(step, viscous_time_step(scene, lattice));
  return step;
}

/// Factor kappa of the volume correction: as given, or min(1, 3 phi) with phi = dt Umax / dx, 0.1 with the
/// thesis stepping.
inline double volume_correction_factor(const Scene& scene, double time_step, double speed_max) {
  if (scene.scheme.volume_correction) return *scene.scheme.volume_correction;
  if (scene.scheme.stepping == Stepping::Thesis) return 0.1;
  const double speed = std::max(scene.expected_speed(), speed_max);
  return std::min(1.0, 3.0 * time_step * speed / scene.particle_spacing);
}

}  // namespace eisph
