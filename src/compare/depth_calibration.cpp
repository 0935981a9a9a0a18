#include "compare/depth_calibration.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kLeastTolerance = 2.0 / 255.0;
constexpr double kNoiseMargin = 3.0;           ///< standard deviations
constexpr int kSmoothingReach = 2;             ///< pixels to each side
constexpr float kSimilar = 0.1F;               ///< levels: neighbours that differ more show something else
constexpr double kUnusableShare = 0.01;        ///< of the pixels of the floor
constexpr double kNormalConsistency = 1.4826;  ///< standard deviation over median of absolute deviations

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

std::string level_text(double level) { return fmt::format("{:.1f} of 255", 255.0 * level); }

void check_falling(const std::vector<CalibrationPoint>& points, const std::vector<std::string>& names) {
  if (points.size() < 2)
    throw InputError(fmt::format("calibration with {} known depths; at least 2 are needed", points.size()));
  for (std::size_t k = 1; k < points.size(); ++k) {
    const CalibrationPoint& a = points[k - 1];
    const CalibrationPoint& b = points[k];
    if (a.depth < b.depth && a.level > b.level) continue;
    throw InputError(
        fmt::format("the calibration is not monotone: from {} ({:g} m, level {}) to {} ({:g} m, level {}) "
                    "depth has to rise "
                    "and the grey level to fall",
                    names[k - 1], a.depth, level_text(a.level), names[k], b.depth, level_text(b.level)));
  }
}

/// The order of the steps by depth.
std::vector<std::size_t> by_depth(const std::vector<CalibrationStep>& steps) {
  std::vector<std::size_t> order(steps.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return steps[a].depth < steps[b].depth; });
  return order;
}

void check_sizes(const std::vector<CalibrationStep>& steps, const std::vector<std::uint8_t>& mask) {
  for (const CalibrationStep& step : steps) {
    if (step.picture.level.size() == mask.size()) continue;
    throw InputError(fmt::format("{}: {} x {} pixels; the other pictures have {} pixels in all", step.name,
                                 step.picture.width, step.picture.height, mask.size()));
  }
  if (std::none_of(mask.begin(), mask.end(), [](std::uint8_t inside) { return inside != 0; }))
    throw InputError("the photographs show nothing of the floor that they are registered to");
}

double median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double masked_median(const std::vector<float>& level, const std::vector<std::uint8_t>& mask) {
  std::vector<float> inside;
  for (std::size_t k = 0; k < level.size(); ++k) {
    if (mask[k] != 0) inside.push_back(level[k]);
  }
  return median(inside);
}

/// Mean over the neighbourhood of those pixels that are like the middle one.
float smoothed_level(const GreyPicture& picture, int i, int j) {
  const float own = picture.at(i, j);
  float sum = 0.0F;
  float count = 0.0F;
  for (int v = std::max(0, j - kSmoothingReach); v <= std::min(picture.height - 1, j + kSmoothingReach);
       ++v) {
    for (int u = std::max(0, i - kSmoothingReach); u <= std::min(picture.width - 1, i + kSmoothingReach);
         ++u) {
      const float level = picture.at(u, v);
      if (std::abs(level - own) > kSimilar) continue;
      sum += level;
      count += 1.0F;
    }
  }
  return sum / count;
}

/// Standard deviation of the pixels' noise, from the difference to the mean of their surroundings.
double noise_of(const GreyPicture& picture, const std::vector<std::uint8_t>& mask) {
  std::vector<float> off;
  constexpr int kStride = 3;
  for (int j = 0; j < picture.height; j += kStride) {
    for (int i = 0; i < picture.width; i += kStride) {
      if (mask[picture.index(i, j)] != 0)
        off.push_back(std::abs(picture.at(i, j) - smoothed_level(picture, i, j)));
    }
  }
  return off.empty() ? 0.0 : kNormalConsistency * median(off);
}

double tolerance_for(double noise) { return std::max(kLeastTolerance, kNoiseMargin * noise); }

/// Slope at the point between two intervals of a monotone cubic; h: lengths, d: secants.
double inner_slope(double h0, double d0, double h1, double d1) {
  if (d0 * d1 <= 0.0) return 0.0;
  const double w0 = 2.0 * h1 + h0;
  const double w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// Slope at an end: of the parabola through three points, as far as the curve stays monotone.
double end_slope(double h0, double d0, double h1, double d1) {
  const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0.0) return 0.0;
  return d0 * d1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(d0) ? 3.0 * d0 : slope;
}

/// Depth of a level between points k and k + 1 of a curve with falling levels.
template <class LevelAt>
double interpolated(const std::vector<CalibrationPoint>& points, LevelAt&& level_at, std::size_t k,
                    double level) {
  const std::size_t last = points.size() - 1;
  const auto length = [&](std::size_t i) { return level_at(i) - level_at(i + 1); };
  const auto secant = [&](std::size_t i) { return (points[i + 1].depth - points[i].depth) / length(i); };
  const double h = length(k);
  const double d = secant(k);
  double slope0 = d;
  double slope1 = d;
  if (k > 0) slope0 = inner_slope(length(k - 1), secant(k - 1), h, d);
  if (k == 0 && last > 1) slope0 = end_slope(h, d, length(1), secant(1));
  if (k + 1 < last) slope1 = inner_slope(h, d, length(k + 1), secant(k + 1));
  if (k + 1 == last && last > 1) slope1 = end_slope(h, d, length(k - 1), secant(k - 1));
  const double t = (level_at(k) - level) / h;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * points[k].depth + (t3 - 2.0 * t2 + t) * h * slope0 +
         (3.0 * t2 - 2.0 * t3) * points[k + 1].depth + (t3 - t2) * h * slope1;
}

template <class LevelAt>
CalibratedDepth on_curve(const std::vector<CalibrationPoint>& points, LevelAt&& level_at, double tolerance,
                         double level) {
  const std::size_t last = points.size() - 1;
  if (level > level_at(0) + tolerance) return {kNone, LevelRange::TooBright};
  if (level < level_at(last) - tolerance) return {kNone, LevelRange::TooDark};
  if (level > level_at(0)) return {static_cast<float>(points[0].depth), LevelRange::Clamped};
  if (level < level_at(last)) return {static_cast<float>(points[last].depth), LevelRange::Clamped};
  std::size_t k = 0;
  while (k + 1 < last && level < level_at(k + 1)) ++k;
  return {static_cast<float>(interpolated(points, level_at, k, level)), LevelRange::Inside};
}

}  // namespace

DepthCalibration DepthCalibration::from_points(std::vector<CalibrationPoint> points,
                                               std::optional<double> tolerance) {
  std::stable_sort(points.begin(), points.end(),
                   [](const CalibrationPoint& a, const CalibrationPoint& b) { return a.depth < b.depth; });
  std::vector<std::string> names;
  for (std::size_t k = 0; k < points.size(); ++k) names.push_back(fmt::format("point {}", k + 1));
  check_falling(points, names);
  DepthCalibration calibration;
  calibration.points_ = std::move(points);
  calibration.tolerance_ = tolerance.value_or(kLeastTolerance);
  return calibration;
}

DepthCalibration DepthCalibration::whole_picture(const std::vector<CalibrationStep>& steps,
                                                 const std::vector<std::uint8_t>& mask,
                                                 std::optional<double> tolerance) {
  check_sizes(steps, mask);
  DepthCalibration calibration;
  std::vector<std::string> names;
  for (const std::size_t k : by_depth(steps)) {
    calibration.points_.push_back({masked_median(steps[k].picture.level, mask), steps[k].depth});
    names.push_back(steps[k].name);
    calibration.noise_ = std::max(calibration.noise_, noise_of(steps[k].picture, mask));
  }
  check_falling(calibration.points_, names);
  calibration.tolerance_ = tolerance.value_or(tolerance_for(calibration.noise_));
  return calibration;
}

DepthCalibration DepthCalibration::per_pixel(const std::vector<CalibrationStep>& steps,
                                             const std::vector<std::uint8_t>& mask,
                                             std::optional<double> tolerance) {
  DepthCalibration calibration = whole_picture(steps, mask, tolerance);
  calibration.prepare_pixels(steps, mask);
  return calibration;
}

void DepthCalibration::prepare_pixels(const std::vector<CalibrationStep>& steps,
                                      const std::vector<std::uint8_t>& mask) {
  const std::vector<std::size_t> order = by_depth(steps);
  const std::size_t count = order.size();
  levels_.assign(mask.size() * count, kNone);
  std::size_t inside = 0;
  const int width = steps.front().picture.width;
  for (std::size_t pixel = 0; pixel < mask.size(); ++pixel) {
    if (mask[pixel] == 0) continue;
    ++inside;
    float* levels = &levels_[pixel * count];
    bool falling = true;
    for (std::size_t k = 0; k < count; ++k) {
      levels[k] = smoothed_level(steps[order[k]].picture, static_cast<int>(pixel % width),
                                 static_cast<int>(pixel / width));
      falling = falling && (k == 0 || levels[k] < levels[k - 1]);
    }
    if (falling) continue;
    levels[0] = kNone;
    ++unusable_;
  }
  if (static_cast<double>(unusable_) <= kUnusableShare * static_cast<double>(inside)) return;
  throw InputError(fmt::format(
      "the calibration is not monotone in {:.1f} % of the pixels of the floor (at most {:g} %): there the "
      "grey "
      "level does not fall from each depth to the next; leave a depth out or calibrate the whole picture",
      100.0 * static_cast<double>(unusable_) / static_cast<double>(inside), 100.0 * kUnusableShare));
}

CalibratedDepth DepthCalibration::depth_of(std::size_t pixel, float level) const {
  if (points_.empty()) return {kNone, LevelRange::Unusable};
  if (levels_.empty()) {
    return on_curve(
        points_, [this](std::size_t k) { return points_[k].level; }, tolerance_, level);
  }
  const float* levels = &levels_[pixel * points_.size()];
  if (std::isnan(levels[0])) return {kNone, LevelRange::Unusable};
  return on_curve(
      points_, [levels](std::size_t k) { return static_cast<double>(levels[k]); }, tolerance_, level);
}

}  // namespace eisph
