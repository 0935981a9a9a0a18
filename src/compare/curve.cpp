#include "compare/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace eisph {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Integral over [first, last] of the straight lines, and the length over which there are any.
struct Integral {
  double value = 0.0;
  double length = 0.0;
};

Integral integral(const Curve& curve, double first, double last) {
  Integral sum;
  const auto begin = std::upper_bound(curve.x.begin(), curve.x.end(), first) - curve.x.begin();
  for (std::size_t k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(begin, 1)); k < curve.size(); ++k) {
    if (curve.x[k - 1] >= last) break;
    const double left = std::max(first, curve.x[k - 1]);
    const double right = std::min(last, curve.x[k]);
    const double mean = value_at(curve, 0.5 * (left + right));
    if (std::isnan(mean) || right <= left) continue;
    sum.value += mean * (right - left);
    sum.length += right - left;
  }
  return sum;
}

/// Where the straight line from point k - 1 to point k meets `level`.
double crossing(const Curve& curve, std::size_t k, double level) {
  const double rise = curve.y[k] - curve.y[k - 1];
  return curve.x[k - 1] + (curve.x[k] - curve.x[k - 1]) * (level - curve.y[k - 1]) / rise;
}

}  // namespace

Curve make_curve(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() != y.size()) throw std::invalid_argument("A curve needs as many x as y");
  std::map<double, std::pair<double, int>> sums;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (std::isnan(x[k])) continue;
    auto& [sum, count] = sums[x[k]];
    sum += y[k];
    ++count;
  }
  Curve curve;
  for (const auto& [at, sum] : sums) curve.add(at, sum.first / sum.second);
  return curve;
}

double value_at(const Curve& curve, double x) {
  if (curve.empty() || !(x >= curve.x.front()) || !(x <= curve.x.back())) return kNone;
  const auto k =
      static_cast<std::size_t>(std::lower_bound(curve.x.begin(), curve.x.end(), x) - curve.x.begin());
  if (curve.x[k] == x) return curve.y[k];
  const double weight = (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]);
  return (1.0 - weight) * curve.y[k - 1] + weight * curve.y[k];
}

Curve scaled(Curve curve, double x_factor, double y_factor) {
  if (!(x_factor > 0.0)) throw std::invalid_argument("The x of a curve are scaled by positive factors only");
  for (double& x : curve.x) x *= x_factor;
  for (double& y : curve.y) y *= y_factor;
  return curve;
}

Curve shifted(Curve curve, double x_offset, double y_offset) {
  for (double& x : curve.x) x += x_offset;
  for (double& y : curve.y) y += y_offset;
  return curve;
}

Curve restricted(const Curve& curve, double first, double last) {
  Curve part;
  const double value_at_first = value_at(curve, first);
  const double value_at_last = value_at(curve, last);
  if (!std::isnan(value_at_first)) part.add(first, value_at_first);
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const bool is_added = (curve.x[k] == first && !std::isnan(value_at_first)) ||
                          (curve.x[k] == last && !std::isnan(value_at_last));
    if (curve.x[k] >= first && curve.x[k] <= last && !is_added) part.add(curve.x[k], curve.y[k]);
  }
  if (!std::isnan(value_at_last) && last > first) part.add(last, value_at_last);
  return part;
}

Curve extended(Curve curve, double first, double last) {
  if (curve.empty()) return curve;
  if (first < curve.x.front()) {
    curve.x.insert(curve.x.begin(), first);
    curve.y.insert(curve.y.begin(), curve.y.front());
  }
  if (last > curve.x.back()) curve.add(last, curve.y.back());
  return curve;
}

Curve resampled(const Curve& curve, const std::vector<double>& x) {
  Curve samples;
  for (const double at : x) samples.add(at, value_at(curve, at));
  return samples;
}

Curve moving_average(const Curve& curve, double width) {
  Curve average = curve;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double x = curve.x[k];
    const double half = std::min({0.5 * width, x - curve.x.front(), curve.x.back() - x});
    const Integral sum = integral(curve, x - half, x + half);
    if (!std::isnan(curve.y[k]) && sum.length > 0.0) average.y[k] = sum.value / sum.length;
  }
  return average;
}

double noise(const Curve& curve, double width) {
  const Curve average = moving_average(curve, width);
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (std::isnan(curve.y[k])) continue;
    squares += (curve.y[k] - average.y[k]) * (curve.y[k] - average.y[k]);
    ++count;
  }
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : kNone;
}

CurvePoint highest_point(const Curve& curve) {
  CurvePoint highest{kNone, kNone};
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (std::isnan(curve.y[k]) || curve.y[k] <= highest.y) continue;
    highest = {curve.x[k], curve.y[k]};
  }
  return highest;
}

CurvePoint lowest_point(const Curve& curve) {
  const CurvePoint point = highest_point(scaled(curve, 1.0, -1.0));
  return {point.x, -point.y};
}

double first_rise_to(const Curve& curve, double level) {
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (std::isnan(curve.y[k]) || curve.y[k] < level) continue;
    const bool has_lower_before = k > 0 && curve.y[k - 1] < level;
    return has_lower_before ? crossing(curve, k, level) : curve.x[k];
  }
  return kNone;
}

double first_fall_to(const Curve& curve, double level) {
  return first_rise_to(scaled(curve, 1.0, -1.0), -level);
}

double last_above(const Curve& curve, double level) {
  for (std::size_t k = curve.size(); k-- > 0;) {
    if (curve.y[k] > level) return curve.x[k];
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double mean_slope(const Curve& curve, double first, double last) {
  double count = 0.0;
  double mean_x = 0.0;
  double mean_y = 0.0;
  const auto takes = [&](std::size_t k) {
    return curve.x[k] >= first && curve.x[k] <= last && !std::isnan(curve.y[k]);
  };
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (!takes(k)) continue;
    count += 1.0;
    mean_x += (curve.x[k] - mean_x) / count;
    mean_y += (curve.y[k] - mean_y) / count;
  }
  if (count < 2.0) return kNone;
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (!takes(k)) continue;
    products += (curve.x[k] - mean_x) * (curve.y[k] - mean_y);
    squares += (curve.x[k] - mean_x) * (curve.x[k] - mean_x);
  }
  return products / squares;
}

double mean_value(const Curve& curve, double first, double last) {
  const Integral sum = integral(curve, first, last);
  return sum.length > 0.0 ? sum.value / sum.length : value_at(curve, first);
}

}  // namespace eisph
