#include "render/comparison_picture.hpp"

#include "render/golden.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr std::array<double, 4> kArea = {0.8, 0.0, 2.6, 1.2};

/// A tank of 2.6 x 1.2 m with a block.
Scene tank() {
  Scene scene;
  scene.dimension = 3;
  scene.particle_spacing = 0.02;
  scene.domain_max = {2.6, 1.2, 0.6};
  Obstacle block;
  block.name = "block";
  block.shape.min = {1.425, 0.45, 0.0};
  block.shape.max = {1.575, 0.75, 0.25};
  scene.obstacles = {block};
  return scene;
}

/// Cells of 30 mm: a wave that has come as far as `front`, deepest where it comes from.
DepthGrid wave(double front) {
  DepthGrid grid;
  grid.time = 0.75;
  grid.cell_size = 0.03;
  grid.columns = 87;
  grid.rows = 40;
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const double x = 0.03 * (static_cast<double>(i) + 0.5);
      const double y = 0.03 * (static_cast<double>(j) + 0.5);
      const double reach = front - std::abs(y - 0.6);
      grid.depth.push_back(static_cast<float>(0.13 * std::max(0.0, (reach - x) / reach)));
    }
  }
  return grid;
}

ColourMap map_of(const char* name) { return ColourMap::load(name); }

/// Colours of an image as 0 to 255.
std::array<int, 3> at(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.pixel(x, y);
  return {pixel[0], pixel[1], pixel[2]};
}

class ComparisonPictures : public testing::Test {
 protected:
  ComparisonPictures() : cells_(simulation_.depth.size(), 1), painter_(tank(), kArea, 480) {
    // The two columns before the far wall do not count.
    for (std::size_t j = 0; j < simulation_.rows; ++j)
      cells_[j * simulation_.columns + 85] = cells_[j * simulation_.columns + 84] = 0;
  }

  DepthGrid simulation_ = wave(2.3);
  DepthGrid photograph_ = wave(2.1);
  std::vector<std::uint8_t> cells_;
  ComparisonPainter painter_;
  ComparisonHeading heading_{"A tank", "t = 0.75 s"};
  DepthSide simulated_{"simulation", simulation_};
  DepthSide measured_{"photograph", photograph_, &cells_};
};

TEST_F(ComparisonPictures, Depths) {
  expect_golden("comparison_depths",
                painter_.depths(heading_, measured_, simulated_, map_of("depth_blue"), 0.15));
}

TEST_F(ComparisonPictures, Overlay) {
  expect_golden("comparison_overlay",
                painter_.overlay(heading_, simulated_, measured_, map_of("grey_depth"), 0.15, 0.005));
}

TEST_F(ComparisonPictures, Deviation) {
  expect_golden("comparison_deviation",
                painter_.deviation(heading_, simulated_, measured_, map_of("blue_red"), 0.05));
}

TEST_F(ComparisonPictures, Halves) {
  expect_golden("comparison_halves",
                painter_.halves(heading_, simulated_, measured_, 0.6, map_of("grey_depth"), 0.15));
}

TEST_F(ComparisonPictures, PhotographWithItsCellsAndUpright) {
  GreyPicture picture(240, 180);
  for (int j = 0; j < picture.height; ++j) {
    for (int i = 0; i < picture.width; ++i) picture.at(i, j) = 0.2F + 0.003F * static_cast<float>(i);
  }
  const PhotographSide photograph{"photograph", picture, [](const Eigen::Vector2d& plane) {
                                    return Eigen::Vector2d(20.0 + 110.0 * (plane.x() - 0.8),
                                                           160.0 - 110.0 * plane.y() + 6.0 * plane.x());
                                  }};
  expect_golden("comparison_grid", painter_.grid_over_photograph(heading_, photograph, simulation_,
                                                                 {{"corner", {20.0, 164.8}}}));
  expect_golden("comparison_photograph",
                painter_.photograph_and_depth(heading_, photograph, simulated_, map_of("grey_depth"), 0.15));
}

TEST_F(ComparisonPictures, NoDeviationIsTheMiddleOfTheMapAndWetAreasAreRed) {
  const Image none = painter_.deviation(heading_, simulated_, simulated_, map_of("blue_red"), 0.05);
  const Colour middle = map_of("blue_red").at(0.5);
  const int x = none.width / 3;
  const int y = none.height / 2;
  EXPECT_NEAR(at(none, x, y)[0], 255.0F * middle.red, 1.0);
  EXPECT_NEAR(at(none, x, y)[2], 255.0F * middle.blue, 1.0);
  const Image deeper = painter_.deviation(heading_, simulated_, measured_, map_of("blue_red"), 0.01);
  EXPECT_GT(at(deeper, x, y)[0], at(deeper, x, y)[2] + 20);  // the simulation is deeper: red
  const Image wet = painter_.overlay(heading_, simulated_, measured_, map_of("grey_depth"), 0.15, 0.005);
  EXPECT_GT(at(wet, x, y)[0], at(wet, x, y)[1] + 20);
  const int dry_x = wet.width * 19 / 20;  // beyond both waves, at the upper edge
  const auto dry = at(wet, dry_x, wet.height / 5);
  EXPECT_LT(std::abs(dry[0] - dry[1]), 3);
}

}  // namespace
}  // namespace eisph
