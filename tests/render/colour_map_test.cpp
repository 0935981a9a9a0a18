#include "render/colour_map.hpp"

#include "core/assets.hpp"
#include "core/error.hpp"
#include "render/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// CIELAB under D65.
std::array<double, 3> lab(const Colour& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double r = linear(colour.red);
  const double g = linear(colour.green);
  const double b = linear(colour.blue);
  const auto f = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  };
  const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double lightness(const ColourMap& map, int row) { return lab(map.table()[static_cast<std::size_t>(row)])[0]; }

/// Colour difference (CIE 1976) of row and the next one.
double step(const ColourMap& map, int row) {
  const auto first = lab(map.table()[static_cast<std::size_t>(row)]);
  const auto second = lab(map.table()[static_cast<std::size_t>(row) + 1]);
  return std::hypot(first[0] - second[0], first[1] - second[1], first[2] - second[2]);
}

TEST(ColourMap, RowsAreHitExactlyAndValuesBetweenAreLinear) {
  const ColourMap map = ColourMap::load("viridis");
  for (const int row : {0, 1, 128, 254, 255}) {
    const Colour expected = map.table()[static_cast<std::size_t>(row)];
    EXPECT_NEAR(map.at(row / 255.0).green, expected.green, 1e-6);
  }
  const Colour half = map.at(100.5 / 255.0);
  EXPECT_NEAR(half.red, 0.5 * (map.table()[100].red + map.table()[101].red), 1e-6);
}

TEST(ColourMap, ValuesOutsideAreClampedAndNotANumberIsTheLowerEnd) {
  const ColourMap map = ColourMap::load("cividis");
  EXPECT_EQ(map.at(-3.0), map.table().front());
  EXPECT_EQ(map.at(7.0), map.table().back());
  EXPECT_EQ(map.at(std::numeric_limits<double>::quiet_NaN()), map.table().front());
}

TEST(ColourMap, ViridisHasItsPublishedEnds) {
  const ColourMap map = ColourMap::load("viridis");
  EXPECT_NEAR(map.at(0.0).red, 0.267004, 1e-5);
  EXPECT_NEAR(map.at(0.0).blue, 0.329415, 1e-5);
  EXPECT_NEAR(map.at(1.0).red, 0.993248, 1e-5);
  EXPECT_NEAR(map.at(1.0).green, 0.906157, 1e-5);
}

TEST(ColourMap, LightnessRisesInViridisAndCividis) {
  for (const char* name : {"viridis", "cividis"}) {
    const ColourMap map = ColourMap::load(name);
    for (int row = 0; row < 255; ++row)
      EXPECT_LT(lightness(map, row), lightness(map, row + 1)) << name << ' ' << row;
  }
}

TEST(ColourMap, DepthMapsDarkenInEqualSteps) {
  for (const char* name : {"depth_blue", "grey_depth"}) {
    const ColourMap map = ColourMap::load(name);
    for (int row = 0; row < 255; ++row) {
      EXPECT_GT(lightness(map, row), lightness(map, row + 1)) << name << ' ' << row;
      EXPECT_NEAR(step(map, row), step(map, 127), 0.03 * step(map, 127)) << name << ' ' << row;
    }
  }
}

TEST(ColourMap, TheDivergingMapIsLightestAndGreyInTheMiddleAndEquallyDarkAtBothEnds) {
  const ColourMap map = ColourMap::load("blue_red");
  for (int row = 0; row < 127; ++row) EXPECT_LT(lightness(map, row), lightness(map, row + 1)) << row;
  for (int row = 128; row < 255; ++row) EXPECT_GT(lightness(map, row), lightness(map, row + 1)) << row;
  EXPECT_NEAR(lightness(map, 0), lightness(map, 255), 0.1);
  const auto middle = lab(map.at(0.5));
  EXPECT_LT(std::hypot(middle[1], middle[2]), 0.5);
}

TEST(ColourMap, AnUnknownNameListsTheMapsThereAre) {
  EXPECT_THAT(
      [] { return ColourMap::load("rainbow"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("rainbow"), HasSubstr("cividis"), HasSubstr("viridis"))));
  EXPECT_THROW(ColourMap::load("../colour_maps/viridis"), InputError);
}

TEST(ColourMap, BadFilesAreReportedWithTheLine) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "bad.csv";
  std::ofstream(path) << "# comment\n0.1,0.2,0.3\n0.1,1.2,0.3\n";
  EXPECT_THAT([&] { return ColourMap::read(path); }, ThrowsMessage<InputError>(HasSubstr("bad.csv:3")));
  std::ofstream(path) << "0.1,0.2,0.3\n";
  EXPECT_THAT([&] { return ColourMap::read(path); }, ThrowsMessage<InputError>(HasSubstr("1 colours, 256")));
  EXPECT_THAT([&] { return ColourMap::read(folder.path() / "none.csv"); },
              ThrowsMessage<InputError>(HasSubstr("none.csv")));
}

}  // namespace
}  // namespace eisph
