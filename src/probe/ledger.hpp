#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"

namespace eisph {

/// Sums over the fluid of one snapshot. In two dimensions all of them are per metre of width. V_j = m / rho0;
/// the number density n_j counts from 1 on only, as below it says where the surface is, not how far the water
/// has expanded.
struct LedgerEntry {
  double mass = 0.0;    ///< kg
  double volume = 0.0;  ///< m^3, sum of V_j / max(n_j, 1): what the water takes up, compressed as it is
  double kinetic_energy = 0.0;     ///< J
  double potential_energy = 0.0;   ///< J, against gravity from scene.domain_min
  Vec3d momentum = Vec3d::Zero();  ///< kg m/s
  double compression_max = 0.0;    ///< largest number density - 1; zero without fluid
  double compression_p95 = 0.0;    ///< its 95th percentile: at least 95 % of the particles have no more
  double penetrations = 0.0;       ///< so far (Snapshot)
  double lost_particles = 0.0;     ///< so far (Snapshot)
};

[[nodiscard]] LedgerEntry take_ledger(const Snapshot& snapshot, const Scene& scene);

}  // namespace eisph
