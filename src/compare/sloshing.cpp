#include "compare/sloshing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace eisph {

SloshingWave::SloshingWave(double amplitude, double tank_length, double depth, int mode, double gravity)
    : amplitude_(amplitude),
      depth_(depth),
      gravity_(gravity),
      wave_number_(mode * std::numbers::pi / tank_length),
      angular_frequency_(std::sqrt(gravity * wave_number_ * std::tanh(wave_number_ * depth))) {
  if (!(tank_length > 0.0) || !(depth > 0.0) || mode < 1 || !(gravity > 0.0)) {
    throw std::invalid_argument("A sloshing wave needs a positive length, depth, mode and gravity");
  }
}

double SloshingWave::period() const { return 2.0 * std::numbers::pi / angular_frequency_; }

double SloshingWave::surface(double x, double t) const {
  return depth_ + amplitude_ * std::cos(wave_number_ * x) * std::cos(angular_frequency_ * t);
}

double SloshingWave::velocity_x(double x, double z, double t) const {
  return amplitude_ * gravity_ * wave_number_ / angular_frequency_ * std::cosh(wave_number_ * z) /
         std::cosh(wave_number_ * depth_) * std::sin(wave_number_ * x) * std::sin(angular_frequency_ * t);
}

double SloshingWave::velocity_z(double x, double z, double t) const {
  return -amplitude_ * gravity_ * wave_number_ / angular_frequency_ * std::sinh(wave_number_ * z) /
         std::cosh(wave_number_ * depth_) * std::cos(wave_number_ * x) * std::sin(angular_frequency_ * t);
}

double SloshingWave::pressure(double x, double z, double t, double density) const {
  const double wave = amplitude_ * std::cosh(wave_number_ * z) / std::cosh(wave_number_ * depth_) *
                      std::cos(wave_number_ * x) * std::cos(angular_frequency_ * t);
  return std::max(0.0, density * gravity_ * (depth_ - z + wave));
}

}  // namespace eisph
