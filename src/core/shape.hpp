#pragma once

#include <Eigen/Core>

namespace eisph {

using Vec3d = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;

enum class ShapeKind { Box, Cylinder, Sphere };

/// A solid used for water, obstacles, dam walls and gates. Lengths in metres. A two-dimensional scene lies in
/// the plane y = 0 and uses x and z; there a cylinder is not used and a sphere is a disc.
struct Shape {
  ShapeKind kind = ShapeKind::Box;
  Vec3d min = Vec3d::Zero();     ///< box: lower corner before rotation
  Vec3d max = Vec3d::Zero();     ///< box: upper corner before rotation
  double rotation_z = 0.0;       ///< box: rotation about the vertical axis through its centre, radians
  Vec3d centre = Vec3d::Zero();  ///< sphere: centre; cylinder: centre of its base (upright axis)
  double radius = 0.0;           ///< sphere, cylinder
  double height = 0.0;           ///< cylinder

  /// Signed distance from point to the surface, negative inside, metres. Exact inside and on faces.
  /// dimension 2 ignores y.
  [[nodiscard]] double signed_distance(const Vec3d& point, int dimension) const;
  [[nodiscard]] bool contains(const Vec3d& point, int dimension) const {
    return signed_distance(point, dimension) < 0.0;
  }
  /// Outward normal of the surface nearest to `point`, by differences of the distance; upwards where these
  /// vanish.
  [[nodiscard]] Vec3d outward_normal(const Vec3d& point, int dimension) const;
  /// Axis-aligned bounds of the (rotated) shape.
  void bounds(Vec3d& lower, Vec3d& upper) const;
  /// Volume in m^3 (area in m^2 for dimension 2).
  [[nodiscard]] double volume(int dimension) const;

  bool operator==(const Shape&) const = default;
};

}  // namespace eisph
