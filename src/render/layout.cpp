#include "render/layout.hpp"

#include "core/error.hpp"
#include "render/axis.hpp"
#include "render/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr int kSmallestFrame = 120;
constexpr int kLargestFrame = 8000;

constexpr std::size_t kMostCaptionLines = 3;

/// The text in lines that fit into `width`; what goes beyond the last line is left out.
std::vector<std::string> broken(const std::string& text, const Font& font, int width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (lines.empty()) {
      lines.push_back(word);
      continue;
    }
    const std::string longer = lines.back() + " " + word;
    if (lines.size() == kMostCaptionLines || font.width(longer) <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  for (std::string& line : lines) line = font.shortened(line, width);
  return lines;
}

int line_pitch(int text) { return text * 5 / 4; }

/// Height of a bar with text below it.
int bar_block_height(int text) { return text * 9 / 4; }

}  // namespace

int frame_text_height(int width, int height) {
  return std::max(10, static_cast<int>(std::min(height / 30.0, width / 36.0)));
}

FrameLayout lay_out_frame(int width, int height, Typeface& typeface, const FrameTexts& texts) {
  const auto fits = [](int pixels) { return pixels >= kSmallestFrame && pixels <= kLargestFrame; };
  if (!fits(width) || !fits(height)) {
    throw InputError(fmt::format("image size {} x {}: each side must have from {} to {} pixels", width,
                                 height, kSmallestFrame, kLargestFrame));
  }
  FrameLayout layout;
  const int text = texts.text_height > 0 ? texts.text_height : frame_text_height(width, height);
  const int margin = text * 2 / 3;
  layout.text_height = text;
  layout.title_height = text * 6 / 5;
  const int inner = width - 2 * margin;
  int y = margin;
  if (!texts.time.empty()) {
    const int time_width = std::min(inner, typeface.size(layout.title_height).width(texts.time));
    layout.time = {width - margin - time_width, y, time_width, layout.title_height};
    layout.title = {margin, y, inner - time_width - 2 * text, layout.title_height};
    if (layout.title.width < 10 * text) {
      layout.title.width = inner;
      y += layout.title_height + 2;
      layout.time = {margin, y, time_width, layout.title_height};
    }
    y += layout.title_height + margin;
  }

  const int block = bar_block_height(text);
  const int label_width = typeface.size(text).width(texts.legend_label);
  int bottom = height - margin;
  layout.caption_height = std::max(10, text * 5 / 6);
  layout.caption_lines = broken(texts.caption, typeface.size(layout.caption_height), inner);
  if (!layout.caption_lines.empty()) {
    const int lines = static_cast<int>(layout.caption_lines.size()) * line_pitch(layout.caption_height);
    layout.caption = {margin, bottom - lines, inner, lines};
    bottom -= lines + margin;
  }
  if (texts.legend_label.empty()) {
    layout.scale = {margin, bottom - block, inner, block};
    bottom -= block;
  } else if (inner >= 30 * text) {
    // One row: length scale at the left, label and colour bar at the right.
    const int bar = std::min(inner * 2 / 5, 26 * text);
    layout.legend = {width - margin - bar, bottom - block, bar, block};
    layout.legend_label = {layout.legend.x - text - label_width, bottom - block, label_width, text};
    layout.scale = {margin, bottom - block, layout.legend_label.x - 2 * text - margin, block};
    bottom -= block;
  } else {
    layout.scale = {margin, bottom - block, inner, block};
    bottom -= block + margin;
    layout.legend = {margin, bottom - block, inner, block};
    bottom -= block + text / 3 + text;
    layout.legend_label = {margin, bottom, std::min(label_width, inner), text};
  }
  bottom -= margin;
  layout.picture = {margin, y, inner, std::max(bottom - y, 1)};
  return layout;
}

std::vector<PixelRectangle> panel_places(const PixelRectangle& area, std::size_t count, int gap) {
  if (count <= 1) return std::vector<PixelRectangle>(count, area);
  const bool side_by_side = area.width > area.height * 5 / 4;
  const int others = static_cast<int>(count) - 1;
  PixelRectangle first = area;
  PixelRectangle rest = area;
  if (side_by_side) {
    first.width = (area.width - gap) * 11 / 20;
    rest.x = first.right() + gap;
    rest.width = area.right() - rest.x;
  } else {
    first.height = (area.height - gap) * (others == 1 ? 11 : 9) / 20;
    rest.y = first.bottom() + gap;
    rest.height = area.bottom() - rest.y;
  }
  std::vector<PixelRectangle> places{first};
  const int height = (rest.height - (others - 1) * gap) / others;
  for (int k = 0; k < others; ++k)
    places.push_back({rest.x, rest.y + k * (height + gap), rest.width, height});
  return places;
}

LengthScale length_scale(double pixels_per_metre, int picture_width, int room) {
  LengthScale scale;
  const double wanted = std::min(0.25 * picture_width, static_cast<double>(room));
  scale.metres = round_down_nicely(wanted / pixels_per_metre);
  scale.pixels = scale.metres * pixels_per_metre;
  scale.texts = {length_text(scale.metres)};
  return scale;
}

void draw_title(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                const std::string& title, const std::string& time) {
  const Font& font = typeface.size(layout.title_height);
  font.draw(image, layout.title.x, layout.title.y, font.shortened(title, layout.title.width), colours.text);
  font.draw(image, layout.time.x, layout.time.y, font.shortened(time, layout.time.width), colours.text);
}

void draw_colour_bar(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                     const FieldScale& scale, const ColourMap& map, double background_below,
                     const Colour& background) {
  const Font& font = typeface.size(layout.text_height);
  const int text = layout.text_height;
  const double lower = scale.lower / scale.display_unit;
  const double upper = scale.upper / scale.display_unit;
  std::vector<Tick> marks;
  int widest = 0;
  for (int count = 11; count >= 2; --count) {
    marks = ticks(lower, upper, count);
    widest = 0;
    for (const Tick& mark : marks) widest = std::max(widest, font.width(mark.label));
    if (static_cast<int>(marks.size()) * (widest + text) <= layout.legend.width) break;
  }
  // The first and last number may stand half beside the bar.
  const int inset = widest / 2 + 1;
  const PixelRectangle bar{layout.legend.x + inset, layout.legend.y, layout.legend.width - 2 * inset,
                           text * 4 / 5};
  for (int column = 0; column < bar.width; ++column) {
    const double fraction = (column + 0.5) / bar.width;
    const bool bare = scale.lower + fraction * (scale.upper - scale.lower) < background_below;
    fill_rectangle(image, {bar.x + column, bar.y, 1, bar.height}, bare ? background : map.at(fraction));
  }
  draw_outline(image, bar, 1, colours.line);
  for (const Tick& mark : marks) {
    const int x =
        bar.x + static_cast<int>(std::lround((mark.value - lower) / (upper - lower) * (bar.width - 1)));
    fill_rectangle(image, {x, bar.bottom(), 1, text / 4 + 1}, colours.line);
    const int y = layout.legend.bottom() - text;
    font.draw(image, x - font.width(mark.label) / 2, y, mark.label, colours.text);
  }
  font.draw(image, layout.legend_label.x, layout.legend_label.y - text / 10,
            font.shortened(scale.label, layout.legend_label.width), colours.text);
}

void draw_kinds(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                const std::string& label, const std::vector<std::pair<std::string, Colour>>& kinds) {
  const Font& font = typeface.size(layout.text_height);
  const int text = layout.text_height;
  int x = layout.legend.x;
  int y = layout.legend.y;
  for (const auto& [name, colour] : kinds) {
    const int width = text * 2 + font.width(name);
    if (x > layout.legend.x && x + width > layout.legend.right()) {
      x = layout.legend.x;
      y += text * 5 / 4;
    }
    const PixelRectangle swatch{x + 1, y, text * 3 / 2, text * 4 / 5};
    fill_rectangle(image, swatch, colour);
    draw_outline(image, swatch, 1, colours.line);
    font.draw(image, swatch.right() + text / 2, y - text / 10, name, colours.text);
    x = swatch.right() + text * 2 + font.width(name);
  }
  font.draw(image, layout.legend_label.x, layout.legend_label.y - text / 10,
            font.shortened(label, layout.legend_label.width), colours.text);
}

void draw_caption(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours) {
  const Font& font = typeface.size(layout.caption_height);
  int y = layout.caption.y;
  for (const std::string& line : layout.caption_lines) {
    font.draw(image, layout.caption.x, y, line, colours.text);
    y += line_pitch(layout.caption_height);
  }
}

void draw_length_scale(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                       const LengthScale& scale) {
  const Font& font = typeface.size(layout.text_height);
  const int text = layout.text_height;
  const int line = std::max(1, text / 8);
  const int length = static_cast<int>(std::lround(scale.pixels));
  const PixelRectangle& place = layout.scale;
  const int tip = text * 3 / 5;
  const int y = place.y + text * 4 / 5 - tip / 2;
  fill_rectangle(image, {place.x, y - line / 2, length, line}, colours.text);
  fill_rectangle(image, {place.x, y - tip / 2, line, tip}, colours.text);
  fill_rectangle(image, {place.x + length - line, y - tip / 2, line, tip}, colours.text);
  for (const std::string& caption : scale.texts) {
    if (font.width(caption) > place.width && &caption != &scale.texts.back()) continue;
    font.draw(image, place.x, place.bottom() - text, font.shortened(caption, place.width), colours.text);
    return;
  }
}

}  // namespace eisph
