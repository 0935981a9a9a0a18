#include "app/fluid_volume.hpp"

#include <algorithm>
#include <limits>

namespace eisph {
namespace {

/// Below zero inside the water; never further from zero than the surface is.
double signed_distance(const Scene& scene, const Vec3d& point) {
  double distance = std::numeric_limits<double>::infinity();
  for (const FluidRegion& region : scene.fluid) {
    if (!region.cut) distance = std::min(distance, region.shape.signed_distance(point, scene.dimension));
  }
  for (const FluidRegion& region : scene.fluid) {
    if (region.cut) distance = std::max(distance, -region.shape.signed_distance(point, scene.dimension));
  }
  return distance;
}

/// Volume of the water in a cube (square), by halving it along every axis until it is clearly full or clearly
/// empty; a smallest cube counts as cut by a plane at the distance of the surface.
double volume_in_cube(const Scene& scene, const Vec3d& lower, double side, int halvings) {
  const bool flat = scene.dimension == 2;
  const Vec3d directions(1.0, flat ? 0.0 : 1.0, 1.0);
  const double volume = flat ? side * side : side * side * side;
  const double distance = signed_distance(scene, lower + 0.5 * side * directions);
  const double reach = 0.5 * side * directions.norm();
  if (distance >= reach) return 0.0;
  if (distance <= -reach) return volume;
  if (halvings == 0) return volume * std::clamp(0.5 - distance / side, 0.0, 1.0);

  double sum = 0.0;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < (flat ? 1 : 2); ++j) {
      for (int k = 0; k < 2; ++k) {
        sum += volume_in_cube(scene, lower + 0.5 * side * Vec3d(i, j, k), 0.5 * side, halvings - 1);
      }
    }
  }
  return sum;
}

}  // namespace

double fluid_volume(const Scene& scene) {
  Vec3d lower = Vec3d::Constant(std::numeric_limits<double>::infinity());
  Vec3d upper = -lower;
  for (const FluidRegion& region : scene.fluid) {
    if (region.cut) continue;
    Vec3d region_lower;
    Vec3d region_upper;
    region.shape.bounds(region_lower, region_upper);
    lower = lower.cwiseMin(region_lower);
    upper = upper.cwiseMax(region_upper);
  }
  if (scene.dimension == 2) lower.y() = upper.y() = 0.0;
  const double side = (upper - lower).maxCoeff();
  if (!(side > 0.0)) return 0.0;
  return volume_in_cube(scene, lower, side, scene.dimension == 2 ? 9 : 7);
}

}  // namespace eisph
