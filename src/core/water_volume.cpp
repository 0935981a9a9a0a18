#include "core/water_volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace eisph {

namespace {

constexpr int kNodes = 20;  ///< of the quadrature between two breaks

struct Interval {
  double lower;
  double upper;
};

/// Nodes in (-1, 1) and weights of the Gauss-Legendre rule, by Newton's method on the Legendre polynomial.
struct GaussRule {
  std::array<double, kNodes> node{};
  std::array<double, kNodes> weight{};

  GaussRule() {
    for (std::size_t k = 0; k < kNodes; ++k) {
      double x = std::cos(std::numbers::pi * (static_cast<double>(k) + 0.75) / (kNodes + 0.5));
      double slope = 1.0;
      for (int iteration = 0; iteration < 50; ++iteration) {
        double value = x;
        double before = 1.0;
        for (int n = 2; n <= kNodes; ++n) {
          const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
          before = value;
          value = next;
        }
        slope = kNodes * (x * value - before) / (x * x - 1.0);
        x -= value / slope;
        if (std::abs(value / slope) < 1e-15) break;
      }
      node[k] = x;
      weight[k] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
  }
};

/// Integral of f between neighbouring breaks within [lower, upper]. The substitution x = m + r sin(theta)
/// takes away square roots at the ends, such as circles have.
template <class Function>
double integrate(std::vector<double> breaks, double lower, double upper, const Function& f) {
  static const GaussRule rule;
  std::erase_if(breaks, [&](double at) { return !(at > lower && at < upper); });
  breaks.push_back(lower);
  breaks.push_back(upper);
  std::sort(breaks.begin(), breaks.end());
  double sum = 0.0;
  for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
    const double middle = 0.5 * (breaks[b] + breaks[b + 1]);
    const double radius = 0.5 * (breaks[b + 1] - breaks[b]);
    if (!(radius > 0.0)) continue;
    for (std::size_t k = 0; k < kNodes; ++k) {
      const double theta = 0.5 * std::numbers::pi * rule.node[k];
      const double weight = 0.5 * std::numbers::pi * rule.weight[k] * radius * std::cos(theta);
      sum += weight * f(middle + radius * std::sin(theta));
    }
  }
  return sum;
}

/// Half of the chord of a circle at `offset` from its centre; nothing beyond it.
std::optional<double> half_chord(double radius, double offset) {
  const double squared = radius * radius - offset * offset;
  return squared > 0.0 ? std::optional(std::sqrt(squared)) : std::nullopt;
}

void add_pair(std::vector<double>& breaks, double centre, std::optional<double> half) {
  if (!half) return;
  breaks.push_back(centre - *half);
  breaks.push_back(centre + *half);
}

/// Water along verticals, and where its derivatives jump across them.
class Verticals {
 public:
  explicit Verticals(const Scene& scene) : scene_(scene), flat_(scene.dimension == 2) {
    levels_ = {scene.domain_min.z(), scene.domain_max.z()};
    for (const FluidRegion& region : scene.fluid) {
      Vec3d lower;
      Vec3d upper;
      region.shape.bounds(lower, upper);
      if (region.shape.kind == ShapeKind::Sphere) continue;
      levels_.insert(levels_.end(), {lower.z(), upper.z()});
      if (region.shape.kind == ShapeKind::Box && region.shape.rotation_z == 0.0) {
        sides_.insert(sides_.end(), {lower.y(), upper.y()});
      }
    }
    sides_.insert(sides_.end(), {scene.domain_min.y(), scene.domain_max.y()});
  }

  /// Length of the water over (x, y), m.
  [[nodiscard]] double length(double x, double y) const {
    std::vector<double> ends;
    std::vector<Interval> added;
    std::vector<Interval> cut;
    for (const FluidRegion& region : scene_.fluid) {
      const std::optional<Interval> chord = vertical_chord(region.shape, x, y);
      if (!chord) continue;
      (region.cut ? cut : added).push_back(*chord);
      ends.insert(ends.end(), {chord->lower, chord->upper});
    }
    for (double& end : ends) end = std::clamp(end, scene_.domain_min.z(), scene_.domain_max.z());
    std::sort(ends.begin(), ends.end());
    const auto in_any = [](const std::vector<Interval>& intervals, double z) {
      return std::any_of(intervals.begin(), intervals.end(),
                         [&](const Interval& interval) { return z > interval.lower && z < interval.upper; });
    };
    double sum = 0.0;
    for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
      const double middle = 0.5 * (ends[e] + ends[e + 1]);
      if (in_any(added, middle) && !in_any(cut, middle)) sum += ends[e + 1] - ends[e];
    }
    return sum;
  }

  [[nodiscard]] std::vector<double> breaks_in_x() const {
    std::vector<double> breaks;
    for (const FluidRegion& region : scene_.fluid) {
      const Shape& shape = region.shape;
      if (shape.kind == ShapeKind::Box) {
        for (const Vec3d& corner : corners(shape)) breaks.push_back(corner.x());
        continue;
      }
      add_pair(breaks, shape.centre.x(), shape.radius);
      if (!flat_) {
        for (const double y : sides_) {
          add_pair(breaks, shape.centre.x(), half_chord(shape.radius, y - shape.centre.y()));
        }
      }
      if (shape.kind != ShapeKind::Sphere) continue;
      for (const double z : levels_) {
        add_pair(breaks, shape.centre.x(), half_chord(shape.radius, z - shape.centre.z()));
      }
    }
    return breaks;
  }

  [[nodiscard]] std::vector<double> breaks_in_y(double x) const {
    std::vector<double> breaks;
    for (const FluidRegion& region : scene_.fluid) {
      const Shape& shape = region.shape;
      if (shape.kind == ShapeKind::Box) {
        add_edge_crossings(shape, x, breaks);
        continue;
      }
      const std::optional<double> half = half_chord(shape.radius, x - shape.centre.x());
      add_pair(breaks, shape.centre.y(), half);
      if (shape.kind != ShapeKind::Sphere || !half) continue;
      for (const double z : levels_) {
        add_pair(breaks, shape.centre.y(), half_chord(*half, z - shape.centre.z()));
      }
    }
    return breaks;
  }

 private:
  /// Of the footprint of a box, in the order of its outline.
  [[nodiscard]] static std::array<Vec3d, 4> corners(const Shape& box) {
    const Vec3d centre = 0.5 * (box.min + box.max);
    const Vec3d half = 0.5 * (box.max - box.min);
    const double c = std::cos(box.rotation_z);
    const double s = std::sin(box.rotation_z);
    std::array<Vec3d, 4> found;
    const std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = signs[k][0] * half.x();
      const double y = signs[k][1] * half.y();
      found[k] = centre + Vec3d(c * x - s * y, s * x + c * y, 0.0);
    }
    return found;
  }

  /// Where the outline of a box's footprint crosses the line at x.
  static void add_edge_crossings(const Shape& box, double x, std::vector<double>& breaks) {
    const std::array<Vec3d, 4> corner = corners(box);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3d& from = corner[k];
      const Vec3d& to = corner[(k + 1) % 4];
      if ((from.x() - x) * (to.x() - x) > 0.0 || from.x() == to.x()) continue;
      breaks.push_back(from.y() + (to.y() - from.y()) * (x - from.x()) / (to.x() - from.x()));
    }
  }

  /// Where the vertical over (x, y) is in the shape, m.
  [[nodiscard]] std::optional<Interval> vertical_chord(const Shape& shape, double x, double y) const {
    const double across = flat_ ? 0.0 : y - shape.centre.y();
    const double along = x - shape.centre.x();
    switch (shape.kind) {
      case ShapeKind::Sphere: {
        const std::optional<double> half = half_chord(shape.radius, std::hypot(along, across));
        if (!half) return std::nullopt;
        return Interval{shape.centre.z() - *half, shape.centre.z() + *half};
      }
      case ShapeKind::Cylinder:
        if (!(std::hypot(along, across) < shape.radius)) return std::nullopt;
        return Interval{shape.centre.z(), shape.centre.z() + shape.height};
      case ShapeKind::Box:
        break;
    }
    const Vec3d middle(x, y, 0.5 * (shape.min.z() + shape.max.z()));
    if (!shape.contains(middle, scene_.dimension)) return std::nullopt;
    return Interval{shape.min.z(), shape.max.z()};
  }

  const Scene& scene_;
  bool flat_;
  std::vector<double> levels_;  ///< of horizontal faces
  std::vector<double> sides_;   ///< y of upright faces
};

}  // namespace

double water_volume(const Scene& scene) {
  const Verticals verticals(scene);
  const auto section = [&](double x) {
    if (scene.dimension == 2) return verticals.length(x, 0.0);
    return integrate(verticals.breaks_in_y(x), scene.domain_min.y(), scene.domain_max.y(),
                     [&](double y) { return verticals.length(x, y); });
  };
  return integrate(verticals.breaks_in_x(), scene.domain_min.x(), scene.domain_max.x(), section);
}

}  // namespace eisph
