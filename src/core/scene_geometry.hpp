#pragma once

#include "core/scene.hpp"

#include <optional>
#include <string>

namespace eisph {

/// A face of the domain as seen from a point.
struct NearestFace {
  Vec3d normal = Vec3d::Zero();  ///< unit vector into the domain
  double distance = 0.0;         ///< m
};

/// The nearest face that is not open; the floor before the sides where they are equally near. Nothing if all
/// are open.
[[nodiscard]] std::optional<NearestFace> nearest_face(const Scene& scene, const Vec3d& point);

/// Centre of the base of an obstacle, dam or closed gate (the lowest point of a sphere), m. Nothing if there
/// is none of that name.
[[nodiscard]] std::optional<Vec3d> solid_base(const Scene& scene, const std::string& name);

}  // namespace eisph
