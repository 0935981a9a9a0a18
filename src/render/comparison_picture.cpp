#include "render/comparison_picture.hpp"

#include "render/drawing.hpp"
#include "render/layout.hpp"
#include "render/palette.hpp"
#include "render/solid_footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kMillimetre = 0.001;
constexpr float kRedWeight = 0.35F;     ///< of the transparent area
constexpr int kHatch = 8;               ///< pixels between the lines of hatched cells
constexpr double kLeastLineStep = 9.0;  ///< pixels between lines of the grid over a photograph
const Colour kRed = {0.85F, 0.08F, 0.10F};
const Colour kMark = {0.95F, 0.55F, 0.05F};
const Colour kGridLine = {0.10F, 0.60F, 0.85F};

/// Value of a cell at a place, nothing where the grid has none or the cell does not count.
std::optional<double> cell_value(const DepthSide& side, double x, double y) {
  const double i = std::floor((x - side.grid.origin_x) / side.grid.cell_size);
  const double j = std::floor((y - side.grid.origin_y) / side.grid.cell_size);
  if (i < 0.0 || j < 0.0 || i >= static_cast<double>(side.grid.columns) ||
      j >= static_cast<double>(side.grid.rows))
    return std::nullopt;
  const std::size_t cell = static_cast<std::size_t>(j) * side.grid.columns + static_cast<std::size_t>(i);
  if (side.valid != nullptr && (*side.valid)[cell] == 0) return std::nullopt;
  return side.grid.depth[cell];
}

Colour grey(float level) { return {level, level, level}; }

/// Lines across cells without a value.
Colour hatched(int column, int row) {
  return (column + row) % kHatch < 2 ? Colour{0.72F, 0.72F, 0.70F} : Colour{0.93F, 0.93F, 0.92F};
}

Colour depth_colour(const DepthSide& side, const ColourMap& map, double depth, double x, double y, int column,
                    int row) {
  const auto value = cell_value(side, x, y);
  return value ? map.at(*value / depth) : hatched(column, row);
}

/// A line of `colour` from one point to the other, two pixels wide.
void draw_line(Image& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Colour& colour,
               float weight) {
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm())));
  for (int k = 0; k <= steps; ++k) {
    const Eigen::Vector2d point = from + (to - from) * (static_cast<double>(k) / steps);
    blend_pixel(image, static_cast<int>(std::floor(point.x())), static_cast<int>(std::floor(point.y())),
                colour, weight);
  }
}

void draw_cross(Image& image, const Eigen::Vector2d& centre, int reach, const Colour& colour) {
  for (const double shift : {0.0, 1.0}) {
    const Eigen::Vector2d off(shift, shift);
    draw_line(image, centre + off - Eigen::Vector2d(reach, 0), centre + off + Eigen::Vector2d(reach, 0),
              colour, 1.0F);
    draw_line(image, centre + off - Eigen::Vector2d(0, reach), centre + off + Eigen::Vector2d(0, reach),
              colour, 1.0F);
  }
}

}  // namespace

/// What one panel shows at a place of the floor.
struct ComparisonPainter::Panel {
  std::size_t number = 0;
  std::function<Colour(double x, double y, int column, int row)> colour;
  bool solids = true;
};

/// A picture in the making.
struct ComparisonPainter::Sheet {
  Image image;
  FrameLayout layout;
  Palette colours;
  double metres_per_pixel = 0.0;
  std::vector<PixelRectangle> panels;
};

ComparisonPainter::ComparisonPainter(const Scene& scene, const std::array<double, 4>& area, int width)
    : scene_(scene), area_(area), width_(width) {}

ComparisonPainter::Sheet ComparisonPainter::make_sheet(const ComparisonHeading& heading, std::size_t panels,
                                                       const std::string& legend_label) {
  const double length = area_[2] - area_[0];
  const double breadth = area_[3] - area_[1];
  const auto count = static_cast<int>(panels);
  Sheet sheet{.image = {}, .layout = {}, .colours = palette(false), .metres_per_pixel = 0.0, .panels = {}};
  // The height of the texts depends on that of the picture, which follows from the panels.
  int height = static_cast<int>(width_ * breadth / length / count) + width_ / 5;
  int gap = 0;
  int panel_width = 0;
  for (int k = 0; k < 4; ++k) {
    sheet.layout = lay_out_frame(width_, height, typeface_, heading.time, legend_label);
    const int strip = sheet.layout.text_height * 3 / 2;
    gap = sheet.layout.text_height;
    panel_width = (sheet.layout.picture.width - (count - 1) * gap) / count;
    const int panel_height = static_cast<int>(std::lround(panel_width * breadth / length));
    height += strip + panel_height - sheet.layout.picture.height;
  }
  sheet.layout = lay_out_frame(width_, height, typeface_, heading.time, legend_label);
  sheet.metres_per_pixel = length / panel_width;
  const PixelRectangle& place = sheet.layout.picture;
  const int strip = sheet.layout.text_height * 3 / 2;
  for (int k = 0; k < count; ++k) {
    sheet.panels.push_back(
        {place.x + k * (panel_width + gap), place.y + strip, panel_width, place.height - strip});
  }
  sheet.image = Image(width_, height);
  fill_rectangle(sheet.image, {0, 0, width_, height}, sheet.colours.page);
  draw_title(sheet.image, sheet.layout, typeface_, sheet.colours, heading.title, heading.time);
  return sheet;
}

void ComparisonPainter::paint(Sheet& sheet, const Panel& panel, double time) const {
  const PixelRectangle& place = sheet.panels[panel.number];
  const SolidFootprint solids(scene_, time);
  for (int row = 0; row < place.height; ++row) {
    const double y = area_[3] - (row + 0.5) * sheet.metres_per_pixel;
    for (int column = 0; column < place.width; ++column) {
      const double x = area_[0] + (column + 0.5) * sheet.metres_per_pixel;
      blend_pixel(sheet.image, place.x + column, place.y + row, panel.colour(x, y, column, row), 1.0F);
      if (!panel.solids || solids.empty()) continue;
      const auto [distance, is_gate] = solids.distance(x, y);
      solids.paint(sheet.image, place.x + column, place.y + row, distance / sheet.metres_per_pixel,
                   is_gate ? sheet.colours.gate : sheet.colours.solid);
    }
  }
  draw_outline(sheet.image, place, 1, sheet.colours.line);
}

void ComparisonPainter::label(Sheet& sheet, std::size_t panel, const std::string& text) {
  const PixelRectangle& place = sheet.panels[panel];
  const Font& font = typeface_.size(sheet.layout.text_height);
  const int y = place.y - sheet.layout.text_height * 5 / 4;
  font.draw(sheet.image, place.x, y, font.shortened(text, place.width), sheet.colours.text);
}

void ComparisonPainter::finish(Sheet& sheet, const std::string& legend_label, const ColourMap& map,
                               double lower, double upper) {
  const FieldScale scale{.label = legend_label, .lower = lower, .upper = upper, .display_unit = kMillimetre};
  draw_colour_bar(sheet.image, sheet.layout, typeface_, sheet.colours, scale, map,
                  std::numeric_limits<double>::lowest(), sheet.colours.page);
  draw_length_scale(
      sheet.image, sheet.layout, typeface_, sheet.colours,
      length_scale(1.0 / sheet.metres_per_pixel, sheet.panels.front().width, sheet.layout.scale.width));
}

Image ComparisonPainter::photograph_and_depth(const ComparisonHeading& heading,
                                              const PhotographSide& photograph, const DepthSide& simulation,
                                              const ColourMap& tones, double depth) {
  const std::string legend = "water depth [mm]";
  Sheet sheet = make_sheet(heading, 2, legend);
  const GreyPicture& picture = photograph.picture;
  const auto upright = [&](double x, double y, int column, int row) {
    const Eigen::Vector2d pixel = photograph.pixel_of({x, y});
    const auto i = static_cast<int>(std::floor(pixel.x()));
    const auto j = static_cast<int>(std::floor(pixel.y()));
    const bool inside = i >= 0 && j >= 0 && i < picture.width && j < picture.height;
    return inside ? grey(picture.at(i, j)) : hatched(column, row);
  };
  const auto simulated = [&](double x, double y, int column, int row) {
    return depth_colour(simulation, tones, depth, x, y, column, row);
  };
  paint(sheet, {.number = 0, .colour = upright, .solids = false}, simulation.grid.time);
  paint(sheet, {.number = 1, .colour = simulated, .solids = true}, simulation.grid.time);
  label(sheet, 0, photograph.label);
  label(sheet, 1, simulation.label);
  finish(sheet, legend, tones, 0.0, depth);
  return std::move(sheet.image);
}

Image ComparisonPainter::depths(const ComparisonHeading& heading, const DepthSide& left,
                                const DepthSide& right, const ColourMap& map, double depth) {
  const std::string legend = "water depth [mm]";
  Sheet sheet = make_sheet(heading, 2, legend);
  std::size_t number = 0;
  for (const DepthSide* side : {&left, &right}) {
    const auto colour = [&](double x, double y, int column, int row) {
      return depth_colour(*side, map, depth, x, y, column, row);
    };
    paint(sheet, {.number = number, .colour = colour, .solids = true}, side->grid.time);
    label(sheet, number++, side->label);
  }
  finish(sheet, legend, map, 0.0, depth);
  return std::move(sheet.image);
}

Image ComparisonPainter::overlay(const ComparisonHeading& heading, const DepthSide& simulation,
                                 const DepthSide& photograph, const ColourMap& map, double depth,
                                 double dry_depth) {
  const std::string legend = "simulated depth [mm]";
  Sheet sheet = make_sheet(heading, 1, legend);
  const auto is_wet = [&](double x, double y) {
    const auto value = cell_value(photograph, x, y);
    return value && *value > dry_depth;
  };
  const double reach = sheet.metres_per_pixel;
  const auto colour = [&](double x, double y, int column, int row) {
    const Colour below = depth_colour(simulation, map, depth, x, y, column, row);
    if (!is_wet(x, y)) return below;
    const bool edge =
        !is_wet(x - reach, y) || !is_wet(x + reach, y) || !is_wet(x, y - reach) || !is_wet(x, y + reach);
    return edge ? kRed : mix(below, kRed, kRedWeight);
  };
  paint(sheet, {.number = 0, .colour = colour, .solids = true}, simulation.grid.time);
  label(sheet, 0,
        fmt::format("grey: simulation; red: deeper than {:g} mm in the photograph", dry_depth / kMillimetre));
  finish(sheet, legend, map, 0.0, depth);
  return std::move(sheet.image);
}

Image ComparisonPainter::deviation(const ComparisonHeading& heading, const DepthSide& simulation,
                                   const DepthSide& photograph, const ColourMap& map, double range) {
  const std::string legend = "deviation [mm]";
  Sheet sheet = make_sheet(heading, 1, legend);
  const auto colour = [&](double x, double y, int column, int row) {
    const auto a = cell_value(simulation, x, y);
    const auto b = cell_value(photograph, x, y);
    return a && b ? map.at(0.5 + 0.5 * (*a - *b) / range) : hatched(column, row);
  };
  paint(sheet, {.number = 0, .colour = colour, .solids = true}, simulation.grid.time);
  label(sheet, 0, "simulation minus photograph; hatched: not compared");
  finish(sheet, legend, map, -range, range);
  return std::move(sheet.image);
}

Image ComparisonPainter::halves(const ComparisonHeading& heading, const DepthSide& upper,
                                const DepthSide& lower, double middle, const ColourMap& map, double depth) {
  const std::string legend = "water depth [mm]";
  Sheet sheet = make_sheet(heading, 1, legend);
  const auto colour = [&](double x, double y, int column, int row) {
    if (std::abs(y - middle) < sheet.metres_per_pixel) return kRed;
    return depth_colour(y > middle ? upper : lower, map, depth, x, y, column, row);
  };
  paint(sheet, {.number = 0, .colour = colour, .solids = true}, upper.grid.time);
  label(sheet, 0, fmt::format("above the red line: {}; below: {}", upper.label, lower.label));
  finish(sheet, legend, map, 0.0, depth);
  return std::move(sheet.image);
}

Image ComparisonPainter::grid_over_photograph(const ComparisonHeading& heading,
                                              const PhotographSide& photograph, const DepthGrid& cells,
                                              const std::vector<PictureMark>& marks) {
  const GreyPicture& picture = photograph.picture;
  const int text = std::max(12, width_ / 60);
  const Font& font = typeface_.size(text);
  const int head = 3 * text;
  const double scale = static_cast<double>(width_) / picture.width;
  Image image(width_, head + static_cast<int>(std::lround(picture.height * scale)));
  const Palette colours = palette(false);
  fill_rectangle(image, {0, 0, image.width, head}, colours.page);
  for (int row = head; row < image.height; ++row) {
    const int j = std::min(picture.height - 1, static_cast<int>((row - head) / scale));
    for (int column = 0; column < image.width; ++column) {
      const int i = std::min(picture.width - 1, static_cast<int>(column / scale));
      blend_pixel(image, column, row, grey(picture.at(i, j)), 1.0F);
    }
  }
  const auto place = [&](double x, double y) {
    const Eigen::Vector2d pixel = photograph.pixel_of({x, y}) * scale;
    return Eigen::Vector2d(pixel.x(), pixel.y() + head);
  };
  const double cell_pixels = (place(area_[0] + cells.cell_size, area_[1]) - place(area_[0], area_[1])).norm();
  const int every = std::max(1, static_cast<int>(std::ceil(kLeastLineStep / cell_pixels)));
  const auto draw_lines = [&](double origin, std::size_t count, int axis) {
    for (std::size_t k = 0; k <= count; k += static_cast<std::size_t>(every)) {
      const double position = origin + static_cast<double>(k) * cells.cell_size;
      if (position < area_[static_cast<std::size_t>(axis)] ||
          position > area_[static_cast<std::size_t>(axis) + 2])
        continue;
      const auto from = axis == 0 ? place(position, area_[1]) : place(area_[0], position);
      const auto to = axis == 0 ? place(position, area_[3]) : place(area_[2], position);
      draw_line(image, from, to, kGridLine, 0.45F);
    }
  };
  draw_lines(cells.origin_x, cells.columns, 0);
  draw_lines(cells.origin_y, cells.rows, 1);
  const std::array<Eigen::Vector2d, 4> corners = {place(area_[0], area_[1]), place(area_[2], area_[1]),
                                                  place(area_[2], area_[3]), place(area_[0], area_[3])};
  for (std::size_t k = 0; k < 4; ++k) draw_line(image, corners[k], corners[(k + 1) % 4], kRed, 1.0F);
  for (const PictureMark& mark : marks) {
    const Eigen::Vector2d centre(mark.pixel.x() * scale, mark.pixel.y() * scale + head);
    draw_cross(image, centre, text / 2, kMark);
    const int width = font.width(mark.name);
    const int x =
        std::clamp(static_cast<int>(centre.x()) + text / 2, 2, std::max(2, image.width - width - 2));
    const int y = std::clamp(static_cast<int>(centre.y()) + text / 3, head, image.height - text - 2);
    fill_rectangle(image, {x - 2, y, width + 4, text + 1}, colours.page);
    font.draw(image, x, y, mark.name, colours.text);
  }
  const std::string lines = every == 1 ? "all lines" : fmt::format("one line of {}", every);
  const int room = image.width - text;
  font.draw(image, text / 2, text / 4,
            font.shortened(fmt::format("{}; {}, {}", heading.title, photograph.label, heading.time), room),
            colours.text);
  font.draw(
      image, text / 2, text / 4 + text * 5 / 4,
      font.shortened(fmt::format("cells of {:g} mm, {} drawn; red: area compared; crosses: reference points",
                                 cells.cell_size / kMillimetre, lines),
                     room),
      colours.text);
  return image;
}

}  // namespace eisph
