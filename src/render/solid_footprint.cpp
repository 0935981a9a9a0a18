#include "render/solid_footprint.hpp"

#include "render/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eisph {

namespace {

/// From above only the plan counts: the solid reaches from far below to far above.
Shape upright(Shape shape) {
  constexpr double kFar = 1e6;
  if (shape.kind == ShapeKind::Box) {
    shape.min.z() = -kFar;
    shape.max.z() = kFar;
  } else {
    shape.kind = ShapeKind::Cylinder;
    shape.centre.z() = -kFar;
    shape.height = 2.0 * kFar;
  }
  return shape;
}

Shape raised(Shape shape, double lift) {
  shape.min.z() += lift;
  shape.max.z() += lift;
  shape.centre.z() += lift;
  return shape;
}

/// A box that ends at a symmetry plane goes on behind it: no outline there.
Shape continued(Shape shape, const Scene& scene) {
  if (shape.kind != ShapeKind::Box || shape.rotation_z != 0.0) return shape;
  const double touching = 1e-6 * (scene.domain_max - scene.domain_min).norm();
  for (int axis = 0; axis < 2; ++axis) {
    const double size = shape.max[axis] - shape.min[axis];
    const auto ends_at = [&](int face, double end, double plane) {
      const bool symmetric = scene.faces[static_cast<std::size_t>(face)].kind == FaceKind::Symmetry;
      return symmetric && std::abs(end - plane) < touching;
    };
    if (ends_at(2 * axis, shape.min[axis], scene.domain_min[axis])) shape.min[axis] -= size;
    if (ends_at(2 * axis + 1, shape.max[axis], scene.domain_max[axis])) shape.max[axis] += size;
  }
  return shape;
}

}  // namespace

SolidFootprint::SolidFootprint(const Scene& scene, double time) : dimension_(scene.dimension) {
  const auto add = [&](const Shape& shape, bool gate) {
    shapes_.push_back({dimension_ == 3 ? upright(continued(shape, scene)) : shape, gate});
  };
  for (const Obstacle& obstacle : scene.obstacles) add(obstacle.shape, false);
  for (const Gate& gate : scene.gates) {
    if (const auto lift = gate.lift(time)) add(raised(gate.shape, *lift), true);
  }
}

std::pair<double, bool> SolidFootprint::distance(double first, double second) const {
  const Vec3d point = dimension_ == 3 ? Vec3d(first, second, 0.0) : Vec3d(first, 0.0, second);
  std::pair<double, bool> nearest{std::numeric_limits<double>::max(), false};
  for (const Part& part : shapes_) {
    nearest = std::min(nearest, std::pair(part.shape.signed_distance(point, dimension_), part.gate));
  }
  return nearest;
}

void SolidFootprint::paint(Image& image, int x, int y, double pixels, const Colour& colour) const {
  const double outline = std::max(1.0, image.height / 480.0);
  const auto inside = static_cast<float>(std::clamp(0.5 - pixels, 0.0, 1.0));
  const auto core = static_cast<float>(std::clamp(0.5 - (pixels + outline), 0.0, 1.0));
  blend_pixel(image, x, y, mix(mix(colour, Colour{}, 0.65F), colour, core), inside);
}

}  // namespace eisph
