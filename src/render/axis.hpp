#pragma once

#include <string>
#include <vector>

namespace eisph {

/// The smallest of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below `value` (above 0).
[[nodiscard]] double round_up_nicely(double value);
/// The largest of 1, 2, 5 times a power of ten that is not above `value` (above 0).
[[nodiscard]] double round_down_nicely(double value);

struct Tick {
  double value = 0.0;
  std::string label;
};

/// Multiples of a step of 1, 2, 2.5 or 5 times a power of ten that lie in [lower, upper], at most `count`
/// (two or more) unless a coarser step would leave fewer than two.
[[nodiscard]] std::vector<Tick> ticks(double lower, double upper, int count);

/// Length with its unit, in mm below 0.01 m and km from 1000 m on: "0.5 m".
[[nodiscard]] std::string length_text(double metres);

}  // namespace eisph
