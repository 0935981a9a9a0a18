#pragma once

#include "core/grey_picture.hpp"
#include "render/png_file.hpp"

#include <array>
#include <filesystem>

namespace eisph {

struct GreyPng {
  GreyPicture picture;
  int bit_depth = 8;      ///< of the file
  bool coloured = false;  ///< the file has three channels
};

/// Reads a PNG of 8 or 16 bits, grey or RGB; transparency is left out. `weights` of red, green and blue make
/// the grey level of a coloured pixel. Throws InputError that names the path for a file that is missing,
/// damaged or of another kind.
[[nodiscard]] GreyPng read_grey_png(const std::filesystem::path& path, const std::array<double, 3>& weights);

/// Writes grey levels of 8 or 16 bits, rounded, in place of an older file. Throws std::runtime_error that
/// names the path.
void write_grey_png(const std::filesystem::path& path, const GreyPicture& picture, int bit_depth,
                    const PngText& text);

}  // namespace eisph
