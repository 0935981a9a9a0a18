#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace eisph {

/// A tank of 1 x 0.5 x 0.5 m (3D) or 1 x 0.5 m (2D) with its floor at z = 0.1 m, water at dx = 0.02 m.
inline Scene hand_made_scene(int dimension) {
  Scene scene;
  scene.name = "hand_made";
  scene.source_file = "hand_made.toml";
  scene.dimension = dimension;
  scene.particle_spacing = 0.02;
  scene.domain_min = Vec3d(0.0, 0.0, 0.1);
  scene.domain_max = Vec3d(1.0, dimension == 2 ? 0.0 : 0.5, 0.6);
  return scene;
}

/// Particles at rest at the given positions, without pressure and with a number density of 1.
inline Snapshot hand_made_snapshot(const Scene& scene, std::vector<Vec3f> positions, double time = 0.0) {
  Snapshot snapshot;
  const double dx = scene.particle_spacing;
  snapshot.time = time;
  snapshot.dimension = scene.dimension;
  snapshot.particle_spacing = dx;
  snapshot.smoothing_length = scene.smoothing_length();
  snapshot.reference_density = scene.density;
  snapshot.particle_mass = scene.density * (scene.dimension == 2 ? dx * dx : dx * dx * dx);
  for (std::size_t k = 0; k < positions.size(); ++k) snapshot.id.push_back(static_cast<std::uint32_t>(k));
  snapshot.velocity.assign(positions.size(), Vec3f::Zero());
  snapshot.pressure.assign(positions.size(), 0.0F);
  snapshot.number_density.assign(positions.size(), 1.0F);
  snapshot.position = std::move(positions);
  snapshot.objects = std::make_shared<const ObjectParticles>();
  return snapshot;
}

/// Lattice of particles that fills the box from the lower corner of the domain to `size` beyond it.
inline std::vector<Vec3f> lattice(const Scene& scene, const Vec3d& size) {
  const double dx = scene.particle_spacing;
  const auto count = [dx](double length) { return static_cast<int>(std::lround(length / dx)); };
  const int rows = scene.dimension == 2 ? 1 : count(size.y());
  std::vector<Vec3f> positions;
  for (int k = 0; k < count(size.z()); ++k) {
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < count(size.x()); ++i) {
        Vec3d position = scene.domain_min + dx * Vec3d(i + 0.5, j + 0.5, k + 0.5);
        if (scene.dimension == 2) position.y() = 0.0;
        positions.emplace_back(position.cast<float>());
      }
    }
  }
  return positions;
}

/// Gives the particles the pressure of water at rest with its surface at z = `level` (m).
inline void make_hydrostatic(Snapshot& snapshot, const Scene& scene, double level) {
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const double depth = level - static_cast<double>(snapshot.position[k].z());
    snapshot.pressure[k] = static_cast<float>(scene.density * scene.gravity.norm() * depth);
  }
}

/// Water at rest that is `size` (m) large from the lower corner of the domain on, with its pressure, around
/// the solids of the scene.
inline Snapshot still_water(const Scene& scene, const Vec3d& size) {
  std::vector<Vec3f> positions = lattice(scene, size);
  std::erase_if(positions, [&](const Vec3f& position) {
    const auto contains = [&](const Shape& shape) {
      return shape.signed_distance(position.cast<double>(), scene.dimension) < -1e-6;
    };
    bool inside = false;
    for (const Obstacle& obstacle : scene.obstacles) inside = inside || contains(obstacle.shape);
    for (const Gate& gate : scene.gates) inside = inside || contains(gate.shape);
    return inside;
  });
  Snapshot snapshot = hand_made_snapshot(scene, std::move(positions));
  make_hydrostatic(snapshot, scene, scene.domain_min.z() + size.z());
  return snapshot;
}

inline Shape box(const Vec3d& min, const Vec3d& max, double rotation_z = 0.0) {
  Shape shape;
  shape.min = min;
  shape.max = max;
  shape.rotation_z = rotation_z;
  return shape;
}

/// Displaces every coordinate of the particles by up to `amplitude` (m), always in the same way.
inline void shake(Snapshot& snapshot, double amplitude) {
  std::uint32_t state = 12345;
  for (Vec3f& position : snapshot.position) {
    for (int axis = 0; axis < 3; ++axis) {
      state = state * 1664525U + 1013904223U;
      if (snapshot.dimension == 2 && axis == 1) continue;
      position[axis] += static_cast<float>(amplitude * (static_cast<double>(state >> 8U) / (1 << 23) - 1.0));
    }
  }
}

}  // namespace eisph
