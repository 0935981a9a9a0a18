#pragma once

#include "core/scene.hpp"

#include <array>

namespace eisph {

/// A tank of 1 x 0.6 x 0.5 m (2D: 1 x 0.5 m) with free-slip walls all around and dx = 0.02 m, its lower
/// corner away from the origin.
inline Scene tank_scene(int dimension) {
  Scene scene;
  scene.name = "tank";
  scene.dimension = dimension;
  scene.particle_spacing = 0.02;
  scene.reference_depth = 0.3;
  scene.domain_min = Vec3d(0.4, dimension == 2 ? 0.0 : -0.2, 0.1);
  scene.domain_max = scene.domain_min + Vec3d(1.0, dimension == 2 ? 0.0 : 0.6, 0.5);
  return scene;
}

inline void set_all_faces(Scene& scene, const Face& face) { scene.faces.fill(face); }

inline Shape box(const Vec3d& min, const Vec3d& max, double rotation_z = 0.0) {
  Shape shape;
  shape.min = min;
  shape.max = max;
  shape.rotation_z = rotation_z;
  return shape;
}

inline Shape cylinder(const Vec3d& base, double radius, double height) {
  Shape shape;
  shape.kind = ShapeKind::Cylinder;
  shape.centre = base;
  shape.radius = radius;
  shape.height = height;
  return shape;
}

}  // namespace eisph
