#include "probe/gauge.hpp"

#include "probe/column_probes.hpp"
#include "probe/spray.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace eisph {

namespace {

// Single-precision coordinates must not decide whether a particle on the edge of the column belongs to it.
constexpr double kEdgeTolerance = 1e-4;

constexpr double kStep = 0.25;      ///< particle spacings between two looks at the water
constexpr double kAccuracy = 1e-5;  ///< particle spacings
constexpr double kFoot = 1e-3;      ///< particle spacings

/// The height between a wet and a dry one at which the surface lies.
template <class IsWet>
double bisect(double wet, double dry, double accuracy, const IsWet& is_wet) {
  while (dry - wet > accuracy) {
    const double middle = 0.5 * (wet + dry);
    (is_wet(middle) ? wet : dry) = middle;
  }
  return 0.5 * (wet + dry);
}

}  // namespace

double water_level(const Gauge& gauge, const Scene& scene, const Snapshot& snapshot) {
  if (snapshot.columns) return column_level(*snapshot.columns, gauge.x, gauge.y);
  const double side = gauge.size > 0.0 ? gauge.size : 1.5 * scene.particle_spacing;
  const double half_side = (0.5 + kEdgeTolerance) * side;
  const double floor = scene.domain_min.z();
  const double height = gauge.height > 0.0 ? gauge.height : scene.domain_max.z() - floor;
  const bool check_y = scene.dimension == 3;

  std::optional<SprayRule> spray;
  if (gauge.ignore_spray) spray.emplace(scene, snapshot.time);

  double level = 0.0;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const Vec3f& position = snapshot.position[k];
    if (std::abs(position.x() - gauge.x) > half_side) continue;
    if (check_y && std::abs(position.y() - gauge.y) > half_side) continue;
    const double above_floor = position.z() - floor;
    if (above_floor <= level || above_floor > height + kEdgeTolerance * side) continue;
    if (!spray || !spray->is_spray(snapshot, k)) level = above_floor;
  }
  return level;
}

double surface_level(const Gauge& gauge, const FluidField& field) {
  if (field.snapshot().columns) return column_level(*field.snapshot().columns, gauge.x, gauge.y);
  const Scene& scene = field.scene();
  const double floor = scene.domain_min.z();
  const double height = gauge.height > 0.0 ? gauge.height : scene.domain_max.z() - floor;
  const double dx = scene.particle_spacing;
  const auto point = [&](double above_floor) { return Vec3d(gauge.x, gauge.y, floor + above_floor); };
  const auto is_wet = [&](double above_floor) { return field.is_wet(point(above_floor)); };

  const auto steps = static_cast<long>(std::ceil(height / (kStep * dx)));
  std::optional<double> wet;
  bool solid_between = false;
  for (long step = 0; step <= steps; ++step) {
    const double above_floor = std::min(static_cast<double>(step) * kStep * dx, height);
    // What counts is the water above: the foot of a solid that stands on the floor belongs to it.
    if (field.is_in_solid(point(above_floor + kFoot * dx))) {
      solid_between = true;
    } else if (is_wet(above_floor)) {
      wet = above_floor;
      solid_between = false;
    } else if (wet && !solid_between) {
      return bisect(*wet, above_floor, kAccuracy * dx, is_wet);
    } else {
      break;
    }
  }
  return wet.value_or(0.0);
}

}  // namespace eisph
