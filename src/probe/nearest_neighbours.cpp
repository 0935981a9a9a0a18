#include "probe/nearest_neighbours.hpp"

#include "probe/fluid_cells.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace eisph {

namespace {

/// First reach of the search, particle spacings: a little more than the distance on a lattice, so that few
/// particles but those at the surface and in spray are searched for again.
constexpr double kFirstReach = 1.1;

/// Square of the distance from particle k to the nearest other in the box about it, m^2; infinite without
/// one.
double nearest_squared(const FluidCells& cells, std::size_t k, const Vec3f& at, double reach, bool flat) {
  double least = std::numeric_limits<double>::infinity();
  const Vec3d centre = at.cast<double>();
  cells.visit_near(centre, reach, [&](std::size_t other, const Vec3f& position) {
    Vec3d offset = position.cast<double>() - centre;
    if (flat) offset.y() = 0.0;
    const double squared = offset.squaredNorm();
    if (squared < least && other != k) least = squared;
  });
  return least;
}

}  // namespace

NeighbourDistances neighbour_distances(const Snapshot& snapshot) {
  const double dx = snapshot.particle_spacing;
  const double first = kFirstReach * dx;
  const double farthest = kIsolationDistance * dx;
  const bool flat = snapshot.dimension == 2;
  const FluidCells cells(snapshot, first);

  NeighbourDistances result;
  std::size_t paired = 0;
  std::vector<double> nearest;  // over dx
  nearest.reserve(snapshot.size());
  cells.visit_all([&](std::size_t k, const Vec3f& position) {
    double squared = nearest_squared(cells, k, position, first, flat);
    if (squared > first * first) squared = nearest_squared(cells, k, position, farthest, flat);
    const double distance = std::sqrt(squared) / dx;
    if (distance <= kPairDistance) ++paired;
    if (distance > kIsolationDistance) ++result.isolated_particles;
    nearest.push_back(std::min(distance, kIsolationDistance));
  });
  result.particles = nearest.size();
  if (nearest.empty()) return result;
  const auto count = static_cast<double>(nearest.size());
  result.paired_fraction = static_cast<double>(paired) / count;
  result.isolated_fraction = static_cast<double>(result.isolated_particles) / count;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.05 * count));
  std::nth_element(nearest.begin(), nearest.begin() + (rank - 1), nearest.end());
  result.nearest_distance_p5 = nearest[static_cast<std::size_t>(rank - 1)];
  return result;
}

void NeighbourHistory::add(const NeighbourDistances& distances) {
  worst.particles = std::max(worst.particles, distances.particles);
  worst.paired_fraction = std::max(worst.paired_fraction, distances.paired_fraction);
  worst.nearest_distance_p5 = std::fmin(worst.nearest_distance_p5, distances.nearest_distance_p5);
  worst.isolated_particles = std::max(worst.isolated_particles, distances.isolated_particles);
  worst.isolated_fraction = std::max(worst.isolated_fraction, distances.isolated_fraction);
  last = distances;
}

}  // namespace eisph
