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

}  // namespace eisph
