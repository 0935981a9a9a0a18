#include "probe/gauge.hpp"

#include "probe/hand_made.hpp"

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

TEST(WaterLevel, TakesAnIntervalInXInTwoDimensions) {
  const Scene scene = hand_made_scene(2);
  const Snapshot snapshot = hand_made_snapshot(scene, {{0.5F, 0.0F, 0.3F}, {0.6F, 0.0F, 0.5F}});
  EXPECT_NEAR(water_level(gauge_at(0.5, 7.0, 0.03), scene, snapshot), 0.2, 1e-7);
}

}  // namespace
}  // namespace eisph
