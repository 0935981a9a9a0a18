#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <png.h>

namespace eisph {

/// A PNG as a reader sees it.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  /// Pixels of the rectangle whose colour is within `tolerance` of the given one in every channel.
  [[nodiscard]] std::size_t count(std::uint32_t colour, int left, int top, int right, int bottom,
                                  int tolerance = 10) const {
    std::size_t found = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const std::uint8_t* pixel = &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                              static_cast<std::size_t>(x))];
        bool is_near = true;
        for (unsigned channel = 0; channel < 3; ++channel) {
          const int wanted = static_cast<int>((colour >> (16U - 8U * channel)) & 255U);
          if (pixel[channel] < wanted - tolerance || pixel[channel] > wanted + tolerance) is_near = false;
        }
        found += is_near ? 1 : 0;
      }
    }
    return found;
  }
  [[nodiscard]] std::size_t count(std::uint32_t colour) const { return count(colour, 0, 0, width, height); }
};

inline Picture read_picture(const std::filesystem::path& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
    throw std::runtime_error(path.string() + ": " + image.message);
  }
  image.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(image));
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&image, &white, picture.rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(path.string() + ": " + image.message);
  }
  return picture;
}

}  // namespace eisph
