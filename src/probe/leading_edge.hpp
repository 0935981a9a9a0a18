#pragma once

#include "core/snapshot.hpp"

namespace eisph {

/// Position of the wave front along +x, metres in the coordinates of the scene: centres of particles, nothing
/// added. Not-a-number where no particle qualifies.
struct LeadingEdge {
  double front = 0.0;       ///< largest x of any fluid particle
  double bulk_front = 0.0;  ///< the same without loose spray
};

/// Least number density of a particle that is part of the bulk. With h = 1.32 dx a lone particle has 0.14 in
/// 3D and 0.26 in 2D, and 0.20 and 0.38 on a floor that mirrors it; the tip of a layer one particle thick on
/// such a floor has 0.58 and 0.57.
inline constexpr double kBulkNumberDensity = 0.5;

[[nodiscard]] LeadingEdge leading_edge(const Snapshot& snapshot,
                                       double bulk_number_density = kBulkNumberDensity);

}  // namespace eisph
