#include "render/grey_png.hpp"

#include "core/error.hpp"
#include "render/png_codec.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kWhite8 = 255.0;
constexpr double kWhite16 = 65535.0;

/// Channels of a pixel of the rows that the reader gives.
int channels_of(const std::filesystem::path& path, const PngLayout& layout) {
  const int kind = layout.colour_type & ~PNG_COLOR_MASK_ALPHA;
  const bool known = kind == PNG_COLOR_TYPE_GRAY || kind == PNG_COLOR_TYPE_RGB;
  if (known && (layout.bit_depth == 8 || layout.bit_depth == 16)) return kind == PNG_COLOR_TYPE_RGB ? 3 : 1;
  throw InputError(fmt::format("{}: a PNG of {} bits{}; expected grey or RGB of 8 or 16 bits", path.string(),
                               layout.bit_depth, known ? "" : " with a palette"));
}

double sample(const png_byte* bytes, int bit_depth) {
  return bit_depth == 8 ? bytes[0] / kWhite8 : (256.0 * bytes[0] + bytes[1]) / kWhite16;
}

GreyPng read_levels(const std::filesystem::path& path, PngReader& reader,
                    const std::array<double, 3>& weights) {
  const PngLayout layout = reader.layout();
  const int channels = channels_of(path, layout);
  const std::size_t row_bytes = reader.row_bytes();
  std::vector<png_byte> bytes(row_bytes * static_cast<std::size_t>(layout.height));
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(layout.height));
  for (int row = 0; row < layout.height; ++row)
    rows.push_back(&bytes[row_bytes * static_cast<std::size_t>(row)]);
  if (!reader.read_rows(rows.data()))
    throw InputError(fmt::format("{}: damaged PNG file: {}", path.string(), reader.message()));
  GreyPng result{GreyPicture(layout.width, layout.height), layout.bit_depth, channels == 3};
  const int sample_bytes = layout.bit_depth / 8;
  for (int j = 0; j < layout.height; ++j) {
    const png_byte* pixel = rows[static_cast<std::size_t>(j)];
    for (int i = 0; i < layout.width; ++i, pixel += channels * sample_bytes) {
      double level = sample(pixel, layout.bit_depth);
      if (channels == 3) {
        level *= weights[0];
        level += weights[1] * sample(pixel + sample_bytes, layout.bit_depth);
        level += weights[2] * sample(pixel + 2 * sample_bytes, layout.bit_depth);
      }
      result.picture.at(i, j) = static_cast<float>(level);
    }
  }
  return result;
}

}  // namespace

GreyPng read_grey_png(const std::filesystem::path& path, const std::array<double, 3>& weights) {
  try {
    const PngStream file = open_png(path);
    PngReader reader;
    if (!reader.read_header(file.get())) fail_png(path, fmt::format("not a PNG file: {}", reader.message()));
    return read_levels(path, reader, weights);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw InputError(error.what());
  }
}

void write_grey_png(const std::filesystem::path& path, const GreyPicture& picture, int bit_depth,
                    const PngText& text) {
  if (bit_depth != 8 && bit_depth != 16)
    throw std::invalid_argument(fmt::format("{}: grey levels of {} bits", path.string(), bit_depth));
  const std::size_t sample_bytes = static_cast<std::size_t>(bit_depth) / 8;
  std::vector<png_byte> bytes(picture.level.size() * sample_bytes);
  for (std::size_t k = 0; k < picture.level.size(); ++k) {
    const double level = std::clamp(static_cast<double>(picture.level[k]), 0.0, 1.0);
    if (bit_depth == 8) {
      bytes[k] = static_cast<png_byte>(std::lround(level * kWhite8));
    } else {
      const long whole = std::lround(level * kWhite16);
      bytes[2 * k] = static_cast<png_byte>(whole / 256);
      bytes[2 * k + 1] = static_cast<png_byte>(whole % 256);
    }
  }
  write_png_rows(path, {picture.width, picture.height, bit_depth, PNG_COLOR_TYPE_GRAY}, bytes.data(),
                 sample_bytes * static_cast<std::size_t>(picture.width), text);
}

}  // namespace eisph
