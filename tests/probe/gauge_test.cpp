#include "probe/gauge.hpp"

#include "probe/hand_made.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace eisph {
namespace {

Gauge gauge_at(double x, double y, double size, double height = 0.0) {
  Gauge gauge;
  gauge.x = x;
  gauge.y = y;
  gauge.size = size;
  gauge.height = height;
  return gauge;
}

TEST(WaterLevel, IsTheHighestParticleOfTheColumnAboveTheFloor) {
  const Scene scene = hand_made_scene(3);
  const Snapshot snapshot = hand_made_snapshot(
      scene, {{0.50F, 0.20F, 0.15F}, {0.54F, 0.24F, 0.30F}, {0.56F, 0.20F, 0.55F}, {0.50F, 0.26F, 0.55F}});
  EXPECT_NEAR(water_level(gauge_at(0.5, 0.2, 0.1), scene, snapshot), 0.2, 1e-7);
}

TEST(WaterLevel, IsZeroOverADryColumn) {
  const Scene scene = hand_made_scene(3);
  const Snapshot snapshot = hand_made_snapshot(scene, {{0.5F, 0.2F, 0.15F}});
  EXPECT_EQ(water_level(gauge_at(0.8, 0.2, 0.1), scene, snapshot), 0.0);
  EXPECT_EQ(water_level(gauge_at(0.5, 0.2, 0.1), scene, hand_made_snapshot(scene, {})), 0.0);
}

TEST(WaterLevel, CountsParticlesOnTheEdgeOfTheColumn) {
  Scene scene = hand_made_scene(3);
  scene.domain_max.x() = 3.0;
  const Snapshot snapshot = hand_made_snapshot(scene, {{2.6F, 0.2F, 0.3F}});
  EXPECT_NEAR(water_level(gauge_at(2.55, 0.25, 0.1), scene, snapshot), 0.2, 1e-7);
  EXPECT_NEAR(water_level(gauge_at(2.65, 0.15, 0.1), scene, snapshot), 0.2, 1e-7);
}

TEST(WaterLevel, DefaultsToASideOfOneAndAHalfSpacings) {
  const Scene scene = hand_made_scene(3);
  const Snapshot inside = hand_made_snapshot(scene, {{0.514F, 0.2F, 0.3F}});
  const Snapshot outside = hand_made_snapshot(scene, {{0.516F, 0.2F, 0.3F}});
  EXPECT_GT(water_level(gauge_at(0.5, 0.2, 0.0), scene, inside), 0.0);
  EXPECT_EQ(water_level(gauge_at(0.5, 0.2, 0.0), scene, outside), 0.0);
}

TEST(WaterLevel, LeavesOutSprayAboveTheColumn) {
  const Scene scene = hand_made_scene(3);
  const Snapshot snapshot = hand_made_snapshot(scene, {{0.5F, 0.2F, 0.2F}, {0.5F, 0.2F, 0.4F}});
  EXPECT_NEAR(water_level(gauge_at(0.5, 0.2, 0.1, 0.25), scene, snapshot), 0.1, 1e-7);
  EXPECT_NEAR(water_level(gauge_at(0.5, 0.2, 0.1), scene, snapshot), 0.3, 1e-7);
}

TEST(WaterLevel, IgnoresLooseDropsUnlessTheyAreToCount) {
  const Scene scene = hand_made_scene(3);
  Snapshot snapshot =
      hand_made_snapshot(scene, {{0.5F, 0.2F, 0.2F}, {0.5F, 0.2F, 0.4F}, {0.8F, 0.2F, 0.11F}});
  snapshot.number_density = {0.8F, 0.14F, 0.2F};
  Gauge gauge = gauge_at(0.5, 0.2, 0.1);
  EXPECT_NEAR(water_level(gauge, scene, snapshot), 0.1, 1e-7);
  gauge.ignore_spray = false;
  EXPECT_NEAR(water_level(gauge, scene, snapshot), 0.3, 1e-7);
  EXPECT_NEAR(water_level(gauge_at(0.8, 0.2, 0.1), scene, snapshot), 0.01, 1e-7) << "wets the floor";
}

TEST(WaterLevel, TakesAnIntervalInXInTwoDimensions) {
  const Scene scene = hand_made_scene(2);
  const Snapshot snapshot = hand_made_snapshot(scene, {{0.5F, 0.0F, 0.3F}, {0.6F, 0.0F, 0.5F}});
  EXPECT_NEAR(water_level(gauge_at(0.5, 7.0, 0.03), scene, snapshot), 0.2, 1e-7);
}

class SurfaceLevel : public testing::TestWithParam<int> {
 protected:
  Scene scene_ = hand_made_scene(GetParam());

  [[nodiscard]] double level(const Snapshot& water, double x, double y = 0.2, double height = 0.0) const {
    return surface_level(gauge_at(x, y, 0.0, height), FluidField(scene_, water));
  }
  /// Error of the level of water 0.2 m deep, particle spacings.
  [[nodiscard]] double error(const Snapshot& water, double x, double y = 0.2) const {
    return std::abs(level(water, x, y) - 0.2) / scene_.particle_spacing;
  }
};

TEST_P(SurfaceLevel, IsThatOfStillWaterInsideOnWallsAndInCorners) {
  const Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  for (const double x : {0.0, 0.003, 0.01, 0.1234, 0.2, 0.35}) {
    for (const double y : {0.0, 0.2, 0.4871, 0.5}) EXPECT_LT(error(water, x, y), 1e-4) << x << ", " << y;
  }
  EXPECT_EQ(level(water, 0.6), 0.0);
}

TEST_P(SurfaceLevel, OfOneLayerOfParticlesIsOneSpacing) {
  EXPECT_NEAR(level(still_water(scene_, Vec3d(0.4, 0.5, 0.02)), 0.1), 0.02, 1e-6);
}

TEST_P(SurfaceLevel, OfDisorderedWaterIsGoodToAnEighthOfASpacing) {
  Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  shake(water, 0.1 * scene_.particle_spacing);
  for (double x = 0.0; x < 0.35; x += 0.007) EXPECT_LT(error(water, x), 0.125) << x;
}

TEST_P(SurfaceLevel, DoesNotSeeSprayButTheWaterUnderIt) {
  Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  for (Vec3f& position : water.position) {
    if (position.x() > 0.35F)
      position = Vec3f(0.2F, 0.2F, 0.45F) + 0.1F * (position - Vec3f(0.38F, 0.2F, 0.2F));
  }
  ASSERT_GT(water_level(gauge_at(0.2, 0.2, 0.0), scene_, water), 0.25);
  EXPECT_LT(error(water, 0.2), 1e-4);
}

TEST_P(SurfaceLevel, EndsAtTheTopOfTheColumn) {
  const Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  EXPECT_DOUBLE_EQ(level(water, 0.2, 0.2, 0.125), 0.125);
}

TEST_P(SurfaceLevel, IsThatOfTheWaterAtTheFaceOfASolidAndAboveASubmergedOne) {
  scene_.obstacles.push_back({"high", box(Vec3d(0.2, -1.0, 0.1), Vec3d(0.3, 1.0, 0.5))});
  scene_.obstacles.push_back({"low", box(Vec3d(0.6, -1.0, 0.1), Vec3d(0.7, 1.0, 0.2))});
  const Snapshot water = still_water(scene_, Vec3d(1.0, 0.5, 0.2));
  for (const double x : {0.2, 0.19, 0.3, 0.6, 0.65, 0.7}) EXPECT_LT(error(water, x), 1e-4) << x;
  EXPECT_EQ(level(water, 0.25), 0.0) << "inside the higher one";
}

TEST_P(SurfaceLevel, IsZeroOnADrySolidAndInAnEmptyTank) {
  scene_.obstacles.push_back({"block", box(Vec3d(0.2, -1.0, 0.1), Vec3d(0.4, 1.0, 0.5))});
  EXPECT_EQ(level(still_water(scene_, Vec3d(1.0, 0.5, 0.2)), 0.3), 0.0);
  EXPECT_EQ(level(hand_made_snapshot(scene_, {}), 0.1), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Dimension, SurfaceLevel, testing::Values(2, 3));

TEST(SurfaceLevelOfASlab, CountsImagesOfImagesWhereTheDomainIsNarrowerThanTheKernel) {
  Scene scene = hand_made_scene(3);
  scene.domain_max.y() = 0.04;
  const Snapshot water = still_water(scene, Vec3d(0.4, 0.04, 0.2));
  for (const double y : {0.0, 0.013, 0.04}) {
    EXPECT_NEAR(surface_level(gauge_at(0.2, y, 0.0), FluidField(scene, water)), 0.2, 2e-6) << y;
  }
}

}  // namespace
}  // namespace eisph
