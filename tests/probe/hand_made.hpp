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

}  // namespace eisph
