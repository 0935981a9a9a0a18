#include "render/depth_map.hpp"

#include "render/drawing.hpp"
#include "render/solid_footprint.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace eisph {

namespace {

/// Range of one coordinate with its mirror images.
struct Extent {
  double lower;
  double upper;
};

bool mirrors(const Scene& scene, const ImageSettings& settings, int face) {
  return settings.mirror && scene.faces[static_cast<std::size_t>(face)].kind == FaceKind::Symmetry;
}

Extent extent(const Scene& scene, const ImageSettings& settings, int axis) {
  const double lower = scene.domain_min[axis];
  const double upper = scene.domain_max[axis];
  const double length = upper - lower;
  return {mirrors(scene, settings, 2 * axis) ? lower - length : lower,
          mirrors(scene, settings, 2 * axis + 1) ? upper + length : upper};
}

/// The coordinate inside the domain that a mirrored one stands for.
double reflected(double coordinate, double lower, double upper) {
  if (coordinate < lower) return 2.0 * lower - coordinate;
  return coordinate > upper ? 2.0 * upper - coordinate : coordinate;
}

/// Depth between the cell centres; cells inside a solid take no part.
class DepthSampler {
 public:
  DepthSampler(const DepthGrid& grid, const SolidFootprint& solids)
      : grid_(grid), open_(grid.depth.size(), 1.0F) {
    if (solids.empty()) return;
    for (std::size_t j = 0; j < grid.rows; ++j) {
      for (std::size_t i = 0; i < grid.columns; ++i) {
        const double x = grid.origin_x + (static_cast<double>(i) + 0.5) * grid.cell_size;
        const double y = grid.origin_y + (static_cast<double>(j) + 0.5) * grid.cell_size;
        if (solids.distance(x, y).first < 0.0) open_[j * grid.columns + i] = 0.0F;
      }
    }
  }

  [[nodiscard]] double at(double x, double y) const {
    const auto [i, right] = split((x - grid_.origin_x) / grid_.cell_size - 0.5, grid_.columns);
    const auto [j, up] = split((y - grid_.origin_y) / grid_.cell_size - 0.5, grid_.rows);
    double sum = 0.0;
    double weights = 0.0;
    for (const auto& [dj, wj] : {std::pair<std::size_t, double>{0, 1.0 - up}, {1, up}}) {
      for (const auto& [di, wi] : {std::pair<std::size_t, double>{0, 1.0 - right}, {1, right}}) {
        const std::size_t column = std::min(i + di, grid_.columns - 1);
        const std::size_t row = std::min(j + dj, grid_.rows - 1);
        const double weight = wi * wj * open_[row * grid_.columns + column];
        sum += weight * grid_.at(column, row);
        weights += weight;
      }
    }
    return weights > 0.0 ? sum / weights : 0.0;
  }

 private:
  static std::pair<std::size_t, double> split(double place, std::size_t count) {
    const double inside = std::clamp(place, 0.0, static_cast<double>(count - 1));
    const double cell = std::floor(inside);
    return {static_cast<std::size_t>(cell), inside - cell};
  }

  const DepthGrid& grid_;
  std::vector<float> open_;
};

void draw_walls(Image& image, const Scene& scene, const ImageSettings& settings, const TopView& view,
                const Palette& colours) {
  const int thickness = std::max(2, image.height / 240);
  const PixelRectangle& area = view.area;
  const int length = area.width + 2 * thickness;
  const auto draw = [&](int face, const PixelRectangle& line) {
    if (mirrors(scene, settings, face)) face ^= 1;
    if (mirrors(scene, settings, face)) return;
    if (scene.faces[static_cast<std::size_t>(face)].kind == FaceKind::Wall) {
      fill_rectangle(image, line, colours.line);
    } else {
      fill_dashed(image, line, 4 * thickness, colours.faint);
    }
  };
  draw(kXMin, {area.x - thickness, area.y, thickness, area.height});
  draw(kXMax, {area.right(), area.y, thickness, area.height});
  draw(kYMin, {area.x - thickness, area.bottom(), length, thickness});
  draw(kYMax, {area.x - thickness, area.y - thickness, length, thickness});
}

}  // namespace

TopView top_view(const Scene& scene, const ImageSettings& settings, int picture_width, int picture_height,
                 int border) {
  const Extent x = extent(scene, settings, 0);
  const Extent y = extent(scene, settings, 1);
  const int width = std::max(picture_width - 2 * border, 1);
  const int height = std::max(picture_height - 2 * border, 1);
  TopView view;
  view.metres_per_pixel = std::max((x.upper - x.lower) / width, (y.upper - y.lower) / height);
  view.area.width =
      std::clamp(static_cast<int>(std::lround((x.upper - x.lower) / view.metres_per_pixel)), 1, width);
  view.area.height =
      std::clamp(static_cast<int>(std::lround((y.upper - y.lower) / view.metres_per_pixel)), 1, height);
  view.area.x = (picture_width - view.area.width) / 2;
  view.area.y = (picture_height - view.area.height) / 2;
  // The whole number of pixels differs a little from the length; centre the difference.
  view.left = 0.5 * (x.lower + x.upper - view.area.width * view.metres_per_pixel);
  view.top = 0.5 * (y.lower + y.upper + view.area.height * view.metres_per_pixel);
  return view;
}

Image draw_depth_map(const Scene& scene, const ImageSettings& settings, const DepthGrid& depth,
                     const TopView& view, int picture_width, int picture_height, const ColourMap& map,
                     const FieldScale& scale) {
  const Palette colours = palette(settings.dark_background);
  Image image(picture_width, picture_height);
  fill_rectangle(image, {0, 0, picture_width, picture_height}, colours.page);
  fill_rectangle(image, view.area, colours.dry_floor);
  const SolidFootprint solids(scene, depth.time);
  const DepthSampler sampler(depth, solids);
  const bool has_water = depth.columns > 0 && depth.rows > 0;
  for (int row = 0; row < view.area.height; ++row) {
    const double y =
        reflected(view.top - (row + 0.5) * view.metres_per_pixel, scene.domain_min.y(), scene.domain_max.y());
    for (int column = 0; column < view.area.width; ++column) {
      const double x = reflected(view.left + (column + 0.5) * view.metres_per_pixel, scene.domain_min.x(),
                                 scene.domain_max.x());
      const double value = has_water ? sampler.at(x, y) : 0.0;
      if (value >= settings.dry_depth && value > 0.0) {
        blend_pixel(image, view.area.x + column, view.area.y + row,
                    map.at((value - scale.lower) / (scale.upper - scale.lower)), 1.0F);
      }
      if (!settings.draw_obstacles || solids.empty()) continue;
      const auto [distance, is_gate] = solids.distance(x, y);
      solids.paint(image, view.area.x + column, view.area.y + row, distance / view.metres_per_pixel,
                   is_gate ? colours.gate : colours.solid);
    }
  }
  if (settings.draw_walls) draw_walls(image, scene, settings, view, colours);
  return image;
}

}  // namespace eisph
