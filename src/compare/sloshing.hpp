#pragma once

namespace eisph {

/// Standing wave of small amplitude in a rectangular tank (linear potential theory, e.g. Lamb 1932, Hydro-
/// dynamics, art. 228). The tank reaches from x = 0 to x = L, the floor is z = 0, the still surface z = H:
///
///     surface = H + a cos(k x) cos(omega t),  omega^2 = g k tanh(k H),  k = n pi / L,
///     u = a g k / omega  cosh(k z) / cosh(k H)  sin(k x) sin(omega t),
///     w = -a g k / omega  sinh(k z) / cosh(k H)  cos(k x) sin(omega t).
///
/// Lengths in m, times in s, speeds in m/s. The error of the linear theory is of the order (a k)^2.
class SloshingWave {
 public:
  /// Throws std::invalid_argument unless length, depth, mode and gravity are positive.
  SloshingWave(double amplitude, double tank_length, double depth, int mode = 1, double gravity = 9.81);

  [[nodiscard]] double wave_number() const { return wave_number_; }
  [[nodiscard]] double angular_frequency() const { return angular_frequency_; }
  [[nodiscard]] double period() const;
  /// Height of the surface above the floor.
  [[nodiscard]] double surface(double x, double t) const;
  [[nodiscard]] double velocity_x(double x, double z, double t) const;
  [[nodiscard]] double velocity_z(double x, double z, double t) const;
  /// Pa, hydrostatic part rho g (H - z) included; no less than zero.
  [[nodiscard]] double pressure(double x, double z, double t, double density = 1000.0) const;

 private:
  double amplitude_;
  double depth_;
  double gravity_;
  double wave_number_;
  double angular_frequency_;
};

}  // namespace eisph
