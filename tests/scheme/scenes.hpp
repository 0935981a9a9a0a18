#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "scheme/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace eisph {

inline constexpr double kGravity = 9.81;
inline constexpr double kDensity = 1000.0;

inline Shape box(const Vec3d& min, const Vec3d& max, double rotation_z = 0.0) {
  Shape shape;
  shape.min = min;
  shape.max = max;
  shape.rotation_z = rotation_z;
  return shape;
}

inline Shape cylinder(const Vec3d& base, double radius, double height) {
  Shape shape;
  shape.kind = ShapeKind::Cylinder;
  shape.centre = base;
  shape.radius = radius;
  shape.height = height;
  return shape;
}

/// A tank with its lower corner at the origin and one block of water in it.
inline Scene tank(int dimension, const Vec3d& size, double spacing, const Shape& water) {
  Scene scene;
  scene.name = "tank";
  scene.dimension = dimension;
  scene.particle_spacing = spacing;
  scene.domain_max = size;
  FluidRegion region;
  region.shape = water;
  scene.fluid.push_back(region);
  scene.reference_depth = water.max.z() - water.min.z();
  scene.end_time = 10.0;
  return scene;
}

/// Gives a scene the h / dx and the free-surface threshold that a scene file of its kernel and dimension
/// gets.
inline void take_kernel_defaults(Scene& scene) {
  scene.smoothing_ratio = default_smoothing_ratio(scene.kernel, scene.dimension);
  scene.scheme.free_surface_threshold = default_free_surface_threshold(scene.kernel, scene.dimension);
}

/// Water at rest all over the floor of a tank of 0.3 m, in the plane.
inline Scene still_water_2d(double depth = 0.15) {
  return tank(2, Vec3d(0.3, 0.0, depth + 0.15), 0.01, box(Vec3d::Zero(), Vec3d(0.3, 0.0, depth)));
}

/// A column at the left end that runs along a tank.
inline Scene dam_break_2d(double spacing = 0.01) {
  return tank(2, Vec3d(0.6, 0.0, 0.4), spacing, box(Vec3d::Zero(), Vec3d(0.15, 0.0, 0.2)));
}

/// A small dam break onto an obstacle in the middle of the channel.
inline Scene dam_break_3d(const Shape& obstacle, double spacing = 0.0125) {
  Scene scene = tank(3, Vec3d(0.6, 0.3, 0.3), spacing, box(Vec3d::Zero(), Vec3d(0.2, 0.3, 0.15)));
  scene.obstacles.push_back({"obstacle", obstacle});
  return scene;
}

/// Makes the stepping that of the thesis, with its step.
inline void use_thesis_stepping(Scene& scene) {
  scene.scheme.stepping = Stepping::Thesis;
  scene.scheme.source_factor = 1.0;
  scene.scheme.phi = 0.06;
}

inline void use_fixed_step(Scene& scene, double time_step) {
  scene.scheme.time_step_mode = TimeStepMode::Fixed;
  scene.scheme.time_step = time_step;
}

inline std::unique_ptr<Simulation> start(const Scene& scene, int threads = 1) {
  auto simulation = Simulation::create(scene, threads);
  simulation->initialise();
  return simulation;
}

inline void run_until(Simulation& simulation, double time) {
  while (simulation.time() < time) simulation.step(time);
}

inline void take_steps(Simulation& simulation, int steps, double until = 1e3) {
  for (int k = 0; k < steps; ++k) simulation.step(until);
}

inline bool is_finite(const Snapshot& snapshot) {
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    if (!snapshot.position[k].allFinite() || !snapshot.velocity[k].allFinite()) return false;
    if (!std::isfinite(snapshot.pressure[k]) || !std::isfinite(snapshot.number_density[k])) return false;
  }
  return true;
}

/// Whether every particle lies between the faces of the domain; 2D ignores y.
inline bool is_inside(const Snapshot& snapshot, const Scene& scene) {
  for (const Vec3f& position : snapshot.position) {
    for (int axis = 0; axis < 3; ++axis) {
      if (scene.dimension == 2 && axis == 1) continue;
      // Snapshots are in single precision.
      if (position[axis] < scene.domain_min[axis] - 1e-6) return false;
      if (position[axis] > scene.domain_max[axis] + 1e-6) return false;
    }
  }
  return true;
}

inline double largest_speed(const Snapshot& snapshot) {
  double largest = 0.0;
  for (const Vec3f& velocity : snapshot.velocity) largest = std::max<double>(largest, velocity.norm());
  return largest;
}

/// RMS difference of the pressure from the hydrostatic one below a surface at `level`, in units of
/// rho g `level`.
inline double hydrostatic_error(const Snapshot& snapshot, double level) {
  double sum = 0.0;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const double depth = std::max(0.0, level - snapshot.position[k].z());
    const double error = snapshot.pressure[k] / (kDensity * kGravity) - depth;
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(snapshot.size())) / level;
}

}  // namespace eisph
