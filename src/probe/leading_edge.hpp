#pragma once

#include "core/snapshot.hpp"
#include "probe/spray.hpp"

namespace eisph {

/// Position of the wave front along +x, metres in the coordinates of the scene: centres of particles, nothing
/// added. Not-a-number where no particle qualifies.
struct LeadingEdge {
  double front = 0.0;       ///< largest x of any fluid particle
  double bulk_front = 0.0;  ///< the same of the bulk: number density of at least kBulkNumberDensity
};

[[nodiscard]] LeadingEdge leading_edge(const Snapshot& snapshot,
                                       double bulk_number_density = kBulkNumberDensity);

}  // namespace eisph
