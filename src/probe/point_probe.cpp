#include "probe/point_probe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eisph {

namespace {

constexpr double kWetKernelSum = 0.5;
constexpr double kWetDistance = 1.0;  // particle spacings

/// Cubic spline without its normalisation, 0 <= q < 2.
double cubic_spline(double q) {
  if (q < 1.0) return 1.0 - 1.5 * q * q + 0.75 * q * q * q;
  const double rest = 2.0 - q;
  return 0.25 * rest * rest * rest;
}

double normalisation(double h, int dimension) {
  return dimension == 2 ? 10.0 / (7.0 * std::numbers::pi * h * h) : 1.0 / (std::numbers::pi * h * h * h);
}

}  // namespace

PointSample sample_at(const Vec3d& point, const Snapshot& snapshot) {
  const double h = snapshot.smoothing_length;
  const double support_squared = 4.0 * h * h;
  double nearest_squared = support_squared;
  double weight_sum = 0.0;
  double pressure_sum = 0.0;
  Vec3d velocity_sum = Vec3d::Zero();
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    Vec3d offset = point - snapshot.position[k].cast<double>();
    if (snapshot.dimension == 2) offset.y() = 0.0;
    const double distance_squared = offset.squaredNorm();
    if (!(distance_squared < support_squared)) continue;
    nearest_squared = std::min(nearest_squared, distance_squared);
    const double weight = cubic_spline(std::sqrt(distance_squared) / h);
    weight_sum += weight;
    pressure_sum += weight * snapshot.pressure[k];
    velocity_sum += weight * snapshot.velocity[k].cast<double>();
  }

  const double volume = snapshot.particle_mass / snapshot.reference_density;
  const double kernel_sum = weight_sum * volume * normalisation(h, snapshot.dimension);
  const bool wet =
      kernel_sum >= kWetKernelSum || std::sqrt(nearest_squared) <= kWetDistance * snapshot.particle_spacing;
  if (!wet || weight_sum <= 0.0) return {};
  return {true, pressure_sum / weight_sum, velocity_sum / weight_sum};
}

}  // namespace eisph
