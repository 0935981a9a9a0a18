#pragma once

#include "core/snapshot.hpp"

#include <cstddef>
#include <limits>

namespace eisph {

/// Particles nearer to each other than this have paired, in particle spacings.
inline constexpr double kPairDistance = 0.6;
/// A particle without another within this is isolated, in particle spacings.
inline constexpr double kIsolationDistance = 2.0;

/// How the fluid particles of a snapshot are spread: figures of the distance r_i from each to the nearest
/// other one, over the particle spacing dx. Images and particles of solids do not count as others.
///
/// Particles on a lattice have r = 1; below about 0.7 they have begun to clump, which the kernel does not
/// resist (pairing instability), so that two stand for one and resolution is lost. Isolated particles are
/// spray that has nothing to do with the rest of the water: at h / dx up to 2 about none of it in reach.
struct NeighbourDistances {
  std::size_t particles = 0;     ///< with a finite position
  double paired_fraction = 0.0;  ///< of the particles, with r <= kPairDistance
  /// 5th percentile of min(r, kIsolationDistance): at least 5 % of the particles have no more. Not-a-number
  /// without fluid.
  double nearest_distance_p5 = std::numeric_limits<double>::quiet_NaN();
  std::size_t isolated_particles = 0;  ///< with r > kIsolationDistance
  double isolated_fraction = 0.0;      ///< the same over all particles
};

/// Finds them by a search over cells, of the order of N. Not for snapshots with columns.
[[nodiscard]] NeighbourDistances neighbour_distances(const Snapshot& snapshot);

/// Those of a run: the worst of each figure (largest fractions and numbers, smallest distance) and the last.
struct NeighbourHistory {
  NeighbourDistances worst;
  NeighbourDistances last;

  void add(const NeighbourDistances& distances);
};

}  // namespace eisph
