#include "core/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eisph {

std::optional<double> Gate::lift(double time) const {
  if (time < start_time) return 0.0;
  if (motion == GateMotion::Instant) return std::nullopt;
  const double height = speed * (time - start_time);
  if (height >= stroke) return std::nullopt;
  return height;
}

Vec3d FluidRegion::velocity_at(const Vec3d& point) const {
  if (angular_velocity == 0.0 && vortex_speed == 0.0) return velocity;
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  Vec3d result = velocity;
  const Vec3d arm = point - 0.5 * (lower + upper);
  result.x() += angular_velocity * arm.z();
  result.z() -= angular_velocity * arm.x();
  if (vortex_speed != 0.0) {
    const Vec3d wave_number = 2.0 * std::numbers::pi * (upper - lower).cwiseInverse();
    const double x = wave_number.x() * (point.x() - lower.x());
    const double z = wave_number.z() * (point.z() - lower.z());
    result.x() += vortex_speed * std::sin(x) * std::cos(z);
    result.z() -= vortex_speed * wave_number.x() / wave_number.z() * std::cos(x) * std::sin(z);
  }
  return result;
}

double FluidRegion::fastest() const {
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  const Vec3d size = upper - lower;
  const double vortex = vortex_speed == 0.0 ? 0.0 : vortex_speed * std::max(1.0, size.z() / size.x());
  return velocity.norm() + 0.5 * std::abs(angular_velocity) * std::hypot(size.x(), size.z()) +
         std::abs(vortex);
}

double Scene::reference_speed() const { return std::sqrt(2.0 * gravity.norm() * reference_depth); }

double Scene::initial_speed() const {
  double speed = 0.0;
  for (const FluidRegion& region : fluid) {
    if (!region.cut) speed = std::max(speed, region.fastest());
  }
  return speed;
}

double Scene::expected_speed() const { return std::max(reference_speed(), initial_speed()); }

std::vector<double> probe_intervals(const Scene& scene) {
  std::vector<double> intervals;
  const auto add = [&](const auto& probes) {
    for (const auto& probe : probes) intervals.push_back(probe.interval);
  };
  add(scene.gauges);
  add(scene.probes);
  add(scene.pressure_sensors);
  add(scene.fronts);
  add(scene.lines);
  add(scene.forces);
  add(scene.discharges);
  return intervals;
}

}  // namespace eisph
