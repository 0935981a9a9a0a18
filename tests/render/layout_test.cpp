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
                                                 {2000, 400}, {160, 160}, {400, 1500}, {3840, 2160}};
const std::string kCaption =
    "A caption that tells at some length what is to be seen, so that it takes more than a line on most "
    "frames, and "
    "on the smallest ones is cut off.";

bool overlap(const PixelRectangle& a, const PixelRectangle& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

std::vector<PixelRectangle> places(const FrameLayout& layout) {
  return {layout.title,  layout.time,  layout.picture, layout.legend_label,
          layout.legend, layout.scale, layout.caption};
}

TEST(FrameLayout, NothingOverlapsOrLeavesTheFrame) {
  Typeface typeface;
  for (const auto& [width, height] : kSizes) {
    const auto rectangles = places(
        lay_out_frame(width, height, typeface,
                      {.time = "t = 10.125 s", .legend_label = "velocity in x (m/s)", .caption = kCaption}));
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
    const FrameLayout layout = lay_out_frame(
        width, height, typeface, {.time = "t = 10.125 s", .legend_label = scale.label, .caption = kCaption});
    Image image(width, height);
    fill_rectangle(image, {0, 0, width, height}, Colour{1.0F, 1.0F, 1.0F});
    draw_title(image, layout, typeface, colours, std::string(300, 'W'), "t = 10.125 s");
    draw_colour_bar(image, layout, typeface, colours, scale, map, -100.0, colours.page);
    LengthScale length = length_scale(333.0, layout.picture.width, layout.scale.width);
    length.texts.insert(length.texts.begin(),
                        "a text that is longer than most frames are wide " + std::string(400, 'x'));
    draw_length_scale(image, layout, typeface, colours, length);
    draw_caption(image, layout, typeface, colours);
    int outside = 0;
    const int tolerance = layout.text_height / 4;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (image.pixel(x, y)[1] == 255) continue;
        bool inside = false;
        for (const PixelRectangle& place :
             {layout.title, layout.time, layout.legend_label, layout.legend, layout.scale, layout.caption}) {
          inside = inside || (x >= place.x - 1 && x <= place.right() && y >= place.y - tolerance &&
                              y < place.bottom() + tolerance);
        }
        if (!inside) ++outside;
      }
    }
    EXPECT_EQ(outside, 0) << width << " x " << height;
  }
}

TEST(FrameLayout, ACaptionIsBrokenIntoAtMostThreeLines) {
  Typeface typeface;
  const FrameLayout wide = lay_out_frame(3840, 2160, typeface, {.time = "t", .caption = "Two words"});
  EXPECT_THAT(wide.caption_lines, ::testing::ElementsAre("Two words"));
  const FrameLayout narrow = lay_out_frame(160, 400, typeface, {.time = "t", .caption = kCaption});
  ASSERT_EQ(narrow.caption_lines.size(), 3U);
  EXPECT_THAT(narrow.caption_lines[0], ::testing::StartsWith("A caption"));
  EXPECT_THAT(narrow.caption_lines[2], ::testing::EndsWith("\u2026"));
  for (const std::string& line : narrow.caption_lines)
    EXPECT_LE(typeface.size(narrow.caption_height).width(line), narrow.caption.width);
  const FrameLayout none = lay_out_frame(640, 480, typeface, {.time = "t"});
  EXPECT_TRUE(none.caption_lines.empty());
  EXPECT_EQ(none.caption.height, 0);
}

TEST(FrameLayout, WithoutALegendThePictureIsNotLower) {
  Typeface typeface;
  const FrameLayout with = lay_out_frame(640, 480, typeface, {.time = "t", .legend_label = "speed (m/s)"});
  const FrameLayout without = lay_out_frame(640, 480, typeface, {.time = "t"});
  EXPECT_EQ(without.picture.height, with.picture.height);
  EXPECT_EQ(without.legend.width, 0);
  EXPECT_GT(without.scale.width, with.scale.width);
}

TEST(PanelPlaces, FillTheAreaWithoutOverlap) {
  for (const PixelRectangle& area : {PixelRectangle{10, 20, 1200, 600}, PixelRectangle{10, 20, 480, 700}}) {
    for (std::size_t count = 1; count <= 5; ++count) {
      const std::vector<PixelRectangle> panels = panel_places(area, count, 12);
      ASSERT_EQ(panels.size(), count);
      int covered = 0;
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_GE(panels[i].x, area.x);
        EXPECT_GE(panels[i].y, area.y);
        EXPECT_LE(panels[i].right(), area.right());
        EXPECT_LE(panels[i].bottom(), area.bottom());
        EXPECT_LE(panels[i].width * panels[i].height, panels[0].width * panels[0].height);
        covered += panels[i].width * panels[i].height;
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(panels[i], panels[j])) << i << " " << j;
      }
      EXPECT_GT(covered, area.width * area.height * 9 / 10);
    }
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
