#include "render/layout.hpp"

#include "core/error.hpp"
#include "render/drawing.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::vector<std::pair<int, int>> kSizes = {{640, 480},  {800, 600}, {1280, 720}, {1920, 1080},
                                                 {320, 240},  {300, 900}, {900, 300},  {480, 640},
                                                 {2000, 400}, {160, 160}, {400, 1500}};

bool overlap(const PixelRectangle& a, const PixelRectangle& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

std::vector<PixelRectangle> places(const FrameLayout& layout) {
  return {layout.title, layout.time, layout.picture, layout.legend_label, layout.legend, layout.scale};
}

TEST(FrameLayout, NothingOverlapsOrLeavesTheFrame) {
  Typeface typeface;
  for (const auto& [width, height] : kSizes) {
    const auto rectangles =
        places(lay_out_frame(width, height, typeface, "t = 10.125 s", "velocity in x (m/s)"));
    for (std::size_t i = 0; i < rectangles.size(); ++i) {
      const PixelRectangle& place = rectangles[i];
      EXPECT_TRUE(place.x >= 0 && place.y >= 0 && place.right() <= width && place.bottom() <= height)
          << width << " x " << height << ", place " << i;
      EXPECT_TRUE(place.width > 0 && place.height > 0) << width << " x " << height << ", place " << i;
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(overlap(place, rectangles[j])) << width << " x " << height << ": " << i << " and " << j;
      }
    }
  }
}

TEST(FrameLayout, WhatIsDrawnStaysInItsPlace) {
  Typeface typeface;
  const Palette colours = palette(false);
  const ColourMap map = ColourMap::load("viridis");
  for (const auto& [width, height] : kSizes) {
    const FieldScale scale{"velocity in x (m/s)", -2.5, 2.5};
    const FrameLayout layout = lay_out_frame(width, height, typeface, "t = 10.125 s", scale.label);
    Image image(width, height);
    fill_rectangle(image, {0, 0, width, height}, Colour{1.0F, 1.0F, 1.0F});
    draw_title(image, layout, typeface, colours, std::string(300, 'W'), "t = 10.125 s");
    draw_colour_bar(image, layout, typeface, colours, scale, map, -100.0, colours.page);
    LengthScale length = length_scale(333.0, layout.picture.width, layout.scale.width);
    length.texts.insert(length.texts.begin(),
                        "a text that is longer than most frames are wide " + std::string(400, 'x'));
    draw_length_scale(image, layout, typeface, colours, length);
    int outside = 0;
    const int tolerance = layout.text_height / 4;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (image.pixel(x, y)[1] == 255) continue;
        bool inside = false;
        for (const PixelRectangle& place :
             {layout.title, layout.time, layout.legend_label, layout.legend, layout.scale}) {
          inside = inside || (x >= place.x - 1 && x <= place.right() && y >= place.y - tolerance &&
                              y < place.bottom() + tolerance);
        }
        if (!inside) ++outside;
      }
    }
    EXPECT_EQ(outside, 0) << width << " x " << height;
  }
}

TEST(FrameLayout, TextGrowsWithTheFrame) {
  Typeface typeface;
  const int small = lay_out_frame(640, 480, typeface, "t = 1.00 s", "speed (m/s)").text_height;
  const int large = lay_out_frame(1920, 1080, typeface, "t = 1.00 s", "speed (m/s)").text_height;
  EXPECT_EQ(small, 16);
  EXPECT_EQ(large, 36);
}

TEST(FrameLayout, FramesTooSmallOrTooLargeAreRefused) {
  Typeface typeface;
  EXPECT_THAT([&] { return lay_out_frame(640, 100, typeface, "t", "speed"); },
              ThrowsMessage<InputError>(HasSubstr("640 x 100")));
  EXPECT_THAT([&] { return lay_out_frame(9000, 700, typeface, "t", "speed"); },
              ThrowsMessage<InputError>(HasSubstr("9000 x 700")));
}

TEST(LengthScale, IsARoundLengthThatFits) {
  for (int power = 0; power < 28; ++power) {
    const double pixels_per_metre = 3.0 * std::pow(1.3, power);
    const LengthScale scale = length_scale(pixels_per_metre, 1000, 180);
    EXPECT_LE(scale.pixels, 180.0);
    EXPECT_GE(scale.pixels, 70.0);
    EXPECT_NEAR(scale.pixels, scale.metres * pixels_per_metre, 1e-9);
  }
}

TEST(Font, LongTextsEndInAnEllipsis) {
  Typeface typeface;
  const Font& font = typeface.size(20);
  const std::string title = "A very long title of a dam break with an obstacle";
  EXPECT_EQ(font.shortened(title, 2000), title);
  const std::string cut = font.shortened(title, 200);
  EXPECT_LE(font.width(cut), 200);
  EXPECT_GT(font.width(cut), 170);
  EXPECT_THAT(cut, ::testing::StartsWith("A very long"));
  EXPECT_THAT(cut, ::testing::EndsWith("\u2026"));
  EXPECT_EQ(font.shortened(title, 5), "");
}

TEST(Font, GreekAndSignsAreDrawnAndBrokenTextDoesNoHarm) {
  Typeface typeface;
  const Font& font = typeface.size(20);
  EXPECT_NE(font.width("\u03c1"), font.width("?\u03c1") - font.width("\u03c1"));
  EXPECT_GT(font.width("\u2212"), 0);
  EXPECT_EQ(font.width("\xff"), font.width("\xe2\x80"));
  EXPECT_EQ(font.width(""), 0);
}

TEST(Font, AMissingFileNamesThePackage) {
  EXPECT_THAT([] { return Typeface("/no/such/font.ttf"); },
              ThrowsMessage<InputError>(
                  ::testing::AllOf(HasSubstr("/no/such/font.ttf"), HasSubstr("fonts-dejavu-core"))));
}

}  // namespace
}  // namespace eisph
