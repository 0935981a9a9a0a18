#include "compare/curve_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace eisph {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The points of a curve that have a value and lie in [first, last].
Curve points_between(const Curve& curve, double first, double last) {
  Curve points;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const bool is_inside = curve.x[k] >= first && curve.x[k] <= last;
    if (is_inside && !std::isnan(curve.y[k])) points.add(curve.x[k], curve.y[k]);
  }
  return points;
}

/// Smallest value of a function in a bracket around a minimum (golden section).
template <typename Function>
double least_between(Function function, double low, double high) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  constexpr int kSteps = 60;  // shrinks the bracket by 3e-13
  for (int step = 0; step < kSteps; ++step) {
    const double left = high - ratio * (high - low);
    const double right = low + ratio * (high - low);
    if (function(left) <= function(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return 0.5 * (low + high);
}

double squared_distance_to_nearest(const PlanePoint& point, const std::vector<PlanePoint>& others) {
  double least = std::numeric_limits<double>::infinity();
  for (const PlanePoint& other : others) {
    const double dx = other.x - point.x;
    const double dz = other.z - point.z;
    least = std::min(least, dx * dx + dz * dz);
  }
  return least;
}

std::vector<PlanePoint> corners_of(const Curve& surface) {
  std::vector<PlanePoint> corners;
  for (std::size_t k = 0; k < surface.size(); ++k) {
    if (!std::isnan(surface.y[k])) corners.push_back({surface.x[k], surface.y[k]});
  }
  return corners;
}

}  // namespace

CurveDifference curve_difference(const Curve& model, const Curve& reference) {
  CurveDifference result;
  double squares = 0.0;
  double reference_squares = 0.0;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    const double difference = value_at(model, reference.x[k]) - reference.y[k];
    if (std::isnan(difference)) continue;
    ++result.points;
    squares += difference * difference;
    reference_squares += reference.y[k] * reference.y[k];
    result.bias += difference;
    result.max_abs = std::max(result.max_abs, std::abs(difference));
  }
  if (result.points == 0) return {.relative_l2 = kNone, .rms = kNone, .bias = kNone, .max_abs = kNone};
  const auto count = static_cast<double>(result.points);
  result.relative_l2 = reference_squares > 0.0 ? std::sqrt(squares / reference_squares) : kNone;
  result.rms = std::sqrt(squares / count);
  result.bias /= count;
  return result;
}

BandShare band_share(const Curve& model, const Curve& lower, const Curve& upper) {
  if (lower.x != upper.x) throw std::invalid_argument("The edges of a band need the same x");
  BandShare share;
  for (std::size_t k = 0; k < lower.size(); ++k) {
    const double value = value_at(model, lower.x[k]);
    if (std::isnan(value) || std::isnan(lower.y[k]) || std::isnan(upper.y[k])) continue;
    ++share.points;
    (value < lower.y[k] ? share.below : value > upper.y[k] ? share.above : share.inside) += 1.0;
  }
  if (share.points == 0) return {.inside = kNone, .below = kNone, .above = kNone};
  const auto count = static_cast<double>(share.points);
  share.inside /= count;
  share.below /= count;
  share.above /= count;
  return share;
}

ShiftedDifference best_shift(const Curve& model, const Curve& reference, double least, double most) {
  if (!(least <= most)) throw std::invalid_argument("The least shift is larger than the largest");
  if (model.empty()) return {.shift = kNone, .difference = curve_difference(model, reference)};
  const Curve judges = points_between(reference, model.x.front() + most, model.x.back() + least);
  const auto error_at = [&](double shift) {
    return curve_difference(shifted(model, shift), judges).relative_l2;
  };
  if (judges.empty() || std::isnan(error_at(least))) {
    return {.shift = kNone, .difference = curve_difference(Curve{}, judges)};
  }
  // A coarse search first: the error may have several minima.
  constexpr int kSamples = 200;
  const double step = (most - least) / kSamples;
  double best = least;
  double best_error = error_at(least);
  for (int sample = 1; sample <= kSamples; ++sample) {
    const double shift = least + sample * step;
    const double error = error_at(shift);
    if (error < best_error) {
      best = shift;
      best_error = error;
    }
  }
  const double refined = least_between(error_at, std::max(least, best - step), std::min(most, best + step));
  if (error_at(refined) < best_error) best = refined;
  return {.shift = best, .difference = curve_difference(shifted(model, best), judges)};
}

ProfileDifference profile_difference(const std::vector<PlanePoint>& measured, const Curve& surface,
                                     const std::vector<PlanePoint>& surface_points) {
  const std::vector<PlanePoint> corners = surface_points.empty() ? corners_of(surface) : surface_points;
  ProfileDifference result;
  double vertical_squares = 0.0;
  double nearest_squares = 0.0;
  for (const PlanePoint& point : measured) {
    nearest_squares += squared_distance_to_nearest(point, corners);
    const double difference = value_at(surface, point.x) - point.z;
    if (std::isnan(difference)) continue;
    ++result.points;
    vertical_squares += difference * difference;
    result.vertical_bias += difference;
  }
  const auto count = static_cast<double>(result.points);
  result.vertical_rms = result.points > 0 ? std::sqrt(vertical_squares / count) : kNone;
  result.vertical_bias = result.points > 0 ? result.vertical_bias / count : kNone;
  result.nearest_rms = measured.empty() || corners.empty()
                           ? kNone
                           : std::sqrt(nearest_squares / static_cast<double>(measured.size()));
  return result;
}

}  // namespace eisph
