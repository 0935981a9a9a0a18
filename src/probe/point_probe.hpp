#pragma once

#include "core/shape.hpp"
#include "core/snapshot.hpp"

namespace eisph {

/// What the water does at a point. Zero outside the water.
struct PointSample {
  bool wet = false;
  double pressure = 0.0;           ///< Pa
  Vec3d velocity = Vec3d::Zero();  ///< m/s
};

/// Value at `point` (metres) by Shepard interpolation over the fluid:
///
///   A(x) = sum_j A_j W(|x - x_j|, h) / sum_j W(|x - x_j|, h)
///
/// with the cubic spline W of support 2h. It is exact for a constant field up to walls and the free surface.
/// Next to them it is one-sided, so a linear field is off by about 0.5 h times its gradient.
///
/// The point is wet if sum_j V_j W >= 1/2 (inside the water up to its surface) or if a fluid particle lies
/// within one particle spacing (at walls, in corners and in thin sheets, where the kernel is mostly empty).
[[nodiscard]] PointSample sample_at(const Vec3d& point, const Snapshot& snapshot);

}  // namespace eisph
