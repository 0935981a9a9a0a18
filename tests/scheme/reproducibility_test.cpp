#include "scheme/scenes.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// The state after 60 steps and what is reported of it.
struct Outcome {
  std::shared_ptr<const Snapshot> snapshot;
  RunSummary summary;
};

Outcome run_sixty_steps(const Scene& scene, int threads) {
  const auto simulation = start(scene, threads);
  take_steps(*simulation, 60);
  return {simulation->snapshot(), simulation->summary()};
}

void expect_same_bits(const Scene& scene) {
  const Outcome one = run_sixty_steps(scene, 1);
  ASSERT_TRUE(is_finite(*one.snapshot));
  ASSERT_GT(largest_speed(*one.snapshot), 0.1) << "something moves";
  for (const int threads : {1, 2, 3}) {
    const Outcome other = run_sixty_steps(scene, threads);
    EXPECT_EQ(other.snapshot->time, one.snapshot->time) << threads << " threads";
    EXPECT_EQ(other.snapshot->id, one.snapshot->id);
    EXPECT_TRUE(other.snapshot->position == one.snapshot->position) << threads << " threads";
    EXPECT_TRUE(other.snapshot->velocity == one.snapshot->velocity) << threads << " threads";
    EXPECT_TRUE(other.snapshot->pressure == one.snapshot->pressure) << threads << " threads";
    EXPECT_TRUE(other.snapshot->number_density == one.snapshot->number_density) << threads << " threads";
    EXPECT_TRUE(other.snapshot->objects->pressure == one.snapshot->objects->pressure) << threads;
    EXPECT_EQ(other.summary.energy_final, one.summary.energy_final);
    EXPECT_EQ(other.summary.compression_max, one.summary.compression_max);
    EXPECT_EQ(other.summary.compression_p95, one.summary.compression_p95);
  }
}

TEST(Reproducibility, TheSameBitsWithAnyNumberOfThreadsInThePlane) {
  Scene scene = dam_break_2d();
  scene.jitter = 0.05;
  expect_same_bits(scene);
}

TEST(Reproducibility, TheSameBitsWithAnyNumberOfThreadsInSpaceWithAnObstacle) {
  expect_same_bits(dam_break_3d(box(Vec3d(0.22, 0.1, 0.0), Vec3d(0.3, 0.2, 0.2)), 0.02));
}

TEST(Reproducibility, SnapshotsDoNotChangeTheRun) {
  const Scene scene = dam_break_2d();
  const auto watched = start(scene);
  for (int k = 0; k < 60; ++k) {
    watched->step(1e3);
    const auto seen = watched->snapshot();
    ASSERT_EQ(seen->step, static_cast<std::uint64_t>(k + 1));
  }
  EXPECT_TRUE(watched->snapshot()->position == run_sixty_steps(scene, 1).snapshot->position);
}

TEST(Reproducibility, RowsOfASnapshotKeepTheirParticle) {
  const auto simulation = start(dam_break_2d());
  const auto before = simulation->snapshot();
  run_until(*simulation, 0.01);
  const auto after = simulation->snapshot();
  ASSERT_EQ(after->id, before->id);
  for (std::size_t k = 0; k < before->size(); ++k) {
    EXPECT_EQ(before->id[k], k);
    EXPECT_LT((after->position[k] - before->position[k]).norm(), 2e-3F) << "g t^2 is 1 mm";
  }
}

}  // namespace
}  // namespace eisph
