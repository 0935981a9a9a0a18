#include "scheme/column_geometry.hpp"

#include "scheme/scenes.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

Shape ball(const Vec3d& centre, double radius) {
  Shape shape;
  shape.kind = ShapeKind::Sphere;
  shape.centre = centre;
  shape.radius = radius;
  return shape;
}

TEST(VerticalExtent, OfABoxIsItsHeightInsideItsOutline) {
  const Shape shape = box(Vec3d(0.0, 0.0, 0.1), Vec3d(2.0, 1.0, 0.4));
  const auto inside = vertical_extent(shape, 1.9, 0.9, 3);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->lower, 0.1);
  EXPECT_EQ(inside->upper, 0.4);
  EXPECT_FALSE(vertical_extent(shape, 2.1, 0.9, 3));
  EXPECT_FALSE(vertical_extent(shape, 1.9, 1.1, 3));
  EXPECT_TRUE(vertical_extent(shape, 1.9, 1.1, 2)) << "2D ignores y";
  EXPECT_FALSE(vertical_extent(shape, 1.9999, 0.5, 3, 1e-3)) << "within the tolerance of the outline";
}

TEST(VerticalExtent, OfATurnedBoxFollowsItsOutline) {
  const Shape shape = box(Vec3d(-1.0, -0.1, 0.0), Vec3d(1.0, 0.1, 1.0), std::numbers::pi / 4.0);
  EXPECT_TRUE(vertical_extent(shape, 0.6, 0.6, 3));
  EXPECT_FALSE(vertical_extent(shape, 0.6, -0.6, 3));
  EXPECT_FALSE(vertical_extent(shape, 0.9, 0.0, 3));
}

TEST(VerticalExtent, OfCylinderAndSphere) {
  const auto pillar = vertical_extent(cylinder(Vec3d(1.0, 1.0, 0.2), 0.5, 0.3), 1.3, 1.3, 3);
  ASSERT_TRUE(pillar);
  EXPECT_NEAR(pillar->upper, 0.5, 1e-15);
  EXPECT_FALSE(vertical_extent(cylinder(Vec3d(1.0, 1.0, 0.2), 0.5, 0.3), 1.4, 1.4, 3));
  const auto chord = vertical_extent(ball(Vec3d(0.0, 0.0, 0.5), 0.5), 0.3, 0.0, 3);
  ASSERT_TRUE(chord);
  EXPECT_NEAR(chord->lower, 0.1, 1e-15);
  EXPECT_NEAR(chord->upper, 0.9, 1e-15);
}

TEST(ColumnWater, CountsWaterAboveTheBedOnceAndWithoutCuts) {
  Scene scene = tank(3, Vec3d(2.0, 2.0, 2.0), 0.1, box(Vec3d::Zero(), Vec3d(1.0, 1.0, 0.5)));
  FluidRegion upper;
  upper.shape = box(Vec3d(0.0, 0.0, 0.4), Vec3d(1.0, 1.0, 0.8));
  upper.velocity = Vec3d(2.0, -1.0, 5.0);
  FluidRegion cut;
  cut.cut = true;
  cut.shape = box(Vec3d(0.0, 0.0, 0.7), Vec3d(1.0, 1.0, 2.0));
  scene.fluid.push_back(upper);
  scene.fluid.push_back(cut);
  const ColumnWater water = water_on_line(scene, 0.5, 0.5, 0.1);
  EXPECT_NEAR(water.depth, 0.6, 1e-15) << "from 0.1 to 0.7 m";
  EXPECT_NEAR(water.discharge_x, 0.3 * 2.0, 1e-15) << "the upper region owns 0.4 to 0.7 m";
  EXPECT_NEAR(water.discharge_y, -0.3, 1e-15);
  EXPECT_EQ(water_on_line(scene, 1.5, 0.5, 0.1).depth, 0.0);
  EXPECT_EQ(water_on_line(scene, 0.5, 0.5, 0.9).depth, 0.0) << "all of it below the bed";
}

TEST(ColumnWater, OfACellIsTheExactShareOfABox) {
  const Scene scene = tank(3, Vec3d(2.0, 2.0, 2.0), 0.1, box(Vec3d::Zero(), Vec3d(1.03, 0.57, 0.5)));
  EXPECT_NEAR(water_in_cell(scene, 1.0, 0.5, 0.1, 0.0).depth, 0.3 * 0.7 * 0.5, 1e-15);
  EXPECT_NEAR(water_in_cell(scene, 0.2, 0.2, 0.1, 0.0).depth, 0.5, 1e-15);
  EXPECT_EQ(water_in_cell(scene, 1.1, 0.5, 0.1, 0.0).depth, 0.0);
}

TEST(ColumnWater, OfAllCellsIsTheVolumeOfACylinder) {
  const Scene scene = tank(3, Vec3d(1.0, 1.0, 1.0), 0.02, cylinder(Vec3d(0.5, 0.5, 0.0), 0.3, 0.2));
  double volume = 0.0;
  for (int j = 0; j < 50; ++j) {
    for (int i = 0; i < 50; ++i) volume += water_in_cell(scene, 0.02 * i, 0.02 * j, 0.02, 0.0).depth * 4e-4;
  }
  EXPECT_NEAR(volume, std::numbers::pi * 0.09 * 0.2, 5e-4 * volume);
}

}  // namespace
}  // namespace eisph
