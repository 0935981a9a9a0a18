#pragma once

#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace eisph::synthetic {

/// A state that looks like a dam break, made by formula: no simulation stands behind it.
struct State {
  Scene scene;
  Snapshot snapshot;
  DepthGrid depth;
};

inline Obstacle box(const char* name, const Vec3d& lower, const Vec3d& upper, double rotation = 0.0) {
  Obstacle obstacle;
  obstacle.name = name;
  obstacle.shape.min = lower;
  obstacle.shape.max = upper;
  obstacle.shape.rotation_z = rotation;
  return obstacle;
}

/// Tank of 2.6 x 1.2 m with a dam, a 0.3 m breach and an obstacle (a half of it with a symmetry plane at
/// y = 0.6 m if `half`). `spacing` in metres.
inline Scene tank_scene(double spacing, bool half = false) {
  Scene scene;
  scene.name = "synthetic_tank";
  scene.title = "Synthetic tank with a breached dam";
  scene.source_file = "synthetic.toml";
  scene.particle_spacing = spacing;
  scene.reference_depth = 0.15;
  scene.domain_max = Vec3d(2.6, half ? 0.6 : 1.2, 1.0);
  scene.faces[kZMax].kind = FaceKind::Open;
  if (half) scene.faces[kYMax].kind = FaceKind::Symmetry;
  scene.obstacles.push_back(box("dam_right", {0.8, 0.0, 0.0}, {0.825, 0.45, 0.2}));
  if (!half) scene.obstacles.push_back(box("dam_left", {0.8, 0.75, 0.0}, {0.825, 1.2, 0.2}));
  scene.obstacles.push_back(box("obstacle", {1.425, 0.45, 0.0}, {1.575, 0.75, 0.25}));
  return scene;
}

/// Depth of the synthetic wave at time 0.4 s, metres; symmetric about y = 0.6 m.
inline double wave_depth(double x, double y) {
  const double across = std::abs(y - 0.6);
  if (x < 0.8) return 0.15 - 0.05 * std::exp(-(std::pow(x - 0.8, 2) + across * across) / 0.05);
  if (x < 0.825 && across > 0.15) return 0.0;
  const double spread = 0.12 + 0.55 * (x - 0.8);
  const double front = 2.15 - 1.2 * across * across;
  if (across > spread || x > front) return 0.0;
  const double jump = 0.06 * std::exp(-std::pow((std::hypot(x - 1.6, across) - 0.3) / 0.05, 2));
  return 0.08 * (1.0 - 0.7 * across / spread) * std::sqrt((front - x) / 1.35) + jump;
}

inline bool inside_solid(const Scene& scene, const Vec3d& point) {
  return std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const Obstacle& obstacle) {
    return obstacle.shape.contains(point, scene.dimension);
  });
}

inline void add_particle(State& state, const Vec3d& point, const Vec3d& velocity, double pressure) {
  state.snapshot.id.emplace_back(static_cast<std::uint32_t>(state.snapshot.id.size()));
  state.snapshot.position.emplace_back(point.cast<float>());
  state.snapshot.velocity.emplace_back(velocity.cast<float>());
  state.snapshot.pressure.emplace_back(static_cast<float>(pressure));
  state.snapshot.number_density.emplace_back(1.0F);
}

inline void fill_depth(State& state, double cell_size) {
  const Scene& scene = state.scene;
  DepthGrid& grid = state.depth;
  grid.time = state.snapshot.time;
  grid.cell_size = cell_size;
  const Vec3d size = (scene.domain_max - scene.domain_min) / cell_size;
  grid.columns = static_cast<std::size_t>(std::lround(size.x()));
  grid.rows = scene.dimension == 2 ? 1 : static_cast<std::size_t>(std::lround(size.y()));
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const double x = (static_cast<double>(i) + 0.5) * cell_size;
      const double y = scene.dimension == 2 ? 0.6 : (static_cast<double>(j) + 0.5) * cell_size;
      const bool solid = scene.dimension == 3 && inside_solid(scene, {x, y, 0.01});
      grid.depth.push_back(solid ? 0.0F : static_cast<float>(wave_depth(x, y)));
    }
  }
}

inline void fill_particles(State& state) {
  const Scene& scene = state.scene;
  const double spacing = scene.particle_spacing;
  Snapshot& snapshot = state.snapshot;
  snapshot.time = 0.4;
  snapshot.dimension = scene.dimension;
  snapshot.particle_spacing = spacing;
  snapshot.smoothing_length = scene.smoothing_length();
  snapshot.reference_density = scene.density;
  snapshot.objects = std::make_shared<ObjectParticles>();
  const bool flat = scene.dimension == 2;
  const int rows = flat ? 1 : static_cast<int>(std::lround(scene.domain_max.y() / spacing));
  const int columns = static_cast<int>(std::lround(scene.domain_max.x() / spacing));
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double x = (i + 0.5) * spacing;
      const double y = flat ? 0.6 : (j + 0.5) * spacing;
      const double depth = wave_depth(x, y);
      for (int k = 0; (k + 0.5) * spacing < depth; ++k) {
        const Vec3d point(x, flat ? 0.0 : y, (k + 0.5) * spacing);
        if (!flat && inside_solid(scene, point)) continue;
        const double flow = std::clamp((x - 0.4) / 0.9, 0.0, 1.0);
        const Vec3d velocity(2.0 * flow, flat ? 0.0 : 1.5 * flow * (y - 0.6), -0.6 * flow * (1.0 - flow));
        add_particle(state, point, velocity, scene.density * 9.81 * (depth - point.z()));
      }
    }
  }
}

inline State make_state(Scene scene, double depth_cell_size) {
  State state;
  state.scene = std::move(scene);
  fill_particles(state);
  fill_depth(state, depth_cell_size);
  return state;
}

inline State tank(double spacing, bool half = false) { return make_state(tank_scene(spacing, half), 0.015); }

/// A channel of 2.6 m in the vertical plane with a sill.
inline State channel(double spacing) {
  Scene scene = tank_scene(spacing);
  scene.title = "Synthetic channel";
  scene.dimension = 2;
  scene.domain_max = Vec3d(2.6, 0.0, 0.6);
  scene.obstacles = {box("sill", {2.2, 0.0, 0.0}, {2.3, 0.0, 0.08})};
  return make_state(std::move(scene), 0.015);
}

}  // namespace eisph::synthetic
