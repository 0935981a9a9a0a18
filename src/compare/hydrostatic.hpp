#pragma once

#include <algorithm>

namespace eisph {

/// Pressure (Pa) at height z (m) in water at rest with its surface at `level` (m): rho g (level - z); zero
/// above the surface.
[[nodiscard]] constexpr double hydrostatic_pressure(double level, double z, double density = 1000.0,
                                                    double gravity = 9.81) {
  return density * gravity * std::max(0.0, level - z);
}

}  // namespace eisph
