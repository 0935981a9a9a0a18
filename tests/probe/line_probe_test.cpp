#include "probe/line_probe.hpp"

#include "probe/hand_made.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(Line, GoesFromStartToEndInEqualSteps) {
  const Scene scene = hand_made_scene(3);
  LineProbe line;
  line.start = Vec3d(0.2, 0.2, 0.1);
  line.end = Vec3d(0.2, 0.5, 0.5);
  line.points = 5;
  const Snapshot empty = hand_made_snapshot(scene, {});
  const auto samples = sample_line(line, FluidField(scene, empty));
  ASSERT_EQ(samples.size(), 5U);
  EXPECT_EQ(samples.front().position, line.start);
  EXPECT_EQ(samples.back().position, line.end);
  EXPECT_DOUBLE_EQ(samples.back().distance, 0.5);
  EXPECT_DOUBLE_EQ(samples[1].distance, 0.125);
  EXPECT_NEAR((samples[1].position - Vec3d(0.2, 0.275, 0.2)).norm(), 0.0, 1e-12);
}

TEST(Line, HoldsTheProfileOfTheWaterAndIsDryAboveIt) {
  for (const int dimension : {2, 3}) {
    Scene scene = hand_made_scene(dimension);
    scene.smoothing_ratio = 1.32;  // the floor is out of reach of the lowest point that is wet
    Snapshot water = still_water(scene, Vec3d(0.4, 0.5, 0.2));
    for (std::size_t k = 0; k < water.size(); ++k)
      water.velocity[k].x() = 3.0F * (water.position[k].z() - 0.1F);
    LineProbe line;  // points half-way between particles, where the lattice is symmetric
    line.start = Vec3d(0.2, dimension == 2 ? 0.0 : 0.2, 0.14);
    line.end = line.start + Vec3d(0.0, 0.0, 0.4);
    line.points = 11;
    const auto samples = sample_line(line, FluidField(scene, water));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(samples[k].sample.wet);
      EXPECT_NEAR(samples[k].sample.velocity.x(), 3.0 * (samples[k].position.z() - 0.1), 1e-5);
      EXPECT_NEAR(samples[k].sample.pressure, 9810.0 * (0.3 - samples[k].position.z()), 0.05);
    }
    for (std::size_t k = 5; k < 11; ++k) EXPECT_FALSE(samples[k].sample.wet);
  }
}

}  // namespace
}  // namespace eisph
