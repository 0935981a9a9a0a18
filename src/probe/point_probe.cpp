#include "probe/point_probe.hpp"

#include "probe/kernel.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

constexpr double kWetKernelSum = 0.5;
constexpr double kWetDistance = 1.0;  // particle spacings

}  // namespace

ShepardSum::ShepardSum(const Vec3d& point, const Snapshot& snapshot)
    : snapshot_(&snapshot),
      point_(point),
      support_squared_(4.0 * snapshot.smoothing_length * snapshot.smoothing_length),
      nearest_squared_(support_squared_) {}

void ShepardSum::add(std::size_t k) {
  Vec3d offset = point_ - snapshot_->position[k].cast<double>();
  if (snapshot_->dimension == 2) offset.y() = 0.0;
  const double distance_squared = offset.squaredNorm();
  if (!(distance_squared < support_squared_)) return;
  nearest_squared_ = std::min(nearest_squared_, distance_squared);
  const double weight = radial_spline(std::sqrt(distance_squared) / snapshot_->smoothing_length);
  weight_ += weight;
  pressure_ += weight * snapshot_->pressure[k];
  velocity_ += weight * snapshot_->velocity[k].cast<double>();
}

PointSample ShepardSum::sample() const {
  const double volume = snapshot_->particle_mass / snapshot_->reference_density;
  const double kernel_sum =
      weight_ * volume * radial_normalisation(snapshot_->smoothing_length, snapshot_->dimension);
  const bool wet = kernel_sum >= kWetKernelSum ||
                   std::sqrt(nearest_squared_) <= kWetDistance * snapshot_->particle_spacing;
  if (!wet || weight_ <= 0.0) return {};
  return {true, pressure_ / weight_, velocity_ / weight_};
}

PointSample sample_at(const Vec3d& point, const Snapshot& snapshot) {
  ShepardSum sum(point, snapshot);
  for (std::size_t k = 0; k < snapshot.size(); ++k) sum.add(k);
  return sum.sample();
}

}  // namespace eisph
