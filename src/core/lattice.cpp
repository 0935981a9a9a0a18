#include "core/lattice.hpp"

#include "core/error.hpp"
#include "core/fluid_fit.hpp"
#include "core/partial_cells.hpp"
#include "core/water_volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include <fmt/format.h>

namespace eisph {

namespace {

/// Fraction of the spacing within which a centre counts as on a surface.
constexpr double kTolerance = 1e-9;
/// Layers, over the whole of a piece, within which they are those of the domain's lattice.
constexpr double kOnLattice = 1e-6;
constexpr double kLargestIndex = 9e15;

/// Lattice points of one axis, from `first` to `last` inclusive; doubles, as a bad scene may ask for any
/// number.
struct AxisPoints {
  double first = 0.0;
  double last = 0.0;
  double origin = 0.0;  ///< m, where point 0 lies
  double step = 0.0;    ///< m
  [[nodiscard]] double count() const { return std::max(0.0, last - first + 1.0); }
};

using LatticeBlock = std::array<AxisPoints, 3>;

double count(const LatticeBlock& block) { return block[0].count() * block[1].count() * block[2].count(); }

/// The points of the domain's lattice, of the given spacing, between two corners.
LatticeBlock lattice_block(const Scene& scene, const Vec3d& lower, const Vec3d& upper, double spacing) {
  LatticeBlock block;
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.dimension == 2 && axis == 1) continue;
    const auto index = [&](double coordinate) {
      return (coordinate - scene.domain_min[axis]) / spacing - 0.5;
    };
    AxisPoints& points = block[static_cast<std::size_t>(axis)];
    points.first = std::max(0.0, std::ceil(index(lower[axis]) - kTolerance));
    const double last_in_domain = std::ceil(index(scene.domain_max[axis]) - kTolerance) - 1.0;
    points.last = std::min(last_in_domain, std::floor(index(upper[axis]) + kTolerance));
    points.origin = scene.domain_min[axis] + 0.5 * spacing;
    points.step = spacing;
  }
  return block;
}

LatticeBlock lattice_block(const Scene& scene, const Shape& shape, double spacing) {
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  return lattice_block(scene, lower, upper, spacing);
}

/// The points of a piece. Where its layers are those of the domain's lattice they are so to the last bit.
LatticeBlock lattice_block(const Scene& scene, const FluidPiece& piece) {
  const double dx = scene.particle_spacing;
  LatticeBlock block = lattice_block(scene, piece.lower, piece.upper, dx);
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.dimension == 2 && axis == 1) continue;
    AxisPoints& points = block[static_cast<std::size_t>(axis)];
    const double layers = piece.layers[static_cast<std::size_t>(axis)];
    const double shift = (piece.lower[axis] - scene.domain_min[axis]) / dx - points.first;
    if (layers == points.count() && std::abs(piece.spacing(axis) / dx - 1.0) * layers <= kOnLattice &&
        std::abs(shift) <= kOnLattice) {
      continue;
    }
    points = {0.0, layers - 1.0, piece.lower[axis] + 0.5 * piece.spacing(axis), piece.spacing(axis)};
  }
  return block;
}

/// Walks the centres of a block, x fastest, until `visit` returns false; returns whether it went to the end.
template <class Visit>
bool walk(const Scene& scene, const LatticeBlock& block, const Visit& visit) {
  std::array<std::int64_t, 3> first{};
  std::array<std::int64_t, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<std::int64_t>(std::min(block[axis].first, kLargestIndex));
    last[axis] = static_cast<std::int64_t>(std::clamp(block[axis].last, -1.0, kLargestIndex));
  }
  const auto coordinate = [&](std::size_t axis, std::int64_t index) {
    return block[axis].origin + static_cast<double>(index) * block[axis].step;
  };
  Vec3d point = Vec3d::Zero();
  for (std::int64_t k = first[2]; k <= last[2]; ++k) {
    point.z() = coordinate(2, k);
    for (std::int64_t j = first[1]; j <= last[1]; ++j) {
      if (scene.dimension == 3) point.y() = coordinate(1, j);
      for (std::int64_t i = first[0]; i <= last[0]; ++i) {
        point.x() = coordinate(0, i);
        if (!visit(point)) return false;
      }
    }
  }
  return true;
}

/// Calls visit(point, velocity) for every centre of the domain's lattice in the water.
template <class Visit>
void visit_aligned(const Scene& scene, const Visit& visit) {
  const double tolerance = kTolerance * scene.particle_spacing;
  const auto inside = [&](const FluidRegion& region, const Vec3d& point) {
    return region.shape.signed_distance(point, scene.dimension) <= tolerance;
  };
  for (std::size_t r = 0; r < scene.fluid.size(); ++r) {
    if (scene.fluid[r].cut) continue;
    const LatticeBlock block = lattice_block(scene, scene.fluid[r].shape, scene.particle_spacing);
    const bool went_on = walk(scene, block, [&](const Vec3d& point) {
      if (!inside(scene.fluid[r], point)) return true;
      Vec3d velocity = scene.fluid[r].velocity_at(point);
      for (std::size_t other = 0; other < scene.fluid.size(); ++other) {
        const FluidRegion& region = scene.fluid[other];
        if (other == r || !inside(region, point)) continue;
        if (region.cut || other < r) return true;  // taken out, or already there from an earlier region
        velocity = region.velocity_at(point);
      }
      return static_cast<bool>(visit(point, velocity));
    });
    if (!went_on) return;
  }
}

/// The last added region that contains a point gives its velocity; `otherwise` where none does.
Vec3d initial_velocity(const Scene& scene, const Vec3d& point, std::size_t otherwise) {
  const double tolerance = kTolerance * scene.particle_spacing;
  std::size_t owner = otherwise;
  for (std::size_t r = 0; r < scene.fluid.size(); ++r) {
    if (scene.fluid[r].cut) continue;
    if (scene.fluid[r].shape.signed_distance(point, scene.dimension) <= tolerance) owner = r;
  }
  return scene.fluid[owner].velocity_at(point);
}

/// Of the lattice of round and rotated regions, m: its cells have the volume of the pieces'.
double loose_spacing(const Scene& scene, const FluidFit& fit) {
  return fit.pieces.empty() ? scene.particle_spacing : std::pow(fit.cell_volume, 1.0 / scene.dimension);
}

Vec3d cell_edges(const LatticeBlock& block) { return {block[0].step, block[1].step, block[2].step}; }

/// Calls visit(point, velocity) for the particles of the pieces, then for those of round and rotated regions.
template <class Visit>
void visit_fitted(const Scene& scene, const FluidFit& fit, const Visit& visit) {
  PartialCells cells(scene, fit);
  for (const FluidPiece& piece : fit.pieces) {
    const LatticeBlock block = lattice_block(scene, piece);
    const Vec3d edges = cell_edges(block);
    const bool went_on = walk(scene, block, [&](const Vec3d& centre) {
      const std::optional<Vec3d> place = cells.in_piece(centre, edges);
      return !place || static_cast<bool>(visit(*place, initial_velocity(scene, centre, piece.region)));
    });
    if (!went_on) return;
  }
  for (const std::size_t r : fit.loose) {
    const double spacing = loose_spacing(scene, fit);
    const LatticeBlock block = lattice_block(scene, scene.fluid[r].shape, spacing);
    const Vec3d edges = cell_edges(block);
    const bool went_on = walk(scene, block, [&](const Vec3d& centre) {
      const std::optional<Vec3d> place = cells.in_region(r, centre, edges);
      return !place || static_cast<bool>(visit(*place, initial_velocity(scene, centre, r)));
    });
    if (!went_on) return;
  }
}

/// Calls visit(point, velocity) for every particle, before jitter.
template <class Visit>
void visit_centres(const Scene& scene, const Visit& visit) {
  const FluidFit fit = fit_fluid(scene);
  if (fit.aligned) {
    visit_aligned(scene, visit);
  } else {
    visit_fitted(scene, fit, visit);
  }
}

/// Uniform in [-1, 1), the same on every standard library.
double symmetric_uniform(std::mt19937_64& generator) {
  return std::ldexp(static_cast<double>(generator() >> 11U), -52) - 1.0;
}

Vec3d jittered(const Scene& scene, const Vec3d& centre, std::mt19937_64& generator) {
  Vec3d point = centre;
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.dimension == 2 && axis == 1) continue;
    const double displacement = scene.jitter * scene.particle_spacing * symmetric_uniform(generator);
    point[axis] += displacement;
    if (point[axis] <= scene.domain_min[axis] || point[axis] >= scene.domain_max[axis]) {
      point[axis] = centre[axis] - displacement;
    }
  }
  return point;
}

}  // namespace

void visit_fluid_lattice(const Scene& scene, const FluidVisitor& visit) {
  if (scene.jitter <= 0.0) return visit_centres(scene, visit);
  std::mt19937_64 generator(scene.jitter_seed);
  visit_centres(scene, [&](const Vec3d& centre, const Vec3d& velocity) {
    return visit(jittered(scene, centre, generator), velocity);
  });
}

void add_jitter(const Scene& scene, std::vector<Vec3d>& positions) {
  if (scene.jitter <= 0.0) return;
  std::mt19937_64 generator(scene.jitter_seed);
  for (Vec3d& position : positions) position = jittered(scene, position, generator);
}

double fluid_particle_bound(const Scene& scene) {
  const FluidFit fit = fit_fluid(scene);
  double bound = 0.0;
  if (fit.aligned) {
    for (const FluidRegion& region : scene.fluid) {
      if (!region.cut) bound += count(lattice_block(scene, region.shape, scene.particle_spacing));
    }
    return bound;
  }
  for (const FluidPiece& piece : fit.pieces) bound += count(lattice_block(scene, piece));
  for (const std::size_t r : fit.loose) {
    bound += count(lattice_block(scene, scene.fluid[r].shape, loose_spacing(scene, fit)));
  }
  return bound;
}

std::uint64_t count_fluid_particles(const Scene& scene, std::uint64_t limit) {
  const double bound = fluid_particle_bound(scene);
  if (!(bound <= kMaximumFluidParticles)) {
    throw InputError(
        fmt::format("a particle spacing of {} m puts {:.3g} lattice points into the water; at most {:.3g} "
                    "particles can be numbered",
                    scene.particle_spacing, bound, kMaximumFluidParticles));
  }
  std::uint64_t count = 0;
  visit_centres(scene, [&](const Vec3d&, const Vec3d&) { return ++count <= limit; });
  return count;
}

FluidLattice fluid_lattice(const Scene& scene) {
  FluidLattice lattice;
  const std::uint64_t count = count_fluid_particles(scene);
  lattice.position.reserve(count);
  lattice.velocity.reserve(count);
  visit_fluid_lattice(scene, [&](const Vec3d& position, const Vec3d& velocity) {
    lattice.position.push_back(position);
    lattice.velocity.push_back(velocity);
    return true;
  });
  lattice.particle_volume = std::pow(scene.particle_spacing, scene.dimension);
  const FluidFit fit = fit_fluid(scene);
  if (fit.aligned || lattice.position.empty()) return lattice;
  double volume = water_volume(scene);
  for (const FluidPiece& piece : fit.thin) volume -= piece_volume(scene, piece);
  lattice.particle_volume = volume / static_cast<double>(lattice.position.size());
  return lattice;
}

}  // namespace eisph
