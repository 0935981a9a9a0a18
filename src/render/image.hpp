#pragma once

#include "render/colour.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eisph {

/// 8-bit sRGB picture, rows from top to bottom, three bytes per pixel.
struct Image {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  std::vector<std::uint8_t> rgb;

  Image() = default;
  Image(int image_width, int image_height)
      : width(image_width), height(image_height), rgb(3 * static_cast<std::size_t>(width) * height) {}

  [[nodiscard]] std::uint8_t* pixel(int x, int y) {
    return rgb.data() + 3 * (static_cast<std::size_t>(y) * width + x);
  }
  [[nodiscard]] const std::uint8_t* pixel(int x, int y) const {
    return rgb.data() + 3 * (static_cast<std::size_t>(y) * width + x);
  }
};

/// Rectangle of pixels; (x, y) is its upper left corner.
struct PixelRectangle {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] int right() const { return x + width; }
  [[nodiscard]] int bottom() const { return y + height; }
};

}  // namespace eisph
