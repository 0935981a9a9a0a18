#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "probe/leading_edge.hpp"

namespace eisph {

/// Position of the wave front (m, on the probe's axis) in the probe's direction and inside its band: the
/// farthest centre of a particle, and the farthest of the bulk, as in leading_edge. Not-a-number where no
/// particle qualifies.
[[nodiscard]] LeadingEdge front_position(const FrontProbe& probe, const Snapshot& snapshot,
                                         double bulk_number_density = kBulkNumberDensity);

}  // namespace eisph
