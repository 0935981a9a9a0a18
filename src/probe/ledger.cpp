#include "probe/ledger.hpp"

#include "probe/column_probes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace eisph {

namespace {

void take_compression(const Snapshot& snapshot, LedgerEntry& entry) {
  std::vector<float> density;
  density.reserve(snapshot.number_density.size());
  // Not-a-number has no place in an order.
  std::copy_if(snapshot.number_density.begin(), snapshot.number_density.end(), std::back_inserter(density),
               [](float value) { return !std::isnan(value); });
  if (density.empty()) return;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(density.size())));
  const auto percentile = density.begin() + (rank - 1);
  std::nth_element(density.begin(), percentile, density.end());
  entry.compression_p95 = *percentile - 1.0;
  entry.compression_max = *std::max_element(percentile, density.end()) - 1.0;
}

}  // namespace

LedgerEntry take_ledger(const Snapshot& snapshot, const Scene& scene) {
  if (snapshot.columns) return column_ledger(*snapshot.columns, scene);
  Vec3d position_sum = Vec3d::Zero();
  Vec3d velocity_sum = Vec3d::Zero();
  double speed_squared_sum = 0.0;
  double relative_volume = 0.0;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const Vec3d velocity = snapshot.velocity[k].cast<double>();
    position_sum += snapshot.position[k].cast<double>() - scene.domain_min;
    velocity_sum += velocity;
    speed_squared_sum += velocity.squaredNorm();
    relative_volume += 1.0 / std::fmax(snapshot.number_density[k], 1.0);
  }

  LedgerEntry entry;
  entry.mass = snapshot.particle_mass * static_cast<double>(snapshot.size());
  if (snapshot.reference_density > 0.0) {
    entry.volume = snapshot.particle_mass / snapshot.reference_density * relative_volume;
  }
  entry.kinetic_energy = 0.5 * snapshot.particle_mass * speed_squared_sum;
  entry.potential_energy = -snapshot.particle_mass * scene.gravity.dot(position_sum);
  entry.momentum = snapshot.particle_mass * velocity_sum;
  entry.penetrations = static_cast<double>(snapshot.penetrations);
  entry.lost_particles = static_cast<double>(snapshot.lost_particles);
  take_compression(snapshot, entry);
  return entry;
}

}  // namespace eisph
