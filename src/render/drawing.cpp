#include "render/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

std::uint8_t to_byte(float channel) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(channel, 0.0F, 1.0F)));
}

}  // namespace

void blend_pixel(Image& image, int x, int y, const Colour& colour, float weight) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height || !(weight > 0.0F)) return;
  std::uint8_t* pixel = image.pixel(x, y);
  const Colour below{static_cast<float>(pixel[0]) / 255.0F, static_cast<float>(pixel[1]) / 255.0F,
                     static_cast<float>(pixel[2]) / 255.0F};
  const Colour mixed = mix(below, colour, std::min(weight, 1.0F));
  pixel[0] = to_byte(mixed.red);
  pixel[1] = to_byte(mixed.green);
  pixel[2] = to_byte(mixed.blue);
}

void fill_rectangle(Image& image, const PixelRectangle& area, const Colour& colour) {
  const std::uint8_t bytes[3] = {to_byte(colour.red), to_byte(colour.green), to_byte(colour.blue)};
  for (int y = std::max(area.y, 0); y < std::min(area.bottom(), image.height); ++y) {
    for (int x = std::max(area.x, 0); x < std::min(area.right(), image.width); ++x) {
      std::copy_n(bytes, 3, image.pixel(x, y));
    }
  }
}

void draw_outline(Image& image, const PixelRectangle& area, int thickness, const Colour& colour) {
  const int width = area.width + 2 * thickness;
  fill_rectangle(image, {area.x - thickness, area.y - thickness, width, thickness}, colour);
  fill_rectangle(image, {area.x - thickness, area.bottom(), width, thickness}, colour);
  fill_rectangle(image, {area.x - thickness, area.y, thickness, area.height}, colour);
  fill_rectangle(image, {area.right(), area.y, thickness, area.height}, colour);
}

void fill_dashed(Image& image, const PixelRectangle& line, int dash, const Colour& colour) {
  if (line.width >= line.height) {
    for (int x = line.x; x < line.right(); x += 2 * dash) {
      fill_rectangle(image, {x, line.y, std::min(dash, line.right() - x), line.height}, colour);
    }
  } else {
    for (int y = line.y; y < line.bottom(); y += 2 * dash) {
      fill_rectangle(image, {line.x, y, line.width, std::min(dash, line.bottom() - y)}, colour);
    }
  }
}

void paste(Image& image, const Image& source, int x, int y) {
  const int first = std::max(0, -x);
  const int last = std::min(source.width, image.width - x);
  if (first >= last) return;
  for (int row = std::max(0, -y); row < std::min(source.height, image.height - y); ++row) {
    std::copy(source.pixel(first, row),
              source.pixel(first, row) + 3 * static_cast<std::ptrdiff_t>(last - first),
              image.pixel(x + first, y + row));
  }
}

}  // namespace eisph
