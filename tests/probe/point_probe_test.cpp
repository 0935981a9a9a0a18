#include "probe/point_probe.hpp"

#include "probe/hand_made.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

class SampleAt : public testing::TestWithParam<int> {
 protected:
  Scene scene_ = hand_made_scene(GetParam());
  Snapshot water_ = hand_made_snapshot(scene_, lattice(scene_, Vec3d(0.4, 0.4, 0.2)));

  /// A point by its offsets in x and z from the lower corner of the domain, metres, half-way across in y.
  [[nodiscard]] Vec3d at(double x, double z) const {
    return scene_.domain_min + Vec3d(x, GetParam() == 2 ? 0.0 : 0.2, z);
  }
};

TEST_P(SampleAt, IsExactForAConstantFieldUpToWallsCornersAndTheSurface) {
  for (std::size_t k = 0; k < water_.size(); ++k) {
    water_.pressure[k] = 750.0F;
    water_.velocity[k] = Vec3f(1.5F, 0.0F, -0.25F);
  }
  for (const Vec3d& point : {at(0.2, 0.1), at(0.2, 0.0), at(0.0, 0.0), at(0.2, 0.199), scene_.domain_min}) {
    const PointSample sample = sample_at(point, water_);
    EXPECT_TRUE(sample.wet) << point.transpose();
    EXPECT_NEAR(sample.pressure, 750.0, 1e-9);
    EXPECT_NEAR((sample.velocity - Vec3d(1.5, 0.0, -0.25)).norm(), 0.0, 1e-12);
  }
}

TEST_P(SampleAt, ReproducesALinearFieldInsideTheWater) {
  for (std::size_t k = 0; k < water_.size(); ++k) {
    water_.pressure[k] = 9810.0F * (0.3F - water_.position[k].z());
    water_.velocity[k].x() = 2.0F * water_.position[k].x();
  }
  // On a particle and in the middle between particles the lattice is symmetric.
  for (const Vec3d& point : {at(0.21, 0.11), at(0.2, 0.1)}) {
    const PointSample sample = sample_at(point, water_);
    EXPECT_NEAR(sample.pressure, 9810.0 * (0.3 - point.z()), 1e-2);
    EXPECT_NEAR(sample.velocity.x(), 2.0 * point.x(), 1e-6);
  }
}

TEST_P(SampleAt, IsOneSidedByHalfASmoothingLengthAtAWall) {
  for (std::size_t k = 0; k < water_.size(); ++k) {
    water_.pressure[k] = 9810.0F * (0.3F - water_.position[k].z());
  }
  const double error = 9810.0 * 0.2 - sample_at(at(0.2, 0.0), water_).pressure;
  EXPECT_NEAR(error / (9810.0 * water_.smoothing_length), 0.5, 0.1);
}

TEST_P(SampleAt, IsEmptyOutsideTheWater) {
  water_.pressure.assign(water_.size(), 750.0F);
  for (const Vec3d& point : {at(0.2, 0.22), at(0.42, 0.1), at(0.9, 0.1)}) {
    const PointSample sample = sample_at(point, water_);
    EXPECT_FALSE(sample.wet) << point.transpose();
    EXPECT_EQ(sample.pressure, 0.0);
    EXPECT_EQ(sample.velocity, Vec3d::Zero());
  }
}

TEST_P(SampleAt, FindsALoneParticleWithinOneSpacingOnly) {
  Snapshot drop = hand_made_snapshot(scene_, {at(0.2, 0.1).cast<float>()});
  drop.velocity[0] = Vec3f(3.0F, 0.0F, 0.0F);
  const PointSample near = sample_at(at(0.219, 0.1), drop);
  EXPECT_TRUE(near.wet);
  EXPECT_DOUBLE_EQ(near.velocity.x(), 3.0);
  EXPECT_FALSE(sample_at(at(0.221, 0.1), drop).wet);
}

TEST_P(SampleAt, IsEmptyWithoutAnyFluid) {
  EXPECT_FALSE(sample_at(at(0.2, 0.1), hand_made_snapshot(scene_, {})).wet);
}

TEST_P(SampleAt, StaysWetInAHoleBetweenParticlesInsideTheWater) {
  // The nearest particle is more than a spacing away from the middle of a vacancy that is a little widened.
  const Vec3f middle = at(0.21, 0.11).cast<float>() + Vec3f(0.0F, GetParam() == 2 ? 0.0F : 0.01F, 0.0F);
  std::vector<Vec3f> positions;
  for (const Vec3f& position : water_.position) {
    const Vec3f offset = position - middle;
    if (offset.norm() < 0.001F) continue;
    positions.push_back(offset.norm() < 0.0205F ? Vec3f(middle + 1.05F * offset) : position);
  }
  ASSERT_EQ(positions.size() + 1, water_.size());
  EXPECT_TRUE(sample_at(middle.cast<double>(), hand_made_snapshot(scene_, positions)).wet);
}

INSTANTIATE_TEST_SUITE_P(Dimension, SampleAt, testing::Values(2, 3));

}  // namespace
}  // namespace eisph
