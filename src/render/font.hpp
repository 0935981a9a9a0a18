#pragma once

#include "render/colour.hpp"
#include "render/image.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct ImFont;
struct ImFontAtlas;

namespace eisph {

/// One size of a typeface, drawn on the processor. Texts are UTF-8; coordinates are pixels.
class Font {
 public:
  /// `height` is the line height.
  Font(const std::vector<unsigned char>& typeface, int height);
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  ~Font();

  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int width(std::string_view text) const;
  /// The text, or as much of it as fits into `width` with an ellipsis at the end; empty if not even that
  /// fits.
  [[nodiscard]] std::string shortened(std::string_view text, int width) const;
  /// (x, y) is the upper left corner of the line.
  void draw(Image& image, int x, int y, std::string_view text, const Colour& colour) const;

 private:
  int height_ = 0;
  std::unique_ptr<ImFontAtlas> atlas_;
  const ImFont* font_ = nullptr;
  const unsigned char* coverage_ = nullptr;
  int atlas_width_ = 0;
  int atlas_height_ = 0;
};

/// Sizes of one typeface, made when first asked for.
class Typeface {
 public:
  /// DejaVu Sans as Debian's fonts-dejavu-core installs it.
  static std::filesystem::path default_file();
  /// Throws InputError when the file is missing.
  explicit Typeface(const std::filesystem::path& file = default_file());
  [[nodiscard]] const Font& size(int height);

 private:
  std::vector<unsigned char> data_;
  std::map<int, std::unique_ptr<Font>> fonts_;
};

}  // namespace eisph
