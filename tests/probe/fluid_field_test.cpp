#include "probe/fluid_field.hpp"

#include "probe/hand_made.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

class FluidFieldTest : public testing::TestWithParam<int> {
 protected:
  Scene scene_ = hand_made_scene(GetParam());

  /// A point by its offsets in x and z from the lower corner of the domain, metres, half-way across in y.
  [[nodiscard]] Vec3d at(double x, double z, double y = 0.25) const {
    return scene_.domain_min + Vec3d(x, GetParam() == 2 ? 0.0 : y, z);
  }
  /// Pressure of water at rest, 0.2 m deep, Pa.
  [[nodiscard]] double pressure_at(const Vec3d& point) const { return 9810.0 * (0.3 - point.z()); }
};

TEST_P(FluidFieldTest, IsFullOfWaterInsideAndHalfFullOnTheSurface) {
  const Snapshot water = still_water(scene_, Vec3d(1.0, 0.5, 0.2));
  const FluidField field(scene_, water);
  for (const double x : {0.0, 0.013, 0.5, 1.0}) {
    EXPECT_NEAR(field.water_fraction(at(x, 0.0)), 1.0, 1e-5) << x;
    EXPECT_NEAR(field.water_fraction(at(x, 0.1234)), 1.0, 1e-5) << x;
    EXPECT_NEAR(field.water_fraction(at(x, 0.2)), 0.5, 1e-5) << x;
    EXPECT_NEAR(field.water_fraction(at(x, 0.24)), 0.0, 1e-5) << x;
  }
}

TEST_P(FluidFieldTest, DoesNotMirrorAtAnOpenFloor) {
  scene_.faces[kZMin].kind = FaceKind::Open;
  const Snapshot water = still_water(scene_, Vec3d(1.0, 0.5, 0.2));
  EXPECT_NEAR(FluidField(scene_, water).water_fraction(at(0.5, 0.0)), 0.5, 1e-6);
}

TEST_P(FluidFieldTest, LeavesTheSpaceOfSolidsOut) {
  scene_.obstacles.push_back({"block", box(Vec3d(0.4, -1.0, 0.1), Vec3d(0.6, 1.0, 0.5))});
  const Snapshot water = still_water(scene_, Vec3d(0.5, 0.5, 0.2));
  const FluidField field(scene_, water);
  EXPECT_NEAR(field.water_fraction(at(0.4, 0.1)), 1.0, 1e-6);
  EXPECT_NEAR(field.water_fraction(at(0.387, 0.1)), 1.0, 1e-6);
  EXPECT_NEAR(field.water_fraction(at(0.6, 0.1)), 0.0, 1e-6) << "the dry side";
  EXPECT_TRUE(field.is_in_solid(at(0.5, 0.1)));
  EXPECT_FALSE(field.is_in_solid(at(0.4, 0.1)));
}

TEST_P(FluidFieldTest, ExtrapolatesHydrostaticPressureToWallsFloorAndCorners) {
  const Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  const FluidField field(scene_, water);
  for (const double z : {0.0, 0.007, 0.1, 0.18, 0.199}) {
    const std::optional<double> pressure = field.wall_pressure(at(0.0, z), Vec3d::UnitX());
    ASSERT_TRUE(pressure) << z;
    EXPECT_NEAR(*pressure, pressure_at(at(0.0, z)), 0.01) << z;
  }
  EXPECT_NEAR(*field.wall_pressure(at(0.2, 0.0), Vec3d::UnitZ()), 1962.0, 0.01);
  EXPECT_NEAR(*field.wall_pressure(at(0.0, 0.0, 0.0), Vec3d::UnitZ()), 1962.0, 0.01);
}

TEST_P(FluidFieldTest, ExtrapolatesLinearPressureOfDisorderedWater) {
  Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  shake(water, 0.2 * scene_.particle_spacing);
  make_hydrostatic(water, scene_, 0.3);
  const FluidField field(scene_, water);
  for (const double z : {0.0, 0.05, 0.15}) {
    EXPECT_NEAR(*field.wall_pressure(at(0.0, z), Vec3d::UnitX()), pressure_at(at(0.0, z)), 0.01) << z;
  }
}

TEST_P(FluidFieldTest, HasNoPressureOnADryWall) {
  const Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  const FluidField field(scene_, water);
  EXPECT_FALSE(field.wall_pressure(at(0.0, 0.21), Vec3d::UnitX()));
  EXPECT_FALSE(field.wall_pressure(at(0.6, 0.0), Vec3d::UnitZ()));
}

TEST_P(FluidFieldTest, TakesTheMeanUnderASingleLayer) {
  Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.02));
  water.pressure.assign(water.size(), 80.0F);
  EXPECT_NEAR(*FluidField(scene_, water).wall_pressure(at(0.2, 0.0), Vec3d::UnitZ()), 80.0, 1e-4);
}

TEST_P(FluidFieldTest, DoesNotExtrapolateBeyondTheRangeOfThePressures) {
  // A jump: the fit's slope would carry it far below zero on the floor.
  Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  for (std::size_t k = 0; k < water.size(); ++k) {
    water.pressure[k] = water.position[k].z() > 0.125F ? 1000.0F : 0.0F;
  }
  const double pressure = *FluidField(scene_, water).wall_pressure(at(0.2, 0.0), Vec3d::UnitZ());
  EXPECT_GE(pressure, 0.0);
  EXPECT_LT(pressure, 100.0);
}

TEST_P(FluidFieldTest, DoesNotFeelTheWaterBehindAThinWall) {
  scene_.obstacles.push_back({"plate", box(Vec3d(0.4, -1.0, 0.1), Vec3d(0.44, 1.0, 0.5))});
  Snapshot water = still_water(scene_, Vec3d(1.0, 0.5, 0.2));
  for (std::size_t k = 0; k < water.size(); ++k) {
    if (water.position[k].x() > 0.42F) water.pressure[k] = 1e6F;
  }
  const FluidField field(scene_, water);
  EXPECT_NEAR(*field.wall_pressure(at(0.4, 0.1), -Vec3d::UnitX()), 981.0, 0.01);
  EXPECT_NEAR(*field.wall_pressure(at(0.44, 0.1), Vec3d::UnitX()), 1e6, 1.0);
}

TEST_P(FluidFieldTest, SamplesAsAllParticlesOneByOne) {
  Snapshot water = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  shake(water, 0.2 * scene_.particle_spacing);
  for (std::size_t k = 0; k < water.size(); ++k)
    water.velocity[k] = Vec3f(1.0F, 0.5F, 2.0F) * water.position[k].x();
  const FluidField field(scene_, water);
  for (const Vec3d& point : {at(0.0, 0.0), at(0.123, 0.08), at(0.4, 0.2), at(0.7, 0.1)}) {
    const PointSample one_by_one = sample_at(point, water);
    const PointSample sample = field.sample_at(point);
    EXPECT_EQ(sample.wet, one_by_one.wet);
    EXPECT_NEAR(sample.pressure, one_by_one.pressure, 1e-9);
    EXPECT_NEAR((sample.velocity - one_by_one.velocity).norm(), 0.0, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Dimension, FluidFieldTest, testing::Values(2, 3));

TEST(StandingSolids, AreLiftedWithTheirGatesUntilTheseAreGone) {
  Scene scene = hand_made_scene(3);
  scene.obstacles.push_back({"block", box(Vec3d(0.4, 0.1, 0.1), Vec3d(0.6, 0.2, 0.5))});
  Gate gate;
  gate.name = "gate";
  gate.shape = box(Vec3d(0.2, 0.0, 0.1), Vec3d(0.25, 0.5, 0.5));
  gate.motion = GateMotion::Lift;
  gate.start_time = 1.0;
  gate.speed = 2.0;
  gate.stroke = 0.5;
  scene.gates.push_back(gate);
  const auto lifted = standing_solids(scene, 1.125);
  ASSERT_EQ(lifted.size(), 2U);
  EXPECT_EQ(lifted[1].name, "gate");
  EXPECT_DOUBLE_EQ(lifted[1].shape.min.z(), 0.35);
  EXPECT_EQ(standing_solids(scene, 0.0)[1].shape, gate.shape);
  EXPECT_EQ(standing_solids(scene, 1.3).size(), 1U);
}

}  // namespace
}  // namespace eisph
