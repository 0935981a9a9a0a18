#include "core/shape.hpp"

#include "core/scene.hpp"
#include "core/schedule.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(Shape, BoxDistanceIsExactInsideOnFacesAndAtCorners) {
  Shape box;
  box.min = Vec3d(0.0, 0.0, 0.0);
  box.max = Vec3d(2.0, 4.0, 6.0);
  EXPECT_DOUBLE_EQ(box.signed_distance(Vec3d(0.5, 2.0, 3.0), 3), -0.5);
  EXPECT_DOUBLE_EQ(box.signed_distance(Vec3d(2.0, 1.0, 1.0), 3), 0.0);
  EXPECT_DOUBLE_EQ(box.signed_distance(Vec3d(5.0, 8.0, 3.0), 3), 5.0);
  EXPECT_DOUBLE_EQ(box.signed_distance(Vec3d(1.0, 99.0, 7.0), 2), 1.0) << "two dimensions ignore y";
  EXPECT_DOUBLE_EQ(box.volume(3), 48.0);
  EXPECT_DOUBLE_EQ(box.volume(2), 12.0);
}

TEST(Shape, RotatedBoxHasTheBoundsOfItsCorners) {
  Shape box;
  box.min = Vec3d(0.0, 0.0, 0.0);
  box.max = Vec3d(4.0, 2.0, 1.0);
  box.rotation_z = std::numbers::pi / 2.0;
  Vec3d lower;
  Vec3d upper;
  box.bounds(lower, upper);
  EXPECT_TRUE(lower.isApprox(Vec3d(1.0, -1.0, 0.0), 1e-12));
  EXPECT_TRUE(upper.isApprox(Vec3d(3.0, 3.0, 1.0), 1e-12));
  EXPECT_TRUE(box.contains(Vec3d(2.0, 2.9, 0.5), 3));
  EXPECT_FALSE(box.contains(Vec3d(3.5, 1.0, 0.5), 3));
}

TEST(Shape, CylinderStandsOnItsBase) {
  Shape cylinder;
  cylinder.kind = ShapeKind::Cylinder;
  cylinder.centre = Vec3d(1.0, 1.0, 0.5);
  cylinder.radius = 0.5;
  cylinder.height = 2.0;
  EXPECT_NEAR(cylinder.signed_distance(Vec3d(1.0, 1.0, 0.6), 3), -0.1, 1e-12);
  EXPECT_NEAR(cylinder.signed_distance(Vec3d(1.0, 1.0, 0.2), 3), 0.3, 1e-12);
  EXPECT_NEAR(cylinder.signed_distance(Vec3d(1.8, 1.0, 2.9), 3), 0.5, 1e-12) << "from the rim";
}

TEST(Schedule, MeetsTimesAndMultiplesOfTheInterval) {
  const Schedule schedule{.times = {0.25, 0.7}, .interval = 0.3};
  EXPECT_DOUBLE_EQ(schedule.next_after(-0.001), 0.0);
  EXPECT_DOUBLE_EQ(schedule.next_after(0.0), 0.25);
  EXPECT_DOUBLE_EQ(schedule.next_after(0.25), 0.3);
  EXPECT_DOUBLE_EQ(schedule.next_after(0.6), 0.7);
  EXPECT_TRUE(schedule.is_due(0.0));
  EXPECT_TRUE(schedule.is_due(0.7));
  EXPECT_FALSE(schedule.is_due(0.5));
  EXPECT_TRUE(std::isinf(Schedule{}.next_after(0.0)));
}

TEST(Gate, RisesAtItsSpeedAndIsGoneAfterItsStroke) {
  Gate gate;
  gate.motion = GateMotion::Lift;
  gate.start_time = 1.0;
  gate.speed = 2.5;
  gate.stroke = 0.2;
  EXPECT_EQ(gate.lift(0.5), 0.0);
  EXPECT_NEAR(gate.lift(1.04).value_or(-1.0), 0.1, 1e-12);
  EXPECT_FALSE(gate.lift(1.081).has_value());
  gate.motion = GateMotion::Instant;
  EXPECT_EQ(gate.lift(0.99), 0.0);
  EXPECT_FALSE(gate.lift(1.0).has_value());
}

}  // namespace
}  // namespace eisph
