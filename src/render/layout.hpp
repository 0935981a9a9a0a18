#pragma once

#include "render/colour.hpp"
#include "render/colour_map.hpp"
#include "render/field.hpp"
#include "render/font.hpp"
#include "render/image.hpp"
#include "render/palette.hpp"

#include <string>
#include <utility>
#include <vector>

namespace eisph {

/// Places of everything on a frame; no two overlap. Captions shrink with the frame.
struct FrameLayout {
  int text_height = 0;   ///< pixels, of ordinary text
  int title_height = 0;  ///< pixels
  PixelRectangle title;
  PixelRectangle time;
  PixelRectangle picture;
  PixelRectangle legend_label;
  PixelRectangle legend;  ///< colour bar with the numbers below it, or names of kinds
  PixelRectangle scale;   ///< length scale with the text below it
};

/// `time` and `legend_label` are the texts that must have room. Throws InputError for a frame that is too
/// small to be read or too large to be drawn.
[[nodiscard]] FrameLayout lay_out_frame(int width, int height, Typeface& typeface, const std::string& time,
                                        const std::string& legend_label);

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
void draw_length_scale(Image& image, const FrameLayout& layout, Typeface& typeface, const Palette& colours,
                       const LengthScale& scale);

}  // namespace eisph
