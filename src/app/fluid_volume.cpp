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

/// Volume of the water in a box, by halving the box along every axis until it is clearly full or clearly empty.
double volume_in_box(const Scene& scene, const Vec3d& lower, const Vec3d& upper, int halvings) {
  Vec3d size = upper - lower;
  if (scene.dimension == 2) size.y() = 0.0;
  const double volume = scene.dimension == 2 ? size.x() * size.z() : size.prod();
  const double distance = signed_distance(scene, lower + 0.5 * size);
  const double reach = 0.5 * size.norm();
  if (distance >= reach) return 0.0;
  if (distance <= -reach) return volume;
  if (halvings == 0) return volume * std::clamp(0.5 - 0.5 * distance / (0.5 * size.maxCoeff()), 0.0, 1.0);

  double sum = 0.0;
  const int halves_y = scene.dimension == 2 ? 1 : 2;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < halves_y; ++j) {
      for (int k = 0; k < 2; ++k) {
        const Vec3d corner = lower + 0.5 * size.cwiseProduct(Vec3d(i, j, k));
        sum += volume_in_box(scene, corner, corner + 0.5 * size, halvings - 1);
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
  lower = lower.cwiseMax(scene.domain_min);
  upper = upper.cwiseMin(scene.domain_max);
  if (scene.dimension == 2) lower.y() = upper.y() = 0.0;
  const Vec3d size = upper - lower;
  if (size.x() <= 0.0 || size.z() <= 0.0 || (scene.dimension == 3 && size.y() <= 0.0)) return 0.0;
  return volume_in_box(scene, lower, upper, scene.dimension == 2 ? 10 : 7);
}

}  // namespace eisph
