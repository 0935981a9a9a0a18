#pragma once

#include <cmath>

namespace eisph {

/// Pressure of weakly compressible water from its compression s = rho/rho0 - 1 and back.
/// gamma = 7 is Tait's equation (thesis (2.9), with c0^2 where c0^gamma is printed), gamma = 1 the linear one
/// (thesis (2.10)).
struct EquationOfState {
  double density = 0.0;      ///< rho0, kg/m^3
  double sound_speed = 0.0;  ///< c0, m/s
  double gamma = 1.0;
  bool clamp = true;  ///< no negative pressure

  /// rho0 c0^2 / gamma ((1 + s)^gamma - 1), Pa
  [[nodiscard]] double pressure(double compression) const {
    const double relative = std::expm1(gamma * std::log1p(compression)) / gamma;
    const double pressure = density * sound_speed * sound_speed * (gamma == 1.0 ? compression : relative);
    return clamp && pressure < 0.0 ? 0.0 : pressure;
  }
  /// The compression at `pressure`, Pa.
  [[nodiscard]] double compression(double pressure) const {
    const double relative = pressure / (density * sound_speed * sound_speed);
    return gamma == 1.0 ? relative : std::expm1(std::log1p(gamma * relative) / gamma);
  }
};

}  // namespace eisph
