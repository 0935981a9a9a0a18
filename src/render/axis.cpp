#include "render/axis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

double power_of_ten(double value) { return std::pow(10.0, std::floor(std::log10(value) + 1e-9)); }

std::string tick_label(double value, int decimals) {
  if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0.0;
  std::string label = fmt::format("{:.{}f}", std::abs(value), decimals);
  return value < 0.0 ? "\u2212" + label : label;
}

}  // namespace

double round_up_nicely(double value) {
  const double power = power_of_ten(value);
  for (const double factor : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (factor * power >= value * (1.0 - 1e-6)) return factor * power;
  }
  return 10.0 * power;
}

double round_down_nicely(double value) {
  const double power = power_of_ten(value);
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= value * (1.0 + 1e-6)) return factor * power;
  }
  return power;
}

std::vector<Tick> ticks(double lower, double upper, int count) {
  const double span = upper - lower;
  double power = power_of_ten(span) * 0.01;
  std::vector<Tick> result;
  for (bool done = false; !done; power *= 10.0) {
    for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
      const double step = factor * power;
      const auto first = static_cast<long>(std::ceil(lower / step - 1e-6));
      const auto last = static_cast<long>(std::floor(upper / step + 1e-6));
      if (last - first + 1 < 2) {
        done = true;
        break;
      }
      if (last - first + 1 > 50) continue;
      int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
      if (factor == 2.5 && step < 10.0) ++decimals;
      result.clear();
      for (long k = first; k <= last; ++k) {
        const double value = static_cast<double>(k) * step;
        result.push_back({value, tick_label(value, decimals)});
      }
      if (static_cast<int>(result.size()) <= count) return result;
    }
  }
  return result;
}

std::string length_text(double metres) {
  if (metres < 0.0099) return fmt::format("{:g} mm", 1000.0 * metres);
  if (metres >= 1000.0) return fmt::format("{:g} km", 0.001 * metres);
  return fmt::format("{:g} m", metres);
}

}  // namespace eisph
