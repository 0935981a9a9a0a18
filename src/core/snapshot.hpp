#pragma once

#include "core/column_field.hpp"
#include "core/shape.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace eisph {

enum class ParticleKind : std::uint8_t { Fluid = 0, Object = 1 };

/// Object particles at one time; shared between snapshots while nothing moves.
struct ObjectParticles {
  std::vector<Vec3f> position;  ///< m
  std::vector<float> pressure;  ///< Pa
  float spacing = 0.0F;         ///< m, largest distance of two neighbours in the lattice
};

/// The state at one instant: what probes, renderer and writers see of a simulation. Immutable once published.
/// Arrays have one entry per fluid particle, in the order of `id`, so that row k is the same particle in
/// every snapshot as long as none has left the domain.
struct Snapshot {
  double time = 0.0;               ///< s
  std::uint64_t step = 0;          ///< steps taken
  double time_step = 0.0;          ///< s, of the last step
  int dimension = 3;               ///< in 2D y is zero
  double particle_spacing = 0.0;   ///< m
  double smoothing_length = 0.0;   ///< m
  double particle_mass = 0.0;      ///< kg (kg/m in 2D)
  double reference_density = 0.0;  ///< kg/m^3

  std::uint64_t penetrations = 0;    ///< so far: particles put back inside a wall or a solid
  std::uint64_t lost_particles = 0;  ///< so far: neither in the domain nor taken out through an open face

  std::vector<std::uint32_t> id;
  std::vector<Vec3f> position;        ///< m
  std::vector<Vec3f> velocity;        ///< m/s
  std::vector<float> pressure;        ///< Pa
  std::vector<float> number_density;  ///< normalised by the lattice's: 1 inside, less near the free surface

  std::shared_ptr<const ObjectParticles> objects;  ///< never null
  std::shared_ptr<const ColumnField> columns;      ///< of a depth-averaged model; null for particles

  [[nodiscard]] std::size_t size() const { return position.size(); }
};

}  // namespace eisph
