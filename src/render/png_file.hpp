#pragma once

#include "render/image.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace eisph {

/// Keyword and text of PNG text chunks; keywords have 1 to 79 Latin characters, texts are UTF-8.
using PngText = std::vector<std::pair<std::string, std::string>>;

struct PngFile {
  Image image;
  PngText text;
};

/// Writes under a temporary name in the same folder and renames, so that `path` is either complete or not
/// there. Throws std::runtime_error that names the path.
void write_png(const std::filesystem::path& path, const Image& image, const PngText& text);

/// Reads any PNG file as 8-bit RGB, without transparency. Throws std::runtime_error that names the path.
[[nodiscard]] PngFile read_png(const std::filesystem::path& path);

}  // namespace eisph
