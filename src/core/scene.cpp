#include "core/scene.hpp"

#include <cmath>

namespace eisph {

std::optional<double> Gate::lift(double time) const {
  if (time < start_time) return 0.0;
  if (motion == GateMotion::Instant) return std::nullopt;
  const double height = speed * (time - start_time);
  if (height >= stroke) return std::nullopt;
  return height;
}

double Scene::reference_speed() const { return std::sqrt(2.0 * gravity.norm() * reference_depth); }

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
