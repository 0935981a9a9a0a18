#pragma once

#include <cstddef>
#include <vector>

namespace eisph {

/// Values y over ascending x, joined by straight lines. A y that is not a number is a gap: functions skip it,
/// and there is no value between it and its neighbours.
struct Curve {
  std::vector<double> x = {};
  std::vector<double> y = {};

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool empty() const { return x.empty(); }
  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

/// A curve from points in any order. Equal x are merged into their mean. Throws std::invalid_argument if the
/// lengths differ.
[[nodiscard]] Curve make_curve(const std::vector<double>& x, const std::vector<double>& y);

/// Linear interpolation; not a number outside the curve's range and in its gaps.
[[nodiscard]] double value_at(const Curve& curve, double x);

/// x * x_factor and y * y_factor (x_factor > 0): for example from s and m to dimensionless figures.
[[nodiscard]] Curve scaled(Curve curve, double x_factor, double y_factor);
/// x + x_offset and y + y_offset.
[[nodiscard]] Curve shifted(Curve curve, double x_offset, double y_offset = 0.0);
/// The points with first <= x <= last, and interpolated ones at first and last where the curve crosses them.
[[nodiscard]] Curve restricted(const Curve& curve, double first, double last);
/// The curve with its end values held to first and last, as far as these lie outside its range.
[[nodiscard]] Curve extended(Curve curve, double first, double last);
/// The values of a curve at other places.
[[nodiscard]] Curve resampled(const Curve& curve, const std::vector<double>& x);

/// Mean over [x - width/2, x + width/2] of the straight lines at every point; near the ends the window
/// shrinks on both sides alike. Width in units of x.
[[nodiscard]] Curve moving_average(const Curve& curve, double width);
/// Root mean square of the difference between a curve and its moving average: how noisy it is.
[[nodiscard]] double noise(const Curve& curve, double width);

struct CurvePoint {
  double x;
  double y;
};
/// The first of the highest (lowest) points; not-a-number if the curve has no value.
[[nodiscard]] CurvePoint highest_point(const Curve& curve);
[[nodiscard]] CurvePoint lowest_point(const Curve& curve);
/// Where the curve first comes from below `level` to it or above; its first x if it starts there; not a
/// number if it never does.
[[nodiscard]] double first_rise_to(const Curve& curve, double level);
/// Where it first falls from above `level` to it or below, likewise.
[[nodiscard]] double first_fall_to(const Curve& curve, double level);
/// The last point of the curve that lies above `level`, for example the front of a wave; not a number if none
/// does.
[[nodiscard]] double last_above(const Curve& curve, double level);
/// Slope of the straight line of least squares through the points with first <= x <= last, for example the
/// speed of a front; not a number with fewer than two.
[[nodiscard]] double mean_slope(const Curve& curve, double first, double last);
/// Mean of the straight lines over [first, last].
[[nodiscard]] double mean_value(const Curve& curve, double first, double last);

}  // namespace eisph
