#include "render/png_file.hpp"

#include "render/png_codec.hpp"

#include <fmt/format.h>

namespace eisph {

void write_png(const std::filesystem::path& path, const Image& image, const PngText& text) {
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image.width);
  if (image.width <= 0 || image.height <= 0 || image.rgb.size() != row_bytes * image.height) {
    fail_png(path, fmt::format("an image of {} x {} pixels with {} bytes cannot be written", image.width,
                               image.height, image.rgb.size()));
  }
  write_png_rows(path, {.width = image.width, .height = image.height}, image.rgb.data(), row_bytes, text);
}

PngFile read_png(const std::filesystem::path& path) {
  const PngStream file = open_png(path);
  PngReader reader;
  PngFile result;
  if (!reader.read_header_as_rgb(file.get()))
    fail_png(path, fmt::format("not a PNG file: {}", reader.message()));
  result.image = Image(reader.layout().width, reader.layout().height);
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(result.image.height));
  for (int row = 0; row < result.image.height; ++row) rows.push_back(result.image.pixel(0, row));
  if (!reader.read_rows(rows.data())) fail_png(path, fmt::format("damaged PNG file: {}", reader.message()));
  result.text = reader.text();
  return result;
}

}  // namespace eisph
