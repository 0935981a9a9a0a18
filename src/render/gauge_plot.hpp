#pragma once

#include "render/font.hpp"
#include "render/image.hpp"
#include "render/palette.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace eisph {

/// What a gauge has recorded so far.
struct GaugeCurve {
  std::string name;
  std::vector<double> time;     ///< s, rising
  std::vector<double> surface;  ///< m above the floor
};

/// Axes of a plot of levels over time.
struct GaugeAxes {
  double end_time = 1.0;  ///< s, right end
  double top = 1.0;       ///< m, upper end
};

/// From 0 to the end of the run and to a round level above `depth_scale` (m), or above the highest record up
/// to `now` if that is higher.
[[nodiscard]] GaugeAxes gauge_axes(const std::vector<GaugeCurve>& curves, double end_time, double depth_scale,
                                   double now);

/// Draws the records up to the time `now` (s) into `place`, with axes, the names of the gauges, and a cursor
/// at `now`.
void draw_gauge_plot(Image& image, const PixelRectangle& place, const std::vector<GaugeCurve>& curves,
                     const GaugeAxes& axes, double now, const Font& font, const Palette& colours);

/// A dot in the colour of the curve `index` (from 0), with a rim, about (x, y). Pixels.
void draw_gauge_mark(Image& image, double x, double y, double radius, std::size_t index,
                     const Palette& colours);

}  // namespace eisph
