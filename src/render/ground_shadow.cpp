#include "render/ground_shadow.hpp"

#include "render/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace eisph {

namespace {

constexpr double kMostCells = 512.0;                    ///< along the longer side
constexpr float kSolidOpacity = 0.32F;                  ///< of one layer
constexpr double kBlurPerHeight = 0.45;                 ///< radius of the blur over the height of a layer
constexpr std::array kLayerTops{0.12, 0.35, 0.8, 1.6};  ///< over the scene's depth; the last has no top
constexpr std::size_t kLayers = kLayerTops.size();

using Coverage = std::vector<float>;

double middle_of(std::size_t layer) {
  return 0.5 * (kLayerTops[layer] + (layer == 0 ? 0.0 : kLayerTops[layer - 1]));
}

/// Cells over the floor.
class FloorCells {
 public:
  explicit FloorCells(const Scene& scene) : lower_(scene.domain_min) {
    const Vec3d size = scene.domain_max - scene.domain_min;
    const double wanted = std::max(scene.particle_spacing, size.head<2>().maxCoeff() / kMostCells);
    columns_ = std::max(1, static_cast<int>(std::lround(size.x() / wanted)));
    rows_ = std::max(1, static_cast<int>(std::lround(size.y() / wanted)));
    cell_ = {size.x() / columns_, size.y() / rows_};
  }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(columns_) * rows_; }
  [[nodiscard]] double side(int axis) const { return cell_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] double centre(int axis, int k) const { return lower_[axis] + (k + 0.5) * side(axis); }
  /// Of the cell that has the coordinate, beyond the floor the nearest one.
  [[nodiscard]] int index(int axis, double coordinate) const {
    const double last = (axis == 0 ? columns_ : rows_) - 1.0;
    return static_cast<int>(std::clamp(std::floor((coordinate - lower_[axis]) / side(axis)), 0.0, last));
  }
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

 private:
  Vec3d lower_;
  int columns_ = 1;
  int rows_ = 1;
  std::array<double, 2> cell_{};
};

std::array<Coverage, kLayers> water_outlines(const Scene& scene, const Snapshot& snapshot,
                                             const FloorCells& cells) {
  std::array<Coverage, kLayers> layers;
  layers.fill(Coverage(cells.count(), 0.0F));
  const double depth = depth_scale(scene);
  for (const Vec3f& position : snapshot.position) {
    if (!position.allFinite()) continue;
    const double height = (position.z() - scene.domain_min.z()) / depth;
    std::size_t layer = 0;
    while (layer + 1 < kLayers && height > kLayerTops[layer]) ++layer;
    layers[layer][cells.place(cells.index(0, position.x()), cells.index(1, position.y()))] = 1.0F;
  }
  return layers;
}

void add_solid(Coverage& layer, const Shape& shape, double height, const FloorCells& cells) {
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  if (height < lower.z() || height > upper.z()) return;
  for (int row = cells.index(1, lower.y()); row <= cells.index(1, upper.y()); ++row) {
    for (int column = cells.index(0, lower.x()); column <= cells.index(0, upper.x()); ++column) {
      const Vec3d point(cells.centre(0, column), cells.centre(1, row), height);
      if (shape.contains(point, 3)) layer[cells.place(column, row)] = 1.0F;
    }
  }
}

Coverage solid_outlines(const Scene& scene, double time, std::size_t layer, const FloorCells& cells) {
  Coverage outlines(cells.count(), 0.0F);
  const double height = scene.domain_min.z() + middle_of(layer) * depth_scale(scene);
  for (const Obstacle& obstacle : scene.obstacles) add_solid(outlines, obstacle.shape, height, cells);
  for (const Gate& gate : scene.gates) {
    if (const auto lift = gate.lift(time)) add_solid(outlines, gate.shape, height - *lift, cells);
  }
  return outlines;
}

/// Mean over `reach` cells to both sides along one axis, mirrored at the ends.
Coverage box_blur(const Coverage& from, int count, int lines, std::size_t stride, std::size_t line_stride,
                  int reach) {
  Coverage to(from.size());
  const auto mirrored = [count](int k) {
    if (k >= 0 && k < count) return static_cast<std::size_t>(k);
    const int period = 2 * count;
    const int inside = ((k % period) + period) % period;
    return static_cast<std::size_t>(inside < count ? inside : period - 1 - inside);
  };
  const float share = 1.0F / static_cast<float>(2 * reach + 1);
  for (int line = 0; line < lines; ++line) {
    const std::size_t start = static_cast<std::size_t>(line) * line_stride;
    float sum = 0.0F;
    for (int k = -reach; k <= reach; ++k) sum += from[start + stride * mirrored(k)];
    for (int k = 0; k < count; ++k) {
      to[start + stride * static_cast<std::size_t>(k)] = share * sum;
      sum += from[start + stride * mirrored(k + reach + 1)] - from[start + stride * mirrored(k - reach)];
    }
  }
  return to;
}

/// Two means one after the other in each direction, whose radii add up to `radius` (m).
Coverage blurred(Coverage layer, const FloorCells& cells, double radius) {
  const auto columns = static_cast<std::size_t>(cells.columns());
  for (int pass = 0; pass < 2; ++pass) {
    const auto reach = [&](int axis) {
      return static_cast<int>(std::lround(0.5 * radius / cells.side(axis)));
    };
    layer = box_blur(layer, cells.columns(), cells.rows(), 1, columns, reach(0));
    layer = box_blur(layer, cells.rows(), cells.columns(), columns, 1, reach(1));
  }
  return layer;
}

}  // namespace

GroundLight ground_light(const Scene& scene, const Snapshot& snapshot, bool solids, double water_opacity) {
  const FloorCells cells(scene);
  GroundLight result{cells.columns(), cells.rows(), Coverage(cells.count(), 1.0F)};
  const auto darken = [&](const Coverage& outlines, std::size_t layer, float opacity) {
    if (std::none_of(outlines.begin(), outlines.end(), [](float covered) { return covered > 0.0F; })) return;
    const Coverage shade = blurred(outlines, cells, kBlurPerHeight * middle_of(layer) * depth_scale(scene));
    for (std::size_t k = 0; k < shade.size(); ++k) result.light[k] *= 1.0F - opacity * shade[k];
  };
  const auto water = water_outlines(scene, snapshot, cells);
  for (std::size_t layer = 0; layer < kLayers; ++layer) {
    darken(water[layer], layer, static_cast<float>(water_opacity));
    if (solids) darken(solid_outlines(scene, snapshot.time, layer, cells), layer, kSolidOpacity);
  }
  return result;
}

}  // namespace eisph
