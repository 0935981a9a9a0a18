#include "render/depth_profile.hpp"

#include "render/axis.hpp"
#include "render/camera_view.hpp"
#include "render/drawing.hpp"
#include "render/solid_footprint.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

double depth_at(const DepthGrid& grid, double x) {
  if (grid.columns == 0) return 0.0;
  const double place =
      std::clamp((x - grid.origin_x) / grid.cell_size - 0.5, 0.0, static_cast<double>(grid.columns - 1));
  const auto left = static_cast<std::size_t>(place);
  const std::size_t right = std::min(left + 1, grid.columns - 1);
  const double weight = place - static_cast<double>(left);
  return (1.0 - weight) * grid.at(left, 0) + weight * grid.at(right, 0);
}

void draw_axes(Image& image, const Scene& scene, const ProfileView& view, const Palette& colours,
               const Font& font) {
  const PixelRectangle& area = view.area;
  const int line = std::max(1, image.height / 400);
  const int tick = font.height() / 3;
  fill_rectangle(image, {area.x - line, area.y, line, area.height + line}, colours.line);
  fill_rectangle(image, {area.x - line, area.bottom(), area.width + line, line}, colours.line);
  const double x0 = scene.domain_min.x();
  const double z0 = scene.domain_min.z();
  for (const Tick& mark :
       ticks(x0, x0 + area.width * view.metres_per_pixel, std::max(2, area.width / (4 * font.height())))) {
    const int x = area.x + static_cast<int>(std::lround((mark.value - x0) / view.metres_per_pixel));
    fill_rectangle(image, {x - line / 2, area.bottom(), line, tick}, colours.line);
    const int width = font.width(mark.label);
    const int left = std::clamp(x - width / 2, 0, image.width - width);
    font.draw(image, left, area.bottom() + tick + line, mark.label, colours.text);
  }
  for (const Tick& mark :
       ticks(z0, z0 + area.height * view.height_per_pixel, std::max(2, area.height / (2 * font.height())))) {
    const int y = area.bottom() - static_cast<int>(std::lround((mark.value - z0) / view.height_per_pixel));
    fill_rectangle(image, {area.x - tick, y - line / 2, tick, line}, colours.line);
    font.draw(image, area.x - tick - line - font.width(mark.label) - 2, y - font.height() / 2, mark.label,
              colours.text);
  }
  font.draw(image, 0, 0, "z (m)", colours.text);
  font.draw(image, area.right() - font.width("x (m)"), area.bottom() + tick + line + font.height(), "x (m)",
            colours.text);
}

}  // namespace

ProfileView profile_view(const Scene& scene, int picture_width, int picture_height, const Font& font) {
  const Bounds box = framed_bounds(scene);
  ProfileView view;
  const int left = font.width("\u22120.000") + font.height();
  const int above = font.height() * 3 / 2;
  const int below = font.height() * 5 / 2;
  view.area = {left, above, std::max(picture_width - left - font.height(), 1),
               std::max(picture_height - above - below, 1)};
  const Vec3d size = box.upper - box.lower;
  view.metres_per_pixel = size.x() / view.area.width;
  view.height_per_pixel = size.z() / view.area.height;
  if (view.height_per_pixel >= view.metres_per_pixel) {
    // A tall scene: equal scales, and a plot that does not fill the width.
    view.metres_per_pixel = view.height_per_pixel;
    view.area.width = std::max(1, static_cast<int>(std::lround(size.x() / view.metres_per_pixel)));
  }
  return view;
}

Image draw_depth_profile(const Scene& scene, const ImageSettings& settings, const DepthGrid& depth,
                         const ProfileView& view, int picture_width, int picture_height, const ColourMap& map,
                         const FieldScale& scale, const Font& font) {
  const Palette colours = palette(settings.dark_background);
  Image image(picture_width, picture_height);
  fill_rectangle(image, {0, 0, picture_width, picture_height}, colours.page);
  const SolidFootprint solids(scene, depth.time);
  const PixelRectangle& area = view.area;
  for (int column = 0; column < area.width; ++column) {
    const double x = scene.domain_min.x() + (column + 0.5) * view.metres_per_pixel;
    const double water = depth_at(depth, x);
    const Colour colour = map.at((water - scale.lower) / (scale.upper - scale.lower));
    for (int row = 0; row < area.height; ++row) {
      const double above_floor = (area.height - row - 0.5) * view.height_per_pixel;
      const auto coverage = static_cast<float>((water - above_floor) / view.height_per_pixel + 0.5);
      if (water >= settings.dry_depth) blend_pixel(image, area.x + column, area.y + row, colour, coverage);
      if (!settings.draw_obstacles || solids.empty()) continue;
      const double z = scene.domain_min.z() + above_floor;
      const auto [distance, is_gate] = solids.distance(x, z);
      // Distance in pixels, by the slope of the distance there, as the two scales differ.
      const double along = solids.distance(x + view.metres_per_pixel, z).first - distance;
      const double upwards = solids.distance(x, z + view.height_per_pixel).first - distance;
      const double pixel = std::max(std::hypot(along, upwards), 1e-12);
      solids.paint(image, area.x + column, area.y + row, distance / pixel,
                   is_gate ? colours.gate : colours.solid);
    }
  }
  draw_axes(image, scene, view, colours, font);
  return image;
}

}  // namespace eisph
