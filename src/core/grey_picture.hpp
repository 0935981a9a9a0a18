#pragma once

#include <cstddef>
#include <vector>

namespace eisph {

/// Picture in grey tones, rows from top to bottom. The centre of the pixel in column i and row j is at
/// (i + 1/2, j + 1/2), measured in pixels to the right and down from the upper left corner.
struct GreyPicture {
  int width = 0;             ///< pixels
  int height = 0;            ///< pixels
  std::vector<float> level;  ///< from 0, black, to 1, white

  GreyPicture() = default;
  GreyPicture(int picture_width, int picture_height)
      : width(picture_width), height(picture_height), level(static_cast<std::size_t>(width) * height) {}

  [[nodiscard]] std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * width + i; }
  [[nodiscard]] float at(int i, int j) const { return level[index(i, j)]; }
  [[nodiscard]] float& at(int i, int j) { return level[index(i, j)]; }
};

}  // namespace eisph
