#include "core/scene_geometry.hpp"

#include <cmath>

namespace eisph {

namespace {

Vec3d base_of(const Shape& shape, int dimension) {
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  Vec3d base = 0.5 * (lower + upper);
  if (dimension == 2) base.y() = 0.0;
  base.z() = lower.z();
  return base;
}

}  // namespace

std::optional<NearestFace> nearest_face(const Scene& scene, const Vec3d& point) {
  std::optional<NearestFace> nearest;
  for (const int axis : {2, 0, 1}) {
    if (scene.dimension == 2 && axis == 1) continue;
    for (const int side : {0, 1}) {
      const int index = 2 * axis + side;
      if (scene.faces[static_cast<std::size_t>(index)].kind == FaceKind::Open) continue;
      const double face = side == 0 ? scene.domain_min[axis] : scene.domain_max[axis];
      const double distance = std::abs(point[axis] - face);
      if (nearest && distance >= nearest->distance) continue;
      nearest = {(side == 0 ? 1.0 : -1.0) * Vec3d::Unit(axis), distance};
    }
  }
  return nearest;
}

std::optional<Vec3d> solid_base(const Scene& scene, const std::string& name) {
  for (const Obstacle& obstacle : scene.obstacles) {
    if (obstacle.name == name) return base_of(obstacle.shape, scene.dimension);
  }
  for (const Gate& gate : scene.gates) {
    if (gate.name == name) return base_of(gate.shape, scene.dimension);
  }
  return std::nullopt;
}

}  // namespace eisph
