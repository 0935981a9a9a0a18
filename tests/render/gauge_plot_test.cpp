#include "render/gauge_plot.hpp"

#include "render/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Rises from 0 to 0.1 m in 1 s, then jumps to 0.4 m.
GaugeCurve rising() {
  GaugeCurve curve{"rising", {}, {}};
  for (int k = 0; k <= 100; ++k) {
    curve.time.push_back(0.01 * k);
    curve.surface.push_back(k < 100 ? 0.001 * k : 0.4);
  }
  return curve;
}

TEST(GaugeAxes, ReachRoundlyAboveTheDepthAndAllRecordsSoFar) {
  EXPECT_DOUBLE_EQ(gauge_axes({}, 2.0, 0.15, 0.0).top, 0.15);
  EXPECT_DOUBLE_EQ(gauge_axes({}, 2.0, 0.16, 0.0).top, 0.2);
  EXPECT_DOUBLE_EQ(gauge_axes({rising()}, 2.0, 0.15, 0.99).top, 0.15);
  EXPECT_DOUBLE_EQ(gauge_axes({rising()}, 2.0, 0.15, 1.0).top, 0.4);
  EXPECT_DOUBLE_EQ(gauge_axes({rising()}, 2.0, 0.15, 1.0).end_time, 2.0);
}

/// How far the channels of a pixel are from grey, which all but the curve is.
int colourfulness(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.pixel(x, y);
  return std::max(std::abs(pixel[0] - pixel[1]), std::abs(pixel[1] - pixel[2]));
}

TEST(GaugePlot, TheCurveEndsAtTheCursor) {
  Typeface typeface;
  const Font& font = typeface.size(12);
  const Palette colours = palette(false);
  Image image(420, 300);
  fill_rectangle(image, {0, 0, 420, 300}, colours.page);
  draw_gauge_plot(image, {10, 10, 400, 280}, {rising()}, {1.0, 0.1}, 0.5, font, colours);
  // The cursor: the column with the longest run of dark pixels that is not the left axis.
  int cursor = 0;
  for (int x = 100; x < 400; ++x) {
    int dark = 0;
    for (int y = 40; y < 240; ++y) dark += image.pixel(x, y)[0] < 60 ? 1 : 0;
    if (dark > 180) cursor = x;
  }
  ASSERT_GT(cursor, 0);
  // Below the names there is colour left of the cursor and, but for the dot at the end, none right of it.
  int left = 0;
  int right = 0;
  for (int y = 40; y < 240; ++y) {
    for (int x = 60; x < 400; ++x) {
      if (colourfulness(image, x, y) < 40) continue;
      ++(x < cursor ? left : right);
      EXPECT_LT(x, cursor + 6);
    }
  }
  EXPECT_GT(left, 150);
  EXPECT_LT(right, 40);
}

}  // namespace
}  // namespace eisph
