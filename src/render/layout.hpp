#pragma once

#include "render/colour.hpp"
#include "render/colour_map.hpp"
#include "render/field.hpp"
#include "render/font.hpp"
#include "render/image.hpp"
#include "render/palette.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace eisph {

/// Places of everything on a frame; no two overlap. Captions shrink with the frame.
struct FrameLayout {
  int text_height = 0;     ///< pixels, of ordinary text
  int caption_height = 0;  ///< pixels, of the caption's text
  int title_height = 0;    ///< pixels
  PixelRectangle title;
  PixelRectangle time;
  PixelRectangle picture;
  PixelRectangle legend_label;
  PixelRectangle legend;                   ///< colour bar with the numbers below it, or names of kinds
  PixelRectangle scale;                    ///< length scale with the text below it
  PixelRectangle caption;                  ///< below all; of no height without a caption
  std::vector<std::string> caption_lines;  ///< that fit into it
};

/// Texts that must have room on a frame.
struct FrameTexts {
  std::string time = {};          ///< empty: neither time nor title
  std::string legend_label = {};  ///< empty: no legend
  std::string caption = {};       ///< broken into lines, three at most; empty: none
  int text_height = 0;            ///< pixels, of ordinary text; 0: follows the frame
};

/// Throws InputError for a frame that is too small to be read or too large to be drawn.
[[nodiscard]] FrameLayout lay_out_frame(int width, int height, Typeface& typeface, const FrameTexts& texts);
[[nodiscard]] inline FrameLayout lay_out_frame(int width, int height, Typeface& typeface,
                                               const std::string& time, const std::string& legend_label) {
  return lay_out_frame(width, height, typeface, {.time = time, .legend_label = legend_label});
}
/// Height of ordinary text on a frame of that size, pixels.
[[nodiscard]] int frame_text_height(int width, int height);

/// Places of `count` panels in `area` with `gap` pixels between them. Wide areas have the first at the left
/// and the others, one below the other, at the right; else all lie one below the other, the first the
/// highest.
[[nodiscard]] std::vector<PixelRectangle> panel_places(const PixelRectangle& area, std::size_t count,
                                                       int gap);

/// Length bar: its length in metres and pixels, and what to write below it, the best first.
struct LengthScale {
  double metres = 0.0;
  double pixels = 0.0;
  std::vector<std::string> texts;
};

/// A round length that takes up about a fifth of the picture and fits into `room` pixels.
[[nodiscard]] LengthScale length_scale(double pixels_per_metre, int picture_width, int room);

// Each draws into its place of the layout.
void draw_title(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                const std::string& title, const std::string& time);
/// Below `background_below` (display of dry ground) the bar shows `background`.
void draw_colour_bar(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                     const FieldScale& scale, const ColourMap& map, double background_below,
                     const Colour& background);
void draw_kinds(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                const std::string& label, const std::vector<std::pair<std::string, Colour>>& kinds);
void draw_caption(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours);
void draw_length_scale(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                       const LengthScale& scale);

}  // namespace eisph
