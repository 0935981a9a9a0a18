#pragma once

#include <bit>
#include <cstdint>

namespace eisph {

// Bed friction after Manning: du/dt = -g n^2 |u| u / h^(4/3), with n in s m^(-1/3). SI units.

/// h^(-1/3) of a positive number to round-off, without a branch or a call: a guess from the bits of the
/// single-precision number, then Newton steps y <- y (4 - h y^3) / 3.
inline double inverse_cube_root(double h) {
  const auto bits = std::bit_cast<std::int32_t>(static_cast<float>(h));
  const auto guess = static_cast<std::int32_t>(1.4199104e9F - static_cast<float>(bits) * (1.0F / 3.0F));
  double y = std::bit_cast<float>(guess);
  for (int k = 0; k < 4; ++k) y *= (4.0 - h * y * y * y) * (1.0 / 3.0);
  return y;
}

/// What the speed is divided by in a step of `time_step` from the velocity without friction. Implicit in the
/// velocity, which makes it the exact decay u0 / (1 + k u0 t) of a uniform flow.
inline double manning_divisor(double gravity, double manning, double time_step, double depth, double speed) {
  const double root = inverse_cube_root(depth);
  const double squared = root * root;
  return 1.0 + time_step * gravity * manning * manning * speed * squared * squared;
}

}  // namespace eisph
