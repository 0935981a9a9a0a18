#pragma once

#include <algorithm>

namespace eisph {

/// How much pressure water takes in a blow. A particle that hits a wall, or another one, is stopped within
/// one time step: the sweep makes a water hammer of its own speed of sound, rho c u, of it, which is that of
/// a particle and a time step and of no fluid. Stopping over a longer way needs no more than some multiple of
/// the dynamic pressure, beta rho U^2; the way is a compression, and once the water is compressed (number
/// density n above one) the bound gives way,
///   P <= beta rho U^2 [1 + (n - 1)_+ / epsilon],
/// so that large bodies of water that strike as a whole are stopped by as much pressure as they need. The
/// same holds for the volume correction, without giving way, with beta = 1. The largest pressures that were
/// measured in dam breaks are 1.0 rho U^2 (Kleefsman et al. 2005, on a block) to 1.5 (Lobovsky et al. 2014,
/// on a wall).
struct BlowBound {
  static constexpr double kPressure = 1.5;              ///< beta
  static constexpr double kVolumeCorrection = 1.0;      ///< beta of the volume correction
  static constexpr double kYieldingCompression = 0.01;  ///< epsilon

  double dynamic_pressure = 0.0;  ///< rho U^2, Pa

  [[nodiscard]] double pressure(double number_density) const {
    return kPressure * dynamic_pressure * (1.0 + std::max(0.0, number_density - 1.0) / kYieldingCompression);
  }
  [[nodiscard]] double volume_correction() const { return kVolumeCorrection * dynamic_pressure; }
};

}  // namespace eisph
