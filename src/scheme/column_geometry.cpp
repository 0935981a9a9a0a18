#include "scheme/column_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace eisph {

namespace {

constexpr int kPoints = 8;  ///< along a side, in cells that curved or rotated shapes touch

bool is_upright_box(const Shape& shape) { return shape.kind == ShapeKind::Box && shape.rotation_z == 0.0; }

/// Where the mean over [lower, upper] of one axis has to be split: at the edges of upright boxes, and evenly
/// if other shapes are near.
std::vector<double> split_points(const Scene& scene, int axis, double lower, double upper, bool evenly) {
  std::vector<double> points{lower, upper};
  for (const FluidRegion& region : scene.fluid) {
    if (!is_upright_box(region.shape)) continue;
    for (const double edge : {region.shape.min[axis], region.shape.max[axis]}) {
      if (edge > lower && edge < upper) points.push_back(edge);
    }
  }
  for (int k = 1; evenly && k < kPoints; ++k) points.push_back(lower + (upper - lower) * k / kPoints);
  std::sort(points.begin(), points.end());
  return points;
}

bool touches(const Shape& shape, double x, double y, double size, int dimension) {
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  const bool in_x = upper.x() > x && lower.x() < x + size;
  return in_x && (dimension == 2 || (upper.y() > y && lower.y() < y + size));
}

}  // namespace

std::optional<VerticalExtent> vertical_extent(const Shape& shape, double x, double y, int dimension,
                                              double tolerance) {
  const bool flat = dimension == 2;
  if (shape.kind == ShapeKind::Box) {
    const Vec3d half = 0.5 * (shape.max - shape.min);
    const double dx = x - 0.5 * (shape.min.x() + shape.max.x());
    const double dy = flat ? 0.0 : y - 0.5 * (shape.min.y() + shape.max.y());
    const double c = std::cos(shape.rotation_z);
    const double s = std::sin(shape.rotation_z);
    const bool inside = std::abs(c * dx + s * dy) < half.x() - tolerance &&
                        (flat || std::abs(-s * dx + c * dy) < half.y() - tolerance);
    if (!inside) return std::nullopt;
    return VerticalExtent{shape.min.z(), shape.max.z()};
  }
  const double distance = std::hypot(x - shape.centre.x(), flat ? 0.0 : y - shape.centre.y());
  if (!(distance < shape.radius - tolerance)) return std::nullopt;
  if (shape.kind == ShapeKind::Cylinder) {
    return VerticalExtent{shape.centre.z(), shape.centre.z() + shape.height};
  }
  const double half_chord = std::sqrt(shape.radius * shape.radius - distance * distance);
  return VerticalExtent{shape.centre.z() - half_chord, shape.centre.z() + half_chord};
}

Scene without_cuts_of_solids(Scene scene) {
  const auto is_solid = [&](const FluidRegion& region) {
    const auto has_its_shape = [&](const auto& solid) { return solid.shape == region.shape; };
    return region.cut && (std::any_of(scene.obstacles.begin(), scene.obstacles.end(), has_its_shape) ||
                          std::any_of(scene.gates.begin(), scene.gates.end(), has_its_shape));
  };
  std::erase_if(scene.fluid, is_solid);
  return scene;
}

ColumnWater water_on_line(const Scene& scene, double x, double y, double bed) {
  std::vector<std::optional<VerticalExtent>> extents;
  std::vector<double> heights{bed};
  for (const FluidRegion& region : scene.fluid) {
    extents.push_back(vertical_extent(region.shape, x, y, scene.dimension));
    if (!extents.back()) continue;
    heights.push_back(std::max(extents.back()->lower, bed));
    heights.push_back(std::max(extents.back()->upper, bed));
  }
  std::sort(heights.begin(), heights.end());
  ColumnWater water;
  for (std::size_t k = 1; k < heights.size(); ++k) {
    const double middle = 0.5 * (heights[k - 1] + heights[k]);
    const double height = heights[k] - heights[k - 1];
    const FluidRegion* owner = nullptr;
    bool is_cut = false;
    for (std::size_t r = 0; r < extents.size(); ++r) {
      if (!extents[r] || middle < extents[r]->lower || middle > extents[r]->upper) continue;
      is_cut = is_cut || scene.fluid[r].cut;
      if (!scene.fluid[r].cut) owner = &scene.fluid[r];
    }
    if (owner == nullptr || is_cut) continue;
    water.depth += height;
    water.discharge_x += height * owner->velocity.x();
    water.discharge_y += height * owner->velocity.y();
  }
  return water;
}

ColumnWater water_in_cell(const Scene& scene, double x, double y, double size, double bed) {
  const bool near_water = std::any_of(scene.fluid.begin(), scene.fluid.end(), [&](const FluidRegion& region) {
    return !region.cut && touches(region.shape, x, y, size, scene.dimension);
  });
  if (!near_water) return {};
  const bool evenly = std::any_of(scene.fluid.begin(), scene.fluid.end(), [&](const FluidRegion& region) {
    return !is_upright_box(region.shape) && touches(region.shape, x, y, size, scene.dimension);
  });
  const bool flat = scene.dimension == 2;
  const std::vector<double> xs = split_points(scene, 0, x, x + size, evenly);
  const std::vector<double> ys =
      flat ? std::vector<double>{y, y + size} : split_points(scene, 1, y, y + size, evenly);
  ColumnWater mean;
  for (std::size_t j = 1; j < ys.size(); ++j) {
    for (std::size_t i = 1; i < xs.size(); ++i) {
      const ColumnWater water =
          water_on_line(scene, 0.5 * (xs[i - 1] + xs[i]), 0.5 * (ys[j - 1] + ys[j]), bed);
      const double share = (xs[i] - xs[i - 1]) / size * ((ys[j] - ys[j - 1]) / size);
      mean.depth += share * water.depth;
      mean.discharge_x += share * water.discharge_x;
      mean.discharge_y += share * water.discharge_y;
    }
  }
  return mean;
}

}  // namespace eisph
