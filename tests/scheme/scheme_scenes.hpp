#pragma once

#include "scheme/scenes.hpp"

#include <algorithm>
#include <string>

namespace eisph {

/// A particle scheme and how it steps.
struct Method {
  std::string scheme;
  Stepping stepping;
};

inline const Method kMethods[] = {
    {"eisph", Stepping::Symplectic},     {"eisph", Stepping::Thesis},
    {"isph", Stepping::Symplectic},      {"isph", Stepping::Thesis},
    {"wcsph", Stepping::Symplectic},     {"wcsph", Stepping::PredictorCorrector},
    {"delta_sph", Stepping::Symplectic}, {"delta_sph", Stepping::RungeKutta},
};

/// Name of a method for the names of tests.
inline std::string method_name(const Method& method) {
  const char* steppings[] = {"Symplectic", "Thesis", "PredictorCorrector", "RungeKutta"};
  std::string name = method.scheme;
  name.erase(std::remove(name.begin(), name.end(), '_'), name.end());
  return name + steppings[static_cast<int>(method.stepping)];
}

/// The scene with this method and the settings that its scene file would get by default.
inline Scene with_method(Scene scene, const Method& method) {
  SchemeSettings& scheme = scene.scheme;
  scheme.name = method.scheme;
  scheme.stepping = method.stepping;
  if (method.stepping == Stepping::Thesis) scheme.phi = 0.06;
  if (scheme.projects_velocity()) {
    scheme.source_factor = 1.0;
    scheme.viscous_source = true;
  }
  scheme.sound_speed = 10.0 * scene.expected_speed();
  scheme.courant = method.stepping == Stepping::RungeKutta ? 1.25 : 0.25;
  return scene;
}

/// One period of Taylor-Green vortices of speed 1 m/s in a box of side 1 m between planes of symmetry.
inline Scene taylor_green(double spacing, double viscosity) {
  Scene scene = tank(2, Vec3d(1.0, 0.0, 1.0), spacing, box(Vec3d::Zero(), Vec3d(1.0, 0.0, 1.0)));
  scene.gravity.setZero();
  scene.faces.fill({FaceKind::Symmetry, 1.0});
  scene.fluid[0].vortex_speed = 1.0;
  scene.kernel = KernelKind::CubicSpline;
  scene.smoothing_ratio = 2.0;
  scene.jitter = 0.2;
  scene.kinematic_viscosity = viscosity;
  scene.artificial_viscosity = 0.0;
  scene.scheme.clamp_pressure = false;
  scene.scheme.free_surface_threshold = 0.0;
  scene.scheme.shifting = 1.0;
  return scene;
}

inline double kinetic_energy(const Snapshot& snapshot) {
  double sum = 0.0;
  for (const Vec3f& velocity : snapshot.velocity) sum += 0.5 * velocity.squaredNorm();
  return sum * snapshot.particle_mass;
}

}  // namespace eisph
