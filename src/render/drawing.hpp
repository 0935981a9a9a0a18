#pragma once

#include "render/colour.hpp"
#include "render/image.hpp"

namespace eisph {

// Drawing on an image in memory. Whatever lies outside the image is left out.

/// Mixes `colour` over the pixel with `weight` 0 to 1.
void blend_pixel(Image& image, int x, int y, const Colour& colour, float weight);
void fill_rectangle(Image& image, const PixelRectangle& area, const Colour& colour);
/// Outline of `thickness` pixels around `area`, outside it.
void draw_outline(Image& image, const PixelRectangle& area, int thickness, const Colour& colour);
/// Dashes of `thickness` along a horizontal or vertical rectangle of that thickness.
void fill_dashed(Image& image, const PixelRectangle& line, int dash, const Colour& colour);
/// Copies `source` with its upper left corner at (x, y).
void paste(Image& image, const Image& source, int x, int y);

}  // namespace eisph
