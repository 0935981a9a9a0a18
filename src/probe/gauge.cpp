#include "probe/gauge.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

// Single-precision coordinates must not decide whether a particle on the edge of the column belongs to it.
constexpr double kEdgeTolerance = 1e-4;

}  // namespace

double water_level(const Gauge& gauge, const Scene& scene, const Snapshot& snapshot) {
  const double side = gauge.size > 0.0 ? gauge.size : 1.5 * scene.particle_spacing;
  const double half_side = (0.5 + kEdgeTolerance) * side;
  const double floor = scene.domain_min.z();
  const double height = gauge.height > 0.0 ? gauge.height : scene.domain_max.z() - floor;
  const bool check_y = scene.dimension == 3;

  double level = 0.0;
  for (const Vec3f& position : snapshot.position) {
    if (std::abs(position.x() - gauge.x) > half_side) continue;
    if (check_y && std::abs(position.y() - gauge.y) > half_side) continue;
    const double above_floor = position.z() - floor;
    if (above_floor <= height + kEdgeTolerance * side) level = std::max(level, above_floor);
  }
  return level;
}

}  // namespace eisph
