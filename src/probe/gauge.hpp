#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"

namespace eisph {

/// Water level at a gauge, metres above the floor (scene.domain_min.z): the height of the centre of the
/// highest fluid particle in a square column of side gauge.size about (gauge.x, gauge.y), edges included, and
/// up to gauge.height. Zero if the column is empty. In two dimensions the column is an interval in x. A size
/// of zero means 1.5 particle spacings, a height of zero the domain's.
[[nodiscard]] double water_level(const Gauge& gauge, const Scene& scene, const Snapshot& snapshot);

}  // namespace eisph
