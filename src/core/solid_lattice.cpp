#include "core/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace eisph {

namespace {

constexpr double kPi = std::numbers::pi;
/// Fraction of the spacing within which a point counts as on a surface.
constexpr double kTolerance = 1e-6;

/// How many layers of at most `spacing` fill `length`.
std::size_t layer_count(double length, double spacing, double least) {
  return static_cast<std::size_t>(std::max(least, std::ceil(length / spacing - kTolerance)));
}

/// Layers along one axis between two faces.
struct AxisLayers {
  std::vector<double> offset;        ///< m from the middle
  std::vector<double> depth;         ///< m below the nearer face
  std::vector<std::size_t> shallow;  ///< those no deeper than the limit
  double step = 1.0;                 ///< m, distance of two layers

  AxisLayers(double length, double spacing, double depth_limit) {
    const std::size_t count = layer_count(length, spacing, 2.0);
    step = length / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
      offset.push_back((static_cast<double>(k) + 0.5) * step - 0.5 * length);
      depth.push_back((static_cast<double>(std::min(k, count - 1 - k)) + 0.5) * step);
      if (depth.back() <= depth_limit) shallow.push_back(k);
    }
  }
  /// The axis that a two-dimensional scene does not have: one point, infinitely far from any face.
  AxisLayers() : offset{0.0}, depth{std::numeric_limits<double>::infinity()} {}
};

void add_particle(SolidLattice& lattice, const Vec3d& position, double volume) {
  lattice.position.push_back(position);
  lattice.volume.push_back(volume);
}

SolidLattice box_lattice(const Shape& box, double spacing, double depth, int dimension) {
  const Vec3d size = box.max - box.min;
  const AxisLayers x(size.x(), spacing, depth);
  const AxisLayers y = dimension == 2 ? AxisLayers() : AxisLayers(size.y(), spacing, depth);
  const AxisLayers z(size.z(), spacing, depth);

  SolidLattice lattice;
  lattice.spacing = std::max({x.step, z.step, dimension == 2 ? 0.0 : y.step});
  const double volume = x.step * y.step * z.step;
  Vec3d centre = 0.5 * (box.min + box.max);
  if (dimension == 2) centre.y() = 0.0;
  const double c = std::cos(box.rotation_z);
  const double s = std::sin(box.rotation_z);
  const auto add = [&](std::size_t i, std::size_t j, std::size_t k) {
    const Vec3d local(x.offset[i], y.offset[j], z.offset[k]);
    add_particle(lattice,
                 centre + Vec3d(c * local.x() - s * local.y(), s * local.x() + c * local.y(), local.z()),
                 volume);
  };
  for (std::size_t k = 0; k < z.offset.size(); ++k) {
    for (std::size_t j = 0; j < y.offset.size(); ++j) {
      if (std::min(z.depth[k], y.depth[j]) <= depth) {
        for (std::size_t i = 0; i < x.offset.size(); ++i) add(i, j, k);
      } else {
        for (const std::size_t i : x.shallow) add(i, j, k);
      }
    }
  }
  return lattice;
}

/// `visit(radius, layer_depth, inner, outer)` for concentric layers from the surface inwards; lengths in
/// metres.
template <class Visit>
void visit_shells(double radius, double spacing, const Visit& visit) {
  const std::size_t count = layer_count(radius, spacing, 1.0);
  const double step = radius / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double outer = radius - static_cast<double>(k) * step;
    const double inner = k + 1 == count ? 0.0 : outer - step;
    visit(0.5 * (outer + inner), radius - 0.5 * (outer + inner), inner, outer);
  }
}

/// Points on a circle about `spacing` apart, as unit vectors (cosine, sine).
std::vector<std::pair<double, double>> circle_points(double radius, double spacing) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(2.0 * kPi * radius / spacing)));
  std::vector<std::pair<double, double>> points;
  for (std::size_t m = 0; m < count; ++m) {
    const double angle = 2.0 * kPi * static_cast<double>(m) / static_cast<double>(count);
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  return points;
}

SolidLattice cylinder_lattice(const Shape& cylinder, double spacing, double depth) {
  const AxisLayers z(cylinder.height, spacing, depth);
  SolidLattice lattice;
  lattice.spacing = z.step;
  visit_shells(cylinder.radius, spacing, [&](double radius, double radial_depth, double inner, double outer) {
    const auto circle = circle_points(radius, std::min(spacing, outer - inner));
    const auto count = static_cast<double>(circle.size());
    const double volume = kPi * (outer * outer - inner * inner) * z.step / count;
    for (std::size_t k = 0; k < z.offset.size(); ++k) {
      if (std::min(radial_depth, z.depth[k]) > depth) continue;
      lattice.spacing = std::max({lattice.spacing, outer - inner, 2.0 * radius * std::sin(kPi / count)});
      const double height = 0.5 * cylinder.height + z.offset[k];
      for (const auto& [cosine, sine] : circle) {
        add_particle(lattice, cylinder.centre + Vec3d(radius * cosine, radius * sine, height), volume);
      }
    }
  });
  return lattice;
}

SolidLattice disc_lattice(const Shape& disc, double spacing, double depth) {
  SolidLattice lattice;
  const Vec3d centre(disc.centre.x(), 0.0, disc.centre.z());
  visit_shells(disc.radius, spacing, [&](double radius, double shell_depth, double inner, double outer) {
    if (shell_depth > depth) return;
    const auto circle = circle_points(radius, std::min(spacing, outer - inner));
    const auto count = static_cast<double>(circle.size());
    const double area = kPi * (outer * outer - inner * inner) / count;
    lattice.spacing = std::max({lattice.spacing, outer - inner, 2.0 * radius * std::sin(kPi / count)});
    for (const auto& [cosine, sine] : circle) {
      add_particle(lattice, centre + Vec3d(radius * cosine, 0.0, radius * sine), area);
    }
  });
  return lattice;
}

/// Each shell carries a Fibonacci spiral: point m of n at height 1 - (2 m + 1) / n, turned by the golden
/// angle.
SolidLattice ball_lattice(const Shape& ball, double spacing, double depth) {
  const double golden_angle = kPi * (3.0 - std::sqrt(5.0));
  SolidLattice lattice;
  visit_shells(ball.radius, spacing, [&](double radius, double shell_depth, double inner, double outer) {
    if (shell_depth > depth) return;
    const double step = outer - inner;
    const double shell_volume = 4.0 / 3.0 * kPi * (outer * outer * outer - inner * inner * inner);
    const auto count =
        static_cast<std::size_t>(std::max(1.0, std::round(shell_volume / (step * step * step))));
    lattice.spacing =
        std::max({lattice.spacing, step, radius * std::sqrt(4.0 * kPi / static_cast<double>(count))});
    for (std::size_t m = 0; m < count; ++m) {
      const double height = 1.0 - (2.0 * static_cast<double>(m) + 1.0) / static_cast<double>(count);
      const double across = std::sqrt(1.0 - height * height);
      const double angle = golden_angle * static_cast<double>(m);
      const Vec3d direction(across * std::cos(angle), across * std::sin(angle), height);
      add_particle(lattice, ball.centre + radius * direction, shell_volume / static_cast<double>(count));
    }
  });
  return lattice;
}

}  // namespace

SolidLattice solid_lattice(const Shape& shape, double spacing, double depth, int dimension) {
  const double limit = depth + kTolerance * spacing;
  switch (shape.kind) {
    case ShapeKind::Sphere:
      return dimension == 2 ? disc_lattice(shape, spacing, limit) : ball_lattice(shape, spacing, limit);
    case ShapeKind::Cylinder:
      return cylinder_lattice(shape, spacing, limit);
    case ShapeKind::Box:
      break;
  }
  return box_lattice(shape, spacing, limit, dimension);
}

double solid_particle_estimate(const Shape& shape, double spacing, double depth, int dimension) {
  Shape whole = shape;  // at least two layers thick
  whole.min = Vec3d::Zero();
  whole.max = (shape.max - shape.min).cwiseMax(2.0 * spacing);
  whole.radius = std::max(shape.radius, spacing);
  whole.height = std::max(shape.height, 2.0 * spacing);
  Shape core = whole;
  core.max = (whole.max.array() - 2.0 * depth).cwiseMax(0.0);
  core.radius = std::max(0.0, whole.radius - depth);
  core.height = std::max(0.0, whole.height - 2.0 * depth);
  return (whole.volume(dimension) - core.volume(dimension)) / std::pow(spacing, dimension);
}

SceneSolids scene_solids(const Scene& scene) {
  std::vector<std::pair<std::string, Shape>> shapes;
  for (const Obstacle& obstacle : scene.obstacles) shapes.emplace_back(obstacle.name, obstacle.shape);
  for (const Gate& gate : scene.gates) shapes.emplace_back(gate.name, gate.shape);

  const double tolerance = kTolerance * scene.particle_spacing;
  const auto in_domain = [&](const Vec3d& point) {
    for (const int axis : {0, 1, 2}) {
      if (scene.dimension == 2 && axis == 1) continue;
      if (point[axis] < scene.domain_min[axis] + tolerance ||
          point[axis] > scene.domain_max[axis] - tolerance) {
        return false;
      }
    }
    return true;
  };

  SceneSolids solids;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const SolidLattice lattice =
        solid_lattice(shapes[s].second, scene.particle_spacing, scene.support_radius(), scene.dimension);
    const std::size_t first = solids.position.size();
    for (std::size_t p = 0; p < lattice.position.size(); ++p) {
      const Vec3d& point = lattice.position[p];
      const bool taken = std::any_of(
          shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(s), [&](const auto& earlier) {
            return earlier.second.signed_distance(point, scene.dimension) < -tolerance;
          });
      if (taken || !in_domain(point)) continue;
      solids.position.push_back(point);
      solids.volume.push_back(lattice.volume[p]);
    }
    solids.ranges.push_back({shapes[s].first, first, solids.position.size() - first});
    solids.spacing = std::max(solids.spacing, lattice.spacing);
  }
  return solids;
}

}  // namespace eisph
