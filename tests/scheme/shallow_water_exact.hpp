#pragma once

#include "scheme/scenes.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace eisph {

/// Depth (m) and velocity (m/s).
struct DepthAndVelocity {
  double depth = 0.0;
  double velocity = 0.0;
};

/// Dam break on a dry bed (Ritter 1892), dam at x = 0, water of `depth` on the left.
inline DepthAndVelocity ritter(double depth, double x, double time) {
  const double c = std::sqrt(kGravity * depth);
  const double speed = x / time;
  if (speed <= -c) return {depth, 0.0};
  if (speed >= 2.0 * c) return {};
  return {std::pow(2.0 * c - speed, 2) / (9.0 * kGravity), 2.0 / 3.0 * (c + speed)};
}

/// Dam break on a wet bed (Stoker 1957).
class Stoker {
 public:
  Stoker(double deep, double shallow) : deep_(deep), shallow_(shallow) {
    // The depth behind the bore: what rarefaction and bore say of the velocity there must agree.
    double low = shallow;
    double high = deep;
    for (int k = 0; k < 100; ++k) {
      middle_ = 0.5 * (low + high);
      const double from_rarefaction = 2.0 * (wave(deep_) - wave(middle_));
      (from_rarefaction > from_bore(middle_) ? low : high) = middle_;
    }
  }
  [[nodiscard]] DepthAndVelocity at(double x, double time) const {
    const double speed = x / time;
    const double u = from_bore(middle_);
    if (speed <= -wave(deep_)) return {deep_, 0.0};
    if (speed <= u - wave(middle_)) return ritter(deep_, x, time);
    if (speed <= bore_speed()) return {middle_, u};
    return {shallow_, 0.0};
  }
  [[nodiscard]] double middle_depth() const { return middle_; }
  [[nodiscard]] double middle_velocity() const { return from_bore(middle_); }
  [[nodiscard]] double bore_speed() const { return middle_ * from_bore(middle_) / (middle_ - shallow_); }

 private:
  static double wave(double depth) { return std::sqrt(kGravity * depth); }
  [[nodiscard]] double from_bore(double depth) const {
    return (depth - shallow_) * std::sqrt(0.5 * kGravity * (depth + shallow_) / (depth * shallow_));
  }
  double deep_;
  double shallow_;
  double middle_ = 0.0;
};

/// A tank for the shallow-water scheme: `size` in cells of `cell`, no friction.
inline Scene shallow_tank(int dimension, const Vec3d& size, double cell, const Shape& water) {
  Scene scene = tank(dimension, size, cell, water);
  scene.scheme.name = "shallow_water";
  scene.shallow_water.cell_size = cell;
  scene.shallow_water.manning = 0.0;
  return scene;
}

/// A channel along x whose cells hold the given means of depth and of depth times velocity.
inline Scene channel(double length, double cell, const std::vector<DepthAndVelocity>& means) {
  Scene scene = shallow_tank(2, Vec3d(length, 0.0, 1.0), cell, box(Vec3d::Zero(), Vec3d(1.0, 0.0, 1.0)));
  scene.fluid.clear();
  for (std::size_t i = 0; i < means.size(); ++i) {
    FluidRegion region;
    region.shape = box(Vec3d(static_cast<double>(i) * cell, 0.0, 0.0),
                       Vec3d(static_cast<double>(i + 1) * cell, 0.0, means[i].depth));
    region.velocity.x() = means[i].velocity;
    if (means[i].depth > 0.0) scene.fluid.push_back(region);
  }
  return scene;
}

/// Mean over [lower, upper] by three Gauss points in each of four parts.
inline double mean_of(const std::function<double(double)>& function, double lower, double upper) {
  constexpr int kParts = 4;
  const double half = 0.5 * (upper - lower) / kParts;
  double sum = 0.0;
  for (int part = 0; part < kParts; ++part) {
    const double middle = lower + (2 * part + 1) * half;
    const double offset = half * std::sqrt(0.6);
    sum += 5.0 * function(middle - offset) + 8.0 * function(middle) + 5.0 * function(middle + offset);
  }
  return sum / (18.0 * kParts);
}

/// Mean absolute difference of the depths from those of `exact`, m.
inline double depth_error(const Snapshot& snapshot, const std::function<double(double)>& exact) {
  const ColumnField& columns = *snapshot.columns;
  double sum = 0.0;
  for (std::size_t i = 0; i < columns.columns; ++i) {
    const double lower = columns.origin_x + static_cast<double>(i) * columns.cell_size;
    sum += std::abs(columns.depth[i] - mean_of(exact, lower, lower + columns.cell_size));
  }
  return sum / static_cast<double>(columns.columns);
}

/// Largest speed of the columns, m/s.
inline double largest_column_speed(const Snapshot& snapshot) {
  const ColumnField& columns = *snapshot.columns;
  double largest = 0.0;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    largest = std::max<double>(largest, std::hypot(columns.velocity_x[k], columns.velocity_y[k]));
  }
  return largest;
}

}  // namespace eisph
