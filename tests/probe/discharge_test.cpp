#include "probe/discharge.hpp"

#include "probe/hand_made.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

class DischargeTest : public testing::TestWithParam<int> {
 protected:
  Scene scene_ = hand_made_scene(GetParam());
  double width_ = GetParam() == 2 ? 1.0 : 0.5;

  [[nodiscard]] Snapshot stream(const Vec3f& velocity) const {
    Snapshot water = hand_made_snapshot(scene_, lattice(scene_, Vec3d(1.0, 0.5, 0.2)));
    water.velocity.assign(water.size(), velocity);
    return water;
  }
  [[nodiscard]] static DischargeProbe plane(int axis, double position) {
    DischargeProbe probe;
    probe.axis = axis;
    probe.position = position;
    return probe;
  }
};

TEST_P(DischargeTest, OfAUniformStreamIsVelocityTimesSectionWhereverThePlaneIs) {
  const Snapshot water = stream(Vec3f(1.5F, 0.25F, -0.5F));
  const double expected = 1.5 * 0.2 * width_;
  for (const double x : {0.3, 0.3017, 0.305, 0.31, 0.8}) {
    EXPECT_NEAR(discharge(plane(0, x), scene_, water), expected, 1e-6 * expected) << x;
  }
  EXPECT_NEAR(discharge(plane(2, 0.2), scene_, water), -0.5 * width_, 1e-6);
}

TEST_P(DischargeTest, OnAnEndOfTheDomainTakesWhatIsInside) {
  const Snapshot water = stream(Vec3f(1.5F, 0.0F, 0.0F));
  for (const double x : {0.0, 1.0}) EXPECT_NEAR(discharge(plane(0, x), scene_, water), 0.3 * width_, 1e-6);
}

TEST_P(DischargeTest, HasTheSignOfTheVelocityAndIsZeroAwayFromTheWater) {
  Snapshot water = hand_made_snapshot(scene_, lattice(scene_, Vec3d(0.4, 0.5, 0.2)));
  water.velocity.assign(water.size(), Vec3f(-1.0F, 0.0F, 0.0F));
  EXPECT_NEAR(discharge(plane(0, 0.2), scene_, water), -0.2 * width_, 1e-6);
  EXPECT_EQ(discharge(plane(0, 0.6), scene_, water), 0.0);
}

TEST_P(DischargeTest, OfPartOfThePlaneIsThatPart) {
  const Snapshot water = stream(Vec3f(1.0F, 0.0F, 0.0F));
  DischargeProbe probe = plane(0, 0.5);
  probe.band.range[2] = {0.0, 0.155};  // from below the floor to 2 3/4 layers above it
  EXPECT_NEAR(discharge(probe, scene_, water), 0.055 * width_, 1e-6);
}

TEST_P(DischargeTest, IsTheMeanOfAVaryingStreamAboutThePlane) {
  Snapshot water = stream(Vec3f::Zero());
  for (std::size_t k = 0; k < water.size(); ++k) water.velocity[k].x() = 2.0F * water.position[k].x();
  EXPECT_NEAR(discharge(plane(0, 0.437), scene_, water), 0.874 * 0.2 * width_, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Dimension, DischargeTest, testing::Values(2, 3));

TEST(Discharge, ThroughAStripAcrossTheTankIsThatOfTheStrip) {
  const Scene scene = hand_made_scene(3);
  Snapshot water = hand_made_snapshot(scene, lattice(scene, Vec3d(1.0, 0.5, 0.2)));
  water.velocity.assign(water.size(), Vec3f(1.0F, 2.0F, 0.0F));
  DischargeProbe probe;
  probe.position = 0.5;
  probe.band.range[1] = {0.123, 0.345};
  EXPECT_NEAR(discharge(probe, scene, water), 0.2 * 0.222, 1e-6);
  probe = {};
  probe.axis = 1;
  probe.position = 0.25;
  probe.band.range[0] = {0.5, 2.0};
  EXPECT_NEAR(discharge(probe, scene, water), 2.0 * 0.5 * 0.2, 1e-6);
}

}  // namespace
}  // namespace eisph
