#include "probe/force.hpp"

#include "core/repulsion.hpp"
#include "probe/hand_made.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kWeight = 9810.0;  ///< of water, N/m^3

class WaterForceTest : public testing::TestWithParam<int> {
 protected:
  Scene scene_ = hand_made_scene(GetParam());
  double width_ = GetParam() == 2 ? 1.0 : 0.5;  ///< of the tank

  void put(const Shape& shape) { scene_.obstacles.push_back({"block", shape}); }
  [[nodiscard]] WaterForce force(const Snapshot& water) const {
    ForceProbe probe;
    probe.obstacle = "block";
    return water_force(probe, FluidField(scene_, water));
  }
  /// A box over x and z, across the whole tank, z from the floor.
  [[nodiscard]] static Shape wall(double x_min, double x_max, double bottom, double top) {
    return box(Vec3d(x_min, 0.0, 0.1 + bottom), Vec3d(x_max, 0.5, 0.1 + top));
  }
};

TEST_P(WaterForceTest, OnAnUprightWallIsHalfRhoGHSquaredAtAThirdOfTheDepth) {
  put(wall(0.4, 0.5, 0.0, 0.4));
  const WaterForce result = force(still_water(scene_, Vec3d(0.4, 0.5, 0.2)));
  const double expected = 0.5 * kWeight * 0.2 * 0.2 * width_;
  EXPECT_NEAR(result.force.x(), expected, 1e-4 * expected);
  EXPECT_NEAR(result.force.y(), 0.0, 1e-4 * expected);
  EXPECT_NEAR(result.force.z(), 0.0, 1e-4 * expected) << "the base stands on the floor, the top is dry";
  // Midpoints of 10 rows: 0.5 % off in the moment of a triangle.
  EXPECT_NEAR(result.moment.y(), expected * 0.2 / 3.0, 0.006 * expected * 0.2 / 3.0);
  EXPECT_NEAR(result.wetted_area, 0.2 * width_, 1e-9);
}

TEST_P(WaterForceTest, IsAsGoodAsSaidWhereRowsDoNotEndAtTheSurface) {
  for (const double height : {0.331, 0.337, 0.343, 0.349, 0.355, 0.361, 0.367, 0.373}) {
    scene_.obstacles.clear();
    put(wall(0.4, 0.5, 0.0, height));
    const WaterForce result = force(still_water(scene_, Vec3d(0.4, 0.5, 0.2)));
    const double expected = 0.5 * kWeight * 0.2 * 0.2 * width_;
    EXPECT_NEAR(result.force.x(), expected, 0.3 * 0.1 * 0.1 * expected) << height;
  }
}

TEST_P(WaterForceTest, TakesTheMomentAboutAGivenPoint) {
  put(wall(0.4, 0.5, 0.0, 0.4));
  ForceProbe probe;
  probe.obstacle = "block";
  const Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  const FluidField field(scene_, water);
  const WaterForce about_base = water_force(probe, field);
  probe.moment_point = Vec3d(0.45, 0.25, 0.6);
  const WaterForce about_top = water_force(probe, field);
  EXPECT_NEAR(about_top.moment.y(), about_base.moment.y() - 0.5 * about_base.force.x(), 1e-6);
  EXPECT_EQ(about_top.force, about_base.force);
}

TEST_P(WaterForceTest, OnASubmergedBlockPressesItDownWithTheWaterAboveIt) {
  put(wall(0.4, 0.6, 0.0, 0.1));
  const WaterForce result = force(still_water(scene_, Vec3d(1.0, 0.5, 0.2)));
  const double expected = kWeight * 0.1 * 0.2 * width_;
  EXPECT_NEAR(result.force.z(), -expected, 1e-4 * expected);
  EXPECT_NEAR(result.force.x(), 0.0, 1e-4 * expected);
}

TEST_P(WaterForceTest, LiftsABlockOffTheFloorByTheWeightOfTheWaterThatItDisplaces) {
  put(wall(0.4, 0.6, 0.06, 0.16));
  const WaterForce result = force(still_water(scene_, Vec3d(1.0, 0.5, 0.3)));
  const double expected = kWeight * 0.2 * 0.1 * width_;
  EXPECT_NEAR(result.force.z(), expected, 1e-4 * expected);
}

TEST_P(WaterForceTest, LiftsASphereOrADisc) {
  Shape shape;
  shape.kind = ShapeKind::Sphere;
  shape.centre = Vec3d(0.5, 0.25, 0.26);
  shape.radius = 0.08;
  put(shape);
  const WaterForce result = force(still_water(scene_, Vec3d(1.0, 0.5, 0.36)));
  const double expected = kWeight * shape.volume(GetParam());
  EXPECT_NEAR(result.force.z(), expected, 0.02 * expected);
  EXPECT_NEAR(result.force.x(), 0.0, 1e-3 * expected);
  EXPECT_NEAR(result.moment.norm(), 0.0, 1e-3 * expected * 0.08);
}

TEST_P(WaterForceTest, IsZeroOnADrySolidAndOneThatIsNotThere) {
  put(wall(0.6, 0.7, 0.0, 0.4));
  const Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  EXPECT_EQ(force(water).force, Vec3d::Zero());
  ForceProbe probe;
  probe.obstacle = "gone";
  EXPECT_EQ(water_force(probe, FluidField(scene_, water)).force, Vec3d::Zero());
}

TEST_P(WaterForceTest, OnAGateGoesWithIt) {
  Gate gate;
  gate.name = "block";
  gate.shape = wall(0.4, 0.5, 0.0, 0.4);
  gate.motion = GateMotion::Lift;
  gate.start_time = 1.0;
  gate.speed = 1.0;
  gate.stroke = 0.3;
  scene_.gates.push_back(gate);
  Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  const double closed = 0.5 * kWeight * 0.2 * 0.2 * width_;
  EXPECT_NEAR(force(water).force.x(), closed, 1e-3 * closed);
  water.time = 1.1;  // the upper half of the water is in front of it
  EXPECT_NEAR(force(water).force.x(), 0.25 * closed, 1e-3 * closed);
  water.time = 1.3;
  EXPECT_EQ(force(water).force, Vec3d::Zero());
}

INSTANTIATE_TEST_SUITE_P(Dimension, WaterForceTest, testing::Values(2, 3));

TEST_P(WaterForceTest, IsAlsoWhatTheRepulsionPushesBackWith) {
  put(wall(0.4, 0.5, 0.0, 0.4));
  scene_.reference_depth = 0.2;
  const Repulsion repulsion = repulsion_of_solids(scene_);
  const double distance = 0.5 * repulsion.cutoff;
  // One particle at the middle of the tank's width, without pressure, and one just out of reach.
  const double y = GetParam() == 2 ? 0.0 : 0.25;
  Snapshot water = hand_made_snapshot(scene_, {Vec3d(0.4 - distance, y, 0.3).cast<float>(),
                                               Vec3d(0.4 - 1.1 * repulsion.cutoff, y, 0.2).cast<float>()});
  const double push = water.particle_mass * repulsion.capped(distance);
  ASSERT_GT(push, 0.0);
  EXPECT_NEAR(force(water).force.x(), push, 1e-3 * push);
  EXPECT_NEAR(force(water).force.z(), 0.0, 1e-6 * push);
  // Above the base by 0.2 m, turning it about the y axis.
  EXPECT_NEAR(force(water).moment.y(), 0.2 * push, 1e-3 * push);
  // It grows with the square of the speed once that is larger than expected.
  water.velocity[1] = Vec3f(2.0F * static_cast<float>(scene_.expected_speed()), 0.0F, 0.0F);
  EXPECT_NEAR(force(water).force.x(), 4.0 * push, 4e-3 * push);
  scene_.boundary.object_repulsion = false;
  EXPECT_EQ(force(water).force.x(), 0.0);
}

TEST(WaterForceAround, BlocksInStillWaterAddsUpToNothingSideways) {
  for (const double rotation : {0.0, 0.5}) {
    Scene scene = hand_made_scene(3);
    scene.obstacles.push_back({"block", box(Vec3d(0.4, 0.2, 0.1), Vec3d(0.5, 0.3, 0.4), rotation)});
    const Snapshot water = still_water(scene, Vec3d(1.0, 0.5, 0.2));
    ForceProbe probe;
    probe.obstacle = "block";
    const WaterForce result = water_force(probe, FluidField(scene, water));
    const double one_face = 0.5 * kWeight * 0.2 * 0.2 * 0.1;
    EXPECT_NEAR(result.force.norm(), 0.0, 0.005 * one_face) << rotation;
    EXPECT_NEAR(result.moment.norm(), 0.0, 0.005 * one_face * 0.2) << rotation;
  }
}

TEST(WaterForceAround, AStandingCylinderPressesItDown) {
  Scene scene = hand_made_scene(3);
  Shape cylinder;
  cylinder.kind = ShapeKind::Cylinder;
  cylinder.centre = Vec3d(0.5, 0.25, 0.1);
  cylinder.radius = 0.1;
  cylinder.height = 0.1;
  scene.obstacles.push_back({"block", cylinder});
  ForceProbe probe;
  probe.obstacle = "block";
  const Snapshot water = still_water(scene, Vec3d(1.0, 0.5, 0.2));
  const WaterForce result = water_force(probe, FluidField(scene, water));
  const double expected = kWeight * 0.1 * std::numbers::pi * 0.01;
  EXPECT_NEAR(result.force.z(), -expected, 1e-3 * expected);
  EXPECT_NEAR(result.force.x(), 0.0, 1e-3 * expected);
}

TEST(WaterForceAround, DoesNotCountWhatAnotherSolidCovers) {
  Scene scene = hand_made_scene(3);
  scene.obstacles.push_back({"block", box(Vec3d(0.4, 0.0, 0.1), Vec3d(0.5, 0.5, 0.5))});
  scene.obstacles.push_back({"apron", box(Vec3d(0.2, 0.0, 0.1), Vec3d(0.4, 0.5, 0.2))});
  ForceProbe probe;
  probe.obstacle = "block";
  const Snapshot water = still_water(scene, Vec3d(0.4, 0.5, 0.2));
  const double expected = 0.5 * kWeight * 0.1 * 0.1 * 0.5;
  EXPECT_NEAR(water_force(probe, FluidField(scene, water)).force.x(), expected, 1e-3 * expected);
}

}  // namespace
}  // namespace eisph
