#include "render/font.hpp"

#include "core/error.hpp"
#include "render/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <imgui.h>

namespace eisph {

namespace {

// Latin, Greek, dashes and the ellipsis, super- and subscripts, the minus sign and comparison signs.
constexpr std::array<ImWchar, 13> kGlyphRanges = {0x0020, 0x017F, 0x0370, 0x03FF, 0x2010, 0x2027, 0x2070,
                                                  0x209F, 0x2212, 0x2212, 0x2248, 0x2265, 0};
constexpr std::string_view kEllipsis = "\u2026";

/// Takes the next code point off the front of `text`; a broken sequence gives U+FFFD.
std::uint32_t next_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t k) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[k]));
  };
  const std::uint32_t first = byte(0);
  std::size_t length = 1;
  std::uint32_t value = first;
  if (first >= 0xF0) {
    length = 4;
    value = first & 0x07U;
  } else if (first >= 0xE0) {
    length = 3;
    value = first & 0x0FU;
  } else if (first >= 0xC0) {
    length = 2;
    value = first & 0x1FU;
  } else if (first >= 0x80) {
    text.remove_prefix(1);
    return 0xFFFD;
  }
  for (std::size_t k = 1; k < length; ++k) {
    if (k >= text.size() || (byte(k) & 0xC0U) != 0x80U) {
      text.remove_prefix(k);
      return 0xFFFD;
    }
    value = (value << 6U) | (byte(k) & 0x3FU);
  }
  text.remove_prefix(length);
  return value;
}

const ImFontGlyph* glyph_of(const ImFont& font, std::uint32_t code_point) {
  return font.FindGlyph(code_point <= 0xFFFF ? static_cast<ImWchar>(code_point) : static_cast<ImWchar>('?'));
}

}  // namespace

Font::Font(const std::vector<unsigned char>& typeface, int height)
    : height_(height), atlas_(std::make_unique<ImFontAtlas>()) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 1;
  config.OversampleV = 1;
  config.PixelSnapH = true;
  atlas_->Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
  // ImGui reads the data only, but takes it without const.
  font_ = atlas_->AddFontFromMemoryTTF(const_cast<unsigned char*>(typeface.data()),
                                       static_cast<int>(typeface.size()), static_cast<float>(height), &config,
                                       kGlyphRanges.data());
  unsigned char* coverage = nullptr;
  atlas_->GetTexDataAsAlpha8(&coverage, &atlas_width_, &atlas_height_);
  coverage_ = coverage;
  if (font_ == nullptr || coverage_ == nullptr) throw std::runtime_error("the font could not be rasterised");
}

Font::~Font() = default;

int Font::width(std::string_view text) const {
  float total = 0.0F;
  while (!text.empty()) total += glyph_of(*font_, next_code_point(text))->AdvanceX;
  return static_cast<int>(std::ceil(total));
}

std::string Font::shortened(std::string_view text, int available) const {
  if (width(text) <= available) return std::string(text);
  const int room = available - width(kEllipsis);
  if (room < 0) return {};
  std::size_t kept = 0;
  for (std::string_view rest = text; !rest.empty();) {
    next_code_point(rest);
    const std::size_t length = text.size() - rest.size();
    if (width(text.substr(0, length)) > room) break;
    kept = length;
  }
  while (kept > 0 && text[kept - 1] == ' ') --kept;
  return std::string(text.substr(0, kept)) + std::string(kEllipsis);
}

void Font::draw(Image& image, int x, int y, std::string_view text, const Colour& colour) const {
  auto pen = static_cast<float>(x);
  while (!text.empty()) {
    const ImFontGlyph& glyph = *glyph_of(*font_, next_code_point(text));
    const int left = static_cast<int>(std::lround(pen + glyph.X0));
    const int top = y + static_cast<int>(std::lround(glyph.Y0));
    const int u = static_cast<int>(std::lround(glyph.U0 * static_cast<float>(atlas_width_)));
    const int v = static_cast<int>(std::lround(glyph.V0 * static_cast<float>(atlas_height_)));
    const int columns = static_cast<int>(std::lround(glyph.U1 * static_cast<float>(atlas_width_))) - u;
    const int rows = static_cast<int>(std::lround(glyph.V1 * static_cast<float>(atlas_height_))) - v;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const unsigned char coverage = coverage_[(v + row) * atlas_width_ + u + column];
        blend_pixel(image, left + column, top + row, colour, static_cast<float>(coverage) / 255.0F);
      }
    }
    pen += glyph.AdvanceX;
  }
}

std::filesystem::path Typeface::default_file() { return "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"; }

Typeface::Typeface(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  data_.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  if (data_.empty()) {
    throw InputError(
        fmt::format("{}: the font for frames cannot be read; install the Debian package "
                    "fonts-dejavu-core",
                    file.string()));
  }
}

const Font& Typeface::size(int height) {
  std::unique_ptr<Font>& font = fonts_[height];
  if (!font) font = std::make_unique<Font>(data_, height);
  return *font;
}

}  // namespace eisph
