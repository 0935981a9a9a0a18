#include "core/lattice.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>

namespace eisph {

namespace {

/// Fraction of the spacing within which a centre counts as on a surface.
constexpr double kTolerance = 1e-9;
constexpr double kLargestIndex = 9e15;

/// Lattice points of one axis, from `first` to `last` inclusive; doubles, as a bad scene may ask for any
/// number.
struct AxisPoints {
  double first = 0.0;
  double last = 0.0;
  [[nodiscard]] double count() const { return std::max(0.0, last - first + 1.0); }
};

using LatticeBlock = std::array<AxisPoints, 3>;

LatticeBlock lattice_block(const Scene& scene, const Shape& shape) {
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  LatticeBlock block;
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.dimension == 2 && axis == 1) continue;
    const auto index = [&](double coordinate) {
      return (coordinate - scene.domain_min[axis]) / scene.particle_spacing - 0.5;
    };
    AxisPoints& points = block[static_cast<std::size_t>(axis)];
    points.first = std::max(0.0, std::ceil(index(lower[axis]) - kTolerance));
    const double last_in_domain = std::ceil(index(scene.domain_max[axis]) - kTolerance) - 1.0;
    points.last = std::min(last_in_domain, std::floor(index(upper[axis]) + kTolerance));
  }
  return block;
}

/// Walks the centres of a block, x fastest, until `visit` returns false; returns whether it went to the end.
template <class Visit>
bool walk(const Scene& scene, const LatticeBlock& block, const Visit& visit) {
  const Vec3d origin = scene.domain_min.array() + 0.5 * scene.particle_spacing;
  std::array<std::int64_t, 3> first{};
  std::array<std::int64_t, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<std::int64_t>(std::min(block[axis].first, kLargestIndex));
    last[axis] = static_cast<std::int64_t>(std::clamp(block[axis].last, -1.0, kLargestIndex));
  }
  const auto coordinate = [&](int axis, std::int64_t index) {
    return origin[axis] + static_cast<double>(index) * scene.particle_spacing;
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

/// Calls visit(point, velocity) for every particle, before jitter.
template <class Visit>
void visit_centres(const Scene& scene, const Visit& visit) {
  const double tolerance = kTolerance * scene.particle_spacing;
  const auto inside = [&](const FluidRegion& region, const Vec3d& point) {
    return region.shape.signed_distance(point, scene.dimension) <= tolerance;
  };
  for (std::size_t r = 0; r < scene.fluid.size(); ++r) {
    if (scene.fluid[r].cut) continue;
    const bool went_on = walk(scene, lattice_block(scene, scene.fluid[r].shape), [&](const Vec3d& point) {
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

double fluid_particle_bound(const Scene& scene) {
  double bound = 0.0;
  for (const FluidRegion& region : scene.fluid) {
    if (region.cut) continue;
    const LatticeBlock block = lattice_block(scene, region.shape);
    bound += block[0].count() * block[1].count() * block[2].count();
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
  return lattice;
}

}  // namespace eisph
