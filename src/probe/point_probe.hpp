#pragma once

#include "core/shape.hpp"
#include "core/snapshot.hpp"

#include <cstddef>

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

/// The sums of sample_at, particle by particle. Keeps a reference to the snapshot.
class ShepardSum {
 public:
  ShepardSum(const Vec3d& point, const Snapshot& snapshot);
  /// Adds particle k if it is near enough.
  void add(std::size_t k);
  [[nodiscard]] PointSample sample() const;

 private:
  const Snapshot* snapshot_;
  Vec3d point_;
  double support_squared_;
  double nearest_squared_;
  double weight_ = 0.0;
  double pressure_ = 0.0;
  Vec3d velocity_ = Vec3d::Zero();
};

}  // namespace eisph
