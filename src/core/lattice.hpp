#pragma once

#include "core/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace eisph {

/// The water at t = 0: centres (m) and velocities (m/s) of the particles.
struct FluidLattice {
  std::vector<Vec3d> position;
  std::vector<Vec3d> velocity;
  double particle_volume =
      0.0;  ///< m^3 (m^2 in 2D), of every particle: water_volume, less thin pieces, over their number
};

/// Most fluid particles a run can number.
inline constexpr double kMaximumFluidParticles = 4.0e9;

/// Where all regions are upright boxes that begin and end on the lattice domain_min + i dx, centres lie on
/// domain_min + (i + 1/2) dx (y = 0 in two dimensions), inside an added region and in no cut one. Elsewhere
/// every piece of fit_fluid has a lattice of its own, stretched so that it lies half a layer from its faces;
/// of cells that a round or rotated surface divides near a solid as many are kept as their parts add up to,
/// and without a solid those whose centres are in the water. The last added region that contains a centre
/// gives the velocity. With jitter every component is displaced by up to jitter * dx.
[[nodiscard]] FluidLattice fluid_lattice(const Scene& scene);

/// Displaces the places of a lattice without jitter (m) by that of the scene.
void add_jitter(const Scene& scene, std::vector<Vec3d>& positions);

/// Receives position (m) and velocity (m/s) of one particle; returns false to stop.
using FluidVisitor = std::function<bool(const Vec3d&, const Vec3d&)>;
/// Calls `visit` for every particle of fluid_lattice, in the same order, without storing them.
void visit_fluid_lattice(const Scene& scene, const FluidVisitor& visit);

/// Lattice points in the bounds of all added regions: never less than the number of particles, and found
/// without walking the lattice.
[[nodiscard]] double fluid_particle_bound(const Scene& scene);

/// Number of fluid particles; counting stops at `limit` + 1. Throws InputError for a lattice beyond
/// kMaximumFluidParticles.
[[nodiscard]] std::uint64_t count_fluid_particles(
    const Scene& scene, std::uint64_t limit = std::numeric_limits<std::uint64_t>::max() - 1);

/// Particles of one solid: centres (m) and volumes (m^3; m^2 in two dimensions).
struct SolidLattice {
  std::vector<Vec3d> position;
  std::vector<double> volume;
  double spacing = 0.0;  ///< m, largest distance of two neighbours in a layer or of two layers
};

/// Object particles in layers parallel to the surface, the first at half a layer, `spacing` or a little less
/// apart, and at least two between opposite faces. Particles deeper than `depth` (m) below the surface are
/// left out: no water feels them.
[[nodiscard]] SolidLattice solid_lattice(const Shape& shape, double spacing, double depth, int dimension);

/// About how many particles solid_lattice makes, without making them.
[[nodiscard]] double solid_particle_estimate(const Shape& shape, double spacing, double depth, int dimension);

/// Where the particles of one solid are in SceneSolids.
struct SolidRange {
  std::string name;
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Object particles of a scene with the gates closed: the obstacles, then the gates, in the order of the
/// scene.
struct SceneSolids {
  std::vector<Vec3d> position;
  std::vector<double> volume;
  std::vector<SolidRange> ranges;
  double spacing = 0.0;  ///< m, the largest of the solids
};

/// Lattices of all solids down to the support radius, without particles that lie outside the domain or inside
/// an earlier solid (on its surface they are kept).
[[nodiscard]] SceneSolids scene_solids(const Scene& scene);

}  // namespace eisph
