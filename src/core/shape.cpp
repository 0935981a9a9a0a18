#include "core/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eisph {

double Shape::signed_distance(const Vec3d& point, int dimension) const {
  switch (kind) {
    case ShapeKind::Sphere: {
      Vec3d offset = point - centre;
      if (dimension == 2) offset.y() = 0.0;
      return offset.norm() - radius;
    }
    case ShapeKind::Cylinder: {
      const Vec3d offset = point - centre;
      const double radial = std::hypot(offset.x(), dimension == 2 ? 0.0 : offset.y()) - radius;
      const double axial = std::abs(offset.z() - 0.5 * height) - 0.5 * height;
      return std::min(std::max(radial, axial), 0.0) + std::hypot(std::max(radial, 0.0), std::max(axial, 0.0));
    }
    case ShapeKind::Box:
      break;
  }
  const Vec3d half = 0.5 * (max - min);
  Vec3d local = point - 0.5 * (min + max);
  if (rotation_z != 0.0) {
    const double c = std::cos(rotation_z);
    const double s = std::sin(rotation_z);
    local = Vec3d(c * local.x() + s * local.y(), -s * local.x() + c * local.y(), local.z());
  }
  Vec3d beyond = local.cwiseAbs() - half;
  if (dimension == 2) beyond.y() = -std::numeric_limits<double>::max();
  return std::min(beyond.maxCoeff(), 0.0) + beyond.cwiseMax(0.0).norm();
}

Vec3d Shape::outward_normal(const Vec3d& point, int dimension) const {
  constexpr double kStep = 1e-6;
  Vec3d normal = Vec3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (dimension == 2 && axis == 1) continue;
    const Vec3d shift = kStep * Vec3d::Unit(axis);
    normal[axis] = signed_distance(point + shift, dimension) - signed_distance(point - shift, dimension);
  }
  const double length = normal.norm();
  return length > 0.0 ? Vec3d(normal / length) : Vec3d::UnitZ();
}

void Shape::bounds(Vec3d& lower, Vec3d& upper) const {
  switch (kind) {
    case ShapeKind::Sphere:
      lower = centre.array() - radius;
      upper = centre.array() + radius;
      return;
    case ShapeKind::Cylinder:
      lower = centre - Vec3d(radius, radius, 0.0);
      upper = centre + Vec3d(radius, radius, height);
      return;
    case ShapeKind::Box:
      break;
  }
  const double c = std::abs(std::cos(rotation_z));
  const double s = std::abs(std::sin(rotation_z));
  const Vec3d half = 0.5 * (max - min);
  const Vec3d reach(c * half.x() + s * half.y(), s * half.x() + c * half.y(), half.z());
  lower = 0.5 * (min + max) - reach;
  upper = 0.5 * (min + max) + reach;
}

double Shape::volume(int dimension) const {
  switch (kind) {
    case ShapeKind::Sphere:
      return dimension == 2 ? std::numbers::pi * radius * radius
                            : 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    case ShapeKind::Cylinder:
      return dimension == 2 ? 2.0 * radius * height : std::numbers::pi * radius * radius * height;
    case ShapeKind::Box:
      break;
  }
  const Vec3d size = max - min;
  return dimension == 2 ? size.x() * size.z() : size.prod();
}

}  // namespace eisph
