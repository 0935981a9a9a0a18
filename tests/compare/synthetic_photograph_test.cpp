#include "compare/synthetic_photograph.hpp"

#include "compare/photographed_tank.hpp"
#include "compare/tank_outline.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

TEST(SyntheticCamera, ShowsTheWholeAreaTheRightWayUp) {
  const FloorMap floor = block_floor();
  const SyntheticSettings settings = clean_settings();
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  double nearest = 1e9;
  for (const double x : {0.8, 2.6}) {
    for (const double y : {0.0, 1.2}) {
      const Vector2d pixel = camera.pixel_of({x, y});
      nearest = std::min({nearest, pixel.x(), 700.0 - pixel.x(), pixel.y(), 560.0 - pixel.y()});
    }
  }
  EXPECT_GT(nearest, 0.055 * 560.0);
  EXPECT_LT(nearest, 0.065 * 700.0);
  EXPECT_GT(camera.pixel_of({2.6, 0.0}).x(), camera.pixel_of({0.8, 0.0}).x());
  EXPECT_LT(camera.pixel_of({0.8, 1.2}).y(), camera.pixel_of({0.8, 0.0}).y());
}

TEST(SyntheticCamera, StraightDownIsAPlainScale) {
  SyntheticCamera settings;
  settings.tilt = settings.roll = 0.0;
  const PlaneCamera camera = synthetic_camera(settings, {0.8, 0.0, 2.6, 1.2});
  const Vector2d middle = camera.pixel_of({1.7, 0.6});
  EXPECT_NEAR(middle.x(), 500.0, 1e-9);
  EXPECT_NEAR(middle.y(), 400.0, 1e-9);
  const Vector2d corner = camera.pixel_of({2.6, 1.2});
  EXPECT_NEAR((corner.x() - 500.0) / 0.9, (400.0 - corner.y()) / 0.6, 1e-9);
}

TEST(SyntheticPhotograph, LevelsFollowTheLightAndTheWater) {
  SyntheticSettings settings = clean_settings();
  settings.light.falloff = settings.light.gradient = 0.0;
  const FloorMap floor = block_floor();
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  const GreyPicture photograph = synthetic_photograph(
      settings, camera, floor, [](double, double) { return 0.067; }, 0);
  const auto level = [&](double x, double y) {
    const Vector2d pixel = camera.pixel_of({x, y});
    return 255.0 * photograph.at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  };
  EXPECT_NEAR(level(1.0, 0.5), 235.0 / std::exp(1.0), 0.01);
  EXPECT_NEAR(level(1.5, 0.6), 25.0, 0.01);
  EXPECT_NEAR(255.0 * photograph.at(2, 2), 10.0, 0.01);
}

TEST(SyntheticPhotograph, NoiseHasItsDeviationAndRepeats) {
  SyntheticSettings settings = clean_settings();
  settings.light.noise = 2.0;
  settings.light.falloff = settings.light.gradient = 0.0;
  const FloorMap floor = block_floor();
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  const GreyPicture one = synthetic_photograph(settings, camera, floor, no_water, 1);
  const GreyPicture again = synthetic_photograph(settings, camera, floor, no_water, 1);
  const GreyPicture other = synthetic_photograph(settings, camera, floor, no_water, 2);
  EXPECT_EQ(one.level, again.level);
  const auto mask = floor_mask(floor, camera, 700, 560);
  double squares = 0.0;
  double products = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < mask.size(); ++k) {
    const double off = 255.0 * one.level[k] - 235.0;
    const double other_off = 255.0 * other.level[k] - 235.0;
    if (mask[k] == 0 || off < -50.0) continue;
    squares += off * off;
    products += off * other_off;
    count += 1.0;
  }
  EXPECT_NEAR(std::sqrt(squares / count), 2.0, 0.1);
  EXPECT_LT(std::abs(products), 0.05 * squares);
}

TEST(SyntheticPhotograph, EightBitsAreWholeLevels) {
  SyntheticSettings settings = clean_settings();
  settings.camera.bit_depth = 8;
  const FloorMap floor = block_floor();
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  const GreyPicture photograph = synthetic_photograph(settings, camera, floor, stepped_water, 0);
  for (std::size_t k = 0; k < photograph.level.size(); k += 37)
    EXPECT_NEAR(255.0F * photograph.level[k], std::round(255.0F * photograph.level[k]), 1e-4);
}

TEST(DepthBetween, IsBilinearAndConstantBeyondTheCentres) {
  DepthGrid grid;
  grid.cell_size = 0.5;
  grid.origin_x = 1.0;
  grid.columns = 2;
  grid.rows = 2;
  grid.depth = {0.0F, 1.0F, 2.0F, 5.0F};
  EXPECT_DOUBLE_EQ(depth_between(grid, 1.25, 0.25), 0.0);
  EXPECT_DOUBLE_EQ(depth_between(grid, 1.5, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(depth_between(grid, 1.5, 0.5), 2.0);
  EXPECT_DOUBLE_EQ(depth_between(grid, 9.0, 9.0), 5.0);
  EXPECT_DOUBLE_EQ(depth_between(grid, 0.0, 0.0), 0.0);
}

TEST(TankOutline, FindsTheCornersInANoisyPhotograph) {
  SyntheticSettings settings = clean_settings();
  settings.camera.bit_depth = 8;
  settings.light.noise = 1.5;
  const FloorMap floor = block_floor();
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  const TankOutline outline = find_tank_outline(synthetic_photograph(settings, camera, floor, no_water, 0));
  const std::array<Vector2d, 4> corners = {Vector2d(0.8, 0.0), {2.6, 0.0}, {2.6, 1.2}, {0.8, 1.2}};
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_LT((outline.corners[k] - camera.pixel_of(corners[k])).norm(), 0.3);
  EXPECT_LT(outline.bow, 0.5);
}

TEST(TankOutline, IgnoresAnInterruptedEdgeAndMeasuresDistortion) {
  SyntheticSettings settings = clean_settings();
  settings.camera.radial_distortion = -0.03;
  FloorMap floor = block_floor();
  // A solid that covers a third of the left edge.
  floor.solid_distance = [](double x, double y) { return std::max(x - 0.9, std::abs(y - 0.4) - 0.2); };
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  const TankOutline outline = find_tank_outline(synthetic_photograph(settings, camera, floor, no_water, 0));
  EXPECT_LT((outline.corners[3] - camera.pixel_of({0.8, 1.2})).norm(), 4.0);
  EXPECT_GT(outline.bow, 0.5);
}

TEST(TankOutline, RefusesAPictureWithoutAFloor) {
  GreyPicture grey(200, 100);
  std::fill(grey.level.begin(), grey.level.end(), 0.5F);
  EXPECT_THAT(error_of<InputError>([&] { (void)find_tank_outline(grey); }), HasSubstr("reference points"));
  for (int k = 0; k < 40; ++k) grey.at(50 + k % 8, 50 + k / 8) = 1.0F;
  EXPECT_THAT(error_of<InputError>([&] { (void)find_tank_outline(grey); }), HasSubstr("reference points"));
}

}  // namespace
}  // namespace eisph
