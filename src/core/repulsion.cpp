#include "core/repulsion.hpp"

#include <algorithm>

namespace eisph {

namespace {

/// Where repulsion from solids ends, in parts of the cutoff of walls: with both at 0.4 dx, water at rest
/// beside a solid lies in the reach of its repulsion and is pushed.
constexpr double kCutoffOfSolids = 0.625;

}  // namespace

Repulsion::Repulsion(const Scene& scene) {
  const double speed_squared = scene.expected_speed() * scene.expected_speed();
  cutoff = scene.boundary.repulsion_cutoff * scene.particle_spacing;
  strength = scene.boundary.repulsion_strength * speed_squared;
  cap = scene.boundary.repulsion_cap * speed_squared / scene.particle_spacing;
}

double Repulsion::raw(double distance) const {
  if (distance >= cutoff || cutoff <= 0.0) return 0.0;
  const double r = std::max(distance, kNearest * cutoff);
  const double ratio = cutoff * cutoff / (r * r);  // (r0/r)^2
  return strength * (ratio * ratio - ratio) / r;
}

double Repulsion::capped(double distance) const { return std::min(raw(distance), cap); }

Repulsion repulsion_of_solids(const Scene& scene) {
  if (!scene.boundary.object_repulsion) return {};
  Repulsion repulsion(scene);
  repulsion.cutoff *= kCutoffOfSolids;
  return repulsion;
}

double repulsion_growth(const Scene& scene, double speed_max) {
  const double reference = scene.expected_speed();
  if (!(speed_max > reference) || reference <= 0.0) return 1.0;
  return speed_max * speed_max / (reference * reference);
}

}  // namespace eisph
