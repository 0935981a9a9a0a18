#include "compare/tank_outline.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace eisph {

namespace {

using Eigen::Vector2d;

constexpr int kBins = 256;
constexpr double kLeastShare = 0.05;    ///< of the picture that the floor takes up
constexpr double kLeastContrast = 0.1;  ///< levels between floor and surroundings
constexpr double kNear = 2.0;           ///< pixels from a line that count as on it
constexpr std::size_t kTrials = 48;     ///< points that candidate lines are drawn through
constexpr double kLeastOnLine = 0.4;    ///< of the points of an edge
constexpr int kRefinements = 5;

/// Threshold that parts the levels into two classes of the least variance, and the distance of their means.
struct Threshold {
  double level = 0.0;
  double contrast = 0.0;
};

Threshold otsu_threshold(const GreyPicture& photograph) {
  std::array<double, kBins> counts{};
  for (const float level : photograph.level) {
    counts[static_cast<std::size_t>(std::lround(std::clamp(level, 0.0F, 1.0F) * (kBins - 1)))] += 1.0;
  }
  double all = 0.0;
  double sum = 0.0;
  for (int k = 0; k < kBins; ++k) {
    all += counts[static_cast<std::size_t>(k)];
    sum += k * counts[static_cast<std::size_t>(k)];
  }
  Threshold best;
  double best_variance = -1.0;
  double below = 0.0;
  double below_sum = 0.0;
  for (int k = 0; k + 1 < kBins; ++k) {
    below += counts[static_cast<std::size_t>(k)];
    below_sum += k * counts[static_cast<std::size_t>(k)];
    if (below == 0.0 || below == all) continue;
    const double low = below_sum / below;
    const double high = (sum - below_sum) / (all - below);
    const double variance = below * (all - below) * (high - low) * (high - low);
    if (variance <= best_variance) continue;
    best_variance = variance;
    // Half way between the classes, where an edge of blurred pixels lies.
    best = {0.5 * (low + high) / (kBins - 1), (high - low) / (kBins - 1)};
  }
  return best;
}

/// Pixels of the largest region above the threshold whose pixels have common sides: 1.
std::vector<std::uint8_t> largest_region(const GreyPicture& photograph, double threshold, std::size_t& size) {
  std::vector<std::int32_t> label(photograph.level.size(), 0);
  std::vector<std::size_t> stack;
  std::int32_t labels = 0;
  std::int32_t largest = 0;
  size = 0;
  for (std::size_t start = 0; start < label.size(); ++start) {
    if (label[start] != 0 || photograph.level[start] <= threshold) continue;
    ++labels;
    std::size_t count = 0;
    stack.push_back(start);
    label[start] = labels;
    while (!stack.empty()) {
      const std::size_t pixel = stack.back();
      stack.pop_back();
      ++count;
      const auto i = static_cast<int>(pixel % photograph.width);
      const auto j = static_cast<int>(pixel / photograph.width);
      for (const auto& [di, dj] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        const int u = i + di;
        const int v = j + dj;
        if (u < 0 || v < 0 || u >= photograph.width || v >= photograph.height) continue;
        const std::size_t neighbour = photograph.index(u, v);
        if (label[neighbour] != 0 || photograph.level[neighbour] <= threshold) continue;
        label[neighbour] = labels;
        stack.push_back(neighbour);
      }
    }
    if (count > size) {
      size = count;
      largest = labels;
    }
  }
  std::vector<std::uint8_t> region(label.size());
  for (std::size_t k = 0; k < label.size(); ++k) region[k] = label[k] == largest && largest != 0 ? 1 : 0;
  return region;
}

/// One side of the region: along each row or column the place where the level crosses the threshold, as
/// (position along the side, position across it).
std::vector<Vector2d> side_points(const GreyPicture& photograph, const std::vector<std::uint8_t>& region,
                                  double threshold, bool by_rows, bool from_start) {
  const int lines = by_rows ? photograph.height : photograph.width;
  const int length = by_rows ? photograph.width : photograph.height;
  const auto pixel = [&](int line, int k) {
    return by_rows ? photograph.index(k, line) : photograph.index(line, k);
  };
  std::vector<Vector2d> points;
  for (int line = 0; line < lines; ++line) {
    const int step = from_start ? 1 : -1;
    int k = from_start ? 0 : length - 1;
    while (k >= 0 && k < length && region[pixel(line, k)] == 0) k += step;
    const int outside = k - step;
    if (k < 0 || k >= length || outside < 0 || outside >= length) continue;
    const double inner = photograph.level[pixel(line, k)];
    const double outer = photograph.level[pixel(line, outside)];
    const double share = (threshold - outer) / (inner - outer);
    points.emplace_back(line + 0.5, outside + 0.5 + step * share);
  }
  return points;
}

/// across = offset + slope * along
struct EdgeLine {
  double offset = 0.0;
  double slope = 0.0;
  [[nodiscard]] double distance(const Vector2d& point) const {
    return std::abs(point.y() - offset - slope * point.x()) / std::sqrt(1.0 + slope * slope);
  }
};

EdgeLine least_squares(const std::vector<Vector2d>& points) {
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  double xx = 0.0;
  double xy = 0.0;
  for (const Vector2d& point : points) {
    xx += (point.x() - mean.x()) * (point.x() - mean.x());
    xy += (point.x() - mean.x()) * (point.y() - mean.y());
  }
  const double slope = xx > 0.0 ? xy / xx : 0.0;
  return {mean.y() - slope * mean.x(), slope};
}

std::vector<Vector2d> near_line(const std::vector<Vector2d>& points, const EdgeLine& line, double reach) {
  std::vector<Vector2d> near;
  for (const Vector2d& point : points) {
    if (line.distance(point) <= reach) near.push_back(point);
  }
  return near;
}

/// The line through two of the points that has the most points near it.
EdgeLine most_supported_line(const std::vector<Vector2d>& points) {
  EdgeLine best;
  std::size_t most = 0;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kTrials);
  for (std::size_t a = 0; a < points.size(); a += stride) {
    for (std::size_t b = a + stride; b < points.size(); b += stride) {
      const double slope = (points[b].y() - points[a].y()) / (points[b].x() - points[a].x());
      const EdgeLine line{points[a].y() - slope * points[a].x(), slope};
      if (std::abs(slope) > 1.0) continue;
      const std::size_t count = near_line(points, line, kNear).size();
      if (count > most) {
        most = count;
        best = line;
      }
    }
  }
  return best;
}

struct FittedEdge {
  EdgeLine line;
  double bow = 0.0;
};

FittedEdge fit_edge(const std::vector<Vector2d>& points, const char* name) {
  EdgeLine line = most_supported_line(points);
  std::vector<Vector2d> near;
  for (int k = 0; k < kRefinements; ++k) {
    near = near_line(points, line, kNear);
    if (static_cast<double>(near.size()) < kLeastOnLine * static_cast<double>(points.size()) ||
        near.size() < 10) {
      throw InputError(fmt::format(
          "no outline of the floor is found: its {} edge is not straight; give reference points instead",
          name));
    }
    line = least_squares(near);
  }
  // Points near corners belong to two edges, and single ones are noise: the largest but for a twentieth.
  std::vector<double> distances;
  distances.reserve(near.size());
  for (const Vector2d& point : near) distances.push_back(line.distance(point));
  std::sort(distances.begin(), distances.end());
  return {line, distances[distances.size() * 19 / 20]};
}

/// Where a line x = offset + slope y meets a line y = offset + slope x.
Vector2d intersection(const EdgeLine& upright, const EdgeLine& level) {
  const double x = (upright.offset + upright.slope * level.offset) / (1.0 - upright.slope * level.slope);
  return {x, level.offset + level.slope * x};
}

}  // namespace

TankOutline find_tank_outline(const GreyPicture& photograph) {
  const Threshold threshold = otsu_threshold(photograph);
  std::size_t size = 0;
  const std::vector<std::uint8_t> region = largest_region(photograph, threshold.level, size);
  const auto pixels = static_cast<double>(photograph.level.size());
  if (threshold.contrast < kLeastContrast || static_cast<double>(size) < kLeastShare * pixels) {
    throw InputError(
        "no outline of the floor is found: there is no large region brighter than its surroundings; give "
        "reference points instead");
  }
  const auto edge = [&](bool by_rows, bool from_start, const char* name) {
    return fit_edge(side_points(photograph, region, threshold.level, by_rows, from_start), name);
  };
  const FittedEdge left = edge(true, true, "left");
  const FittedEdge right = edge(true, false, "right");
  const FittedEdge upper = edge(false, true, "upper");
  const FittedEdge lower = edge(false, false, "lower");
  return {{intersection(left.line, lower.line), intersection(right.line, lower.line),
           intersection(right.line, upper.line), intersection(left.line, upper.line)},
          std::max({left.bow, right.bow, upper.bow, lower.bow})};
}

}  // namespace eisph
