#include "core/error.hpp"
#include "scheme/shallow_water_exact.hpp"
#include "scheme/shallow_water_rows.hpp"

#include <array>
#include <random>

#include <gmock/gmock.h>

namespace eisph {
namespace {

double volume(const Snapshot& snapshot) {
  double sum = 0.0;
  for (const float depth : snapshot.columns->depth) sum += depth;
  const double cell = snapshot.columns->cell_size;
  return sum * (snapshot.dimension == 2 ? cell : cell * cell);
}

/// A dam break past a block that stands off the axis, in cells of 2 cm.
Scene past_a_block() {
  Scene scene = shallow_tank(3, Vec3d(1.2, 0.6, 0.4), 0.02, box(Vec3d::Zero(), Vec3d(0.4, 0.6, 0.15)));
  scene.obstacles.push_back({"block", box(Vec3d(0.6, 0.1, 0.0), Vec3d(0.74, 0.3, 0.3))});
  scene.shallow_water.manning = 0.007;
  return scene;
}

/// The scene seen in a mirror: x becomes length - x.
Scene mirrored(Scene scene) {
  const double length = scene.domain_max.x();
  const auto turn = [&](Shape& shape) {
    const double lower = shape.min.x();
    shape.min.x() = length - shape.max.x();
    shape.max.x() = length - lower;
  };
  for (FluidRegion& region : scene.fluid) turn(region.shape);
  for (Obstacle& obstacle : scene.obstacles) turn(obstacle.shape);
  return scene;
}

/// x and y exchanged.
Scene transposed(Scene scene) {
  const auto turn = [](Shape& shape) {
    std::swap(shape.min.x(), shape.min.y());
    std::swap(shape.max.x(), shape.max.y());
  };
  for (FluidRegion& region : scene.fluid) turn(region.shape);
  for (Obstacle& obstacle : scene.obstacles) turn(obstacle.shape);
  std::swap(scene.domain_max.x(), scene.domain_max.y());
  return scene;
}

TEST(ShallowWater, KeepsTheVolumeInAClosedTankToRoundOff) {
  const auto simulation = start(past_a_block());
  run_until(*simulation, 2.0);
  EXPECT_NEAR(simulation->summary().mass_error, 0.0, 1e-13);
  EXPECT_NEAR(volume(*simulation->snapshot()), 0.4 * 0.6 * 0.15, 1e-7);
  EXPECT_LT(simulation->summary().energy_final, simulation->summary().energy_initial);
  EXPECT_EQ(simulation->summary().outflow_volume, 0.0);
}

TEST(ShallowWater, AMirroredSceneRunsMirrored) {
  const auto one = start(past_a_block());
  const auto other = start(mirrored(past_a_block()));
  run_until(*one, 0.8);
  run_until(*other, 0.8);
  EXPECT_EQ(one->steps(), other->steps());
  const auto a = one->snapshot();
  const auto b = other->snapshot();
  double moving = 0.0;
  for (std::size_t j = 0; j < a->columns->rows; ++j) {
    for (std::size_t i = 0; i < a->columns->columns; ++i) {
      const std::size_t here = a->columns->index(i, j);
      const std::size_t there = a->columns->index(a->columns->columns - 1 - i, j);
      ASSERT_NEAR(a->columns->depth[here], b->columns->depth[there], 1e-7) << i << " " << j;
      if (a->columns->depth[here] < 1e-3F) continue;
      ASSERT_NEAR(a->columns->velocity_x[here], -b->columns->velocity_x[there], 1e-5);
      ASSERT_NEAR(a->columns->velocity_y[here], b->columns->velocity_y[there], 1e-5);
      moving = std::max<double>(moving, std::abs(a->columns->velocity_y[here]));
    }
  }
  EXPECT_GT(moving, 0.1);
}

TEST(ShallowWater, ASceneWithXAndYExchangedRunsTheSame) {
  const auto one = start(past_a_block());
  const auto other = start(transposed(past_a_block()));
  run_until(*one, 0.8);
  run_until(*other, 0.8);
  const auto a = one->snapshot();
  const auto b = other->snapshot();
  for (std::size_t j = 0; j < a->columns->rows; ++j) {
    for (std::size_t i = 0; i < a->columns->columns; ++i) {
      const std::size_t here = a->columns->index(i, j);
      const std::size_t there = b->columns->index(j, i);
      ASSERT_NEAR(a->columns->depth[here], b->columns->depth[there], 1e-7) << i << " " << j;
      if (a->columns->depth[here] < 1e-3F) continue;
      ASSERT_NEAR(a->columns->velocity_x[here], b->columns->velocity_y[there], 1e-5);
    }
  }
}

TEST(ShallowWater, HalfATankUpToItsPlaneOfSymmetryRunsAsTheWholeOne) {
  Scene whole = past_a_block();
  whole.obstacles[0].shape = box(Vec3d(0.6, 0.2, 0.0), Vec3d(0.74, 0.4, 0.3));
  Scene half = whole;
  half.domain_max.y() = 0.3;
  half.fluid[0].shape.max.y() = 0.3;
  half.faces[kYMax].kind = FaceKind::Symmetry;
  const auto one = start(whole);
  const auto other = start(half);
  run_until(*one, 0.8);
  run_until(*other, 0.8);
  const auto a = one->snapshot();
  const auto b = other->snapshot();
  for (std::size_t k = 0; k < b->columns->size(); ++k) {
    ASSERT_NEAR(a->columns->depth[k], b->columns->depth[k], 1e-7) << k;
  }
}

TEST(ShallowWater, ARowOfCellsAndAWideChannelAgree) {
  const auto row =
      start(shallow_tank(2, Vec3d(1.0, 0.0, 0.4), 0.02, box(Vec3d::Zero(), Vec3d(0.3, 0.0, 0.2))));
  const auto wide =
      start(shallow_tank(3, Vec3d(1.0, 0.2, 0.4), 0.02, box(Vec3d::Zero(), Vec3d(0.3, 0.2, 0.2))));
  run_until(*row, 0.3);
  run_until(*wide, 0.3);
  const auto a = row->snapshot();
  const auto b = wide->snapshot();
  double difference = 0.0;
  for (std::size_t i = 0; i < a->columns->columns; ++i) {
    difference += std::abs(a->columns->depth[i] - b->columns->depth[b->columns->index(i, 4)]) / 50.0;
    EXPECT_NEAR(b->columns->depth[b->columns->index(i, 0)], b->columns->depth[b->columns->index(i, 4)], 1e-7);
  }
  EXPECT_LT(difference, 1e-3) << "their time steps differ";
}

TEST(ShallowWater, GivesTheSameBitsWithAnyNumberOfThreads) {
  const auto run = [](int threads) {
    auto simulation = start(past_a_block(), threads);
    take_steps(*simulation, 150);
    return simulation;
  };
  const auto one = run(1);
  ASSERT_GT(largest_column_speed(*one->snapshot()), 0.5);
  for (const int threads : {2, 3}) {
    const auto other = run(threads);
    EXPECT_EQ(other->time(), one->time());
    EXPECT_EQ(other->snapshot()->columns->depth, one->snapshot()->columns->depth);
    EXPECT_EQ(other->snapshot()->columns->velocity_x, one->snapshot()->columns->velocity_x);
    EXPECT_EQ(other->snapshot()->columns->velocity_y, one->snapshot()->columns->velocity_y);
    EXPECT_EQ(other->summary().energy_final, one->summary().energy_final);
  }
}

TEST(ShallowWater, OnADryRoughBedNeverTakesMoreThanThereIs) {
  Scene scene = shallow_tank(3, Vec3d(1.2, 0.4, 0.5), 0.02, box(Vec3d::Zero(), Vec3d(0.3, 0.4, 0.2)));
  scene.shallow_water.courant = 1.0;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int k = 0; k < 60; ++k) {
    const Vec3d at(0.32 + 0.8 * share(random), 0.36 * share(random), 0.0);
    scene.obstacles.push_back(
        {"stone", box(at, at + Vec3d(0.05, 0.05, 0.002 + 0.12 * std::pow(share(random), 3)))});
  }
  for (const SlopeLimiter limiter : {SlopeLimiter::Minmod, SlopeLimiter::MonotonisedCentral}) {
    scene.shallow_water.limiter = limiter;
    const auto simulation = start(scene);
    for (int k = 0; k < 20; ++k) {
      run_until(*simulation, 0.1 * (k + 1));
      const auto snapshot = simulation->snapshot();
      // Depths are cut off at zero: one that had been below would show as water that was not there before.
      ASSERT_NEAR(simulation->summary().mass_error, 0.0, 1e-13) << k;
      for (const float depth : snapshot->columns->depth) ASSERT_TRUE(depth >= 0.0F && depth < 0.5F);
      ASSERT_LT(largest_column_speed(*snapshot), 4.0) << "Ritter's front runs at 2.8 m/s";
    }
    EXPECT_EQ(simulation->summary().energy_gain_max < 0.05 * simulation->summary().energy_initial, true);
  }
}

TEST(ShallowWater, CellsThatWouldDrainKeepTheirWaterPositive) {
  // Steps far above the stable one ask cells for more than they have.
  Scene scene = shallow_tank(2, Vec3d(1.0, 0.0, 0.5), 0.01, box(Vec3d::Zero(), Vec3d(0.3, 0.0, 0.2)));
  scene.shallow_water.courant = 3.0;
  const auto simulation = start(scene);
  take_steps(*simulation, 40);
  EXPECT_NEAR(simulation->summary().mass_error, 0.0, 1e-13);
}

TEST(ShallowWaterRows, OutflowIsSharedOutWhereThereIsTooLittleWater) {
  // Three cells between walls; 0.3 and 0.1 m2/s leave the middle one, which holds water for half of that.
  ShallowWaterStep step;
  step.time_step = 0.5;
  step.cell_size = 1.0;
  step.dry_depth = 1e-6;
  step.plane = false;
  const std::array<double, 5> depth{0.0, 1.0, 0.1, 1.0, 0.0};
  const std::array<double, 5> velocity{0.0, 0.0, 2.0, 0.0, 0.0};
  const std::array<double, 5> still{};
  const std::array<double, 5> mass{0.0, 0.0, -0.1, 0.3, 0.0};
  std::array<double, 5> share{1.0, 1.0, 1.0, 1.0, 1.0};
  limit_outflow_row(step, &depth[1], &mass[1], nullptr, 0, 3, &share[1]);
  EXPECT_EQ(share[1], 1.0);
  EXPECT_DOUBLE_EQ(share[2], 0.5);
  EXPECT_EQ(share[3], 1.0);

  std::array<double, 5> new_depth{};
  std::array<double, 5> new_x{};
  std::array<double, 5> new_y{};
  const std::array<double, 3> gain_x{0.0, -0.2, 0.3};  // as if all of the momentum had gone
  const UpdateRow row{.old = {&depth[1], &velocity[1], &still[1], &still[1]},
                      .share = &share[1],
                      .mass_x = &mass[1],
                      .flux_y = {},
                      .gain_x = gain_x.data(),
                      .gain_y = &still[1]};
  update_row(step, row, 0, 3, &new_depth[1], &new_x[1], &new_y[1]);
  EXPECT_NEAR(new_depth[1], 1.025, 1e-15);
  EXPECT_NEAR(new_depth[2], 0.0, 1e-15);
  EXPECT_NEAR(new_depth[3], 1.075, 1e-15);
  // Half of 0.3 m2/s x 0.5 s at 2 m/s did not arrive at the right, half of 0.1 at the left.
  EXPECT_NEAR(new_x[3] * new_depth[3], 0.3 - 0.15, 1e-15);
  EXPECT_NEAR(new_x[1] * new_depth[1], -0.05, 1e-15);
}

TEST(ShallowWater, ATallBlockHoldsTheWaterAndALowOneLetsItOver) {
  Scene scene = shallow_tank(2, Vec3d(1.0, 0.0, 0.6), 0.01, box(Vec3d::Zero(), Vec3d(0.3, 0.0, 0.2)));
  scene.obstacles.push_back({"weir", box(Vec3d(0.5, 0.0, 0.0), Vec3d(0.55, 0.0, 0.55))});
  const auto beyond = [](const Snapshot& snapshot) {
    double sum = 0.0;
    for (std::size_t i = 55; i < 100; ++i) sum += 0.01 * snapshot.columns->depth[i];
    return sum;
  };
  const auto tall = start(scene);
  run_until(*tall, 2.0);
  EXPECT_EQ(beyond(*tall->snapshot()), 0.0);
  EXPECT_NEAR(volume(*tall->snapshot()), 0.06, 1e-6);

  scene.obstacles[0].shape.max.z() = 0.06;
  const auto low = start(scene);
  run_until(*low, 20.0);
  // 0.06 m2 of water: 0.03 stay before the weir, 0.027 is room behind it.
  EXPECT_NEAR(beyond(*low->snapshot()), 0.027, 0.004);
  EXPECT_NEAR(low->summary().mass_error, 0.0, 1e-12);
  EXPECT_GT(low->snapshot()->columns->depth[10], 0.055F);
}

TEST(ShallowWater, StreamRoundABlockPilesUpInFrontOfIt) {
  const auto simulation = start(past_a_block());
  run_until(*simulation, 0.6);
  const auto snapshot = simulation->snapshot();
  const ColumnField& columns = *snapshot->columns;
  EXPECT_EQ(columns.depth[columns.index(33, 10)], 0.0F) << "on the block";
  EXPECT_GT(columns.depth[columns.index(28, 10)], 1.5F * columns.depth[columns.index(28, 25)]);
}

TEST(ShallowWater, FrictionSlowsAUniformFlowAsManningSays) {
  // In the middle of a long channel, before the waves from its ends arrive.
  std::vector<DepthAndVelocity> means(400, {0.1, 1.0});
  Scene scene = channel(8.0, 0.02, means);
  scene.shallow_water.manning = 0.03;
  const auto simulation = start(scene);
  run_until(*simulation, 1.0);
  const double k = kGravity * 0.03 * 0.03 / std::pow(0.1, 4.0 / 3.0);
  const auto snapshot = simulation->snapshot();
  EXPECT_NEAR(snapshot->columns->velocity_x[200], 1.0 / (1.0 + k), 1e-6);
  EXPECT_NEAR(snapshot->columns->depth[200], 0.1, 1e-7);
}

Scene gated(GateMotion motion) {
  Scene scene = shallow_tank(2, Vec3d(2.0, 0.0, 0.4), 0.01, box(Vec3d::Zero(), Vec3d(1.0, 0.0, 0.18)));
  Gate gate;
  gate.name = "gate";
  gate.shape = box(Vec3d(1.0, 0.0, 0.0), Vec3d(1.02, 0.0, 0.3));
  gate.motion = motion;
  gate.start_time = 0.1;
  gate.speed = 1.0;
  gate.stroke = 0.3;
  scene.gates.push_back(gate);
  return scene;
}

TEST(ShallowWaterGate, HoldsTheWaterUntilItsTimeAndThenIsGone) {
  const auto simulation = start(gated(GateMotion::Instant));
  run_until(*simulation, 0.1);
  EXPECT_LT(largest_column_speed(*simulation->snapshot()), 1e-13);
  Scene without = gated(GateMotion::Instant);
  without.gates.clear();
  const auto reference = start(without);
  run_until(*simulation, 0.4);
  run_until(*reference, 0.3);
  const auto late = simulation->snapshot();
  const auto early = reference->snapshot();
  EXPECT_GT(late->columns->depth[120], 0.01F);
  for (std::size_t i = 0; i < 200; ++i) {
    ASSERT_NEAR(late->columns->depth[i], early->columns->depth[i], 1e-6) << i;
  }
}

TEST(ShallowWaterGate, OpensExactlyAtItsTimeWhateverTheStep) {
  const auto simulation = start(gated(GateMotion::Instant));
  bool met = false;
  while (simulation->time() < 0.15) {
    simulation->step(0.15);
    met = met || simulation->time() == 0.1;
  }
  EXPECT_TRUE(met);
}

TEST(ShallowWaterGate, LiftedOpensWhenItsEdgePassesTheDepthOfADamBreak) {
  // 4/9 of 0.18 m are 0.08 m, which the edge reaches 0.08 s after it starts.
  const auto simulation = start(gated(GateMotion::Lift));
  run_until(*simulation, 0.179);
  EXPECT_LT(largest_column_speed(*simulation->snapshot()), 1e-13);
  run_until(*simulation, 0.2);
  EXPECT_GT(largest_column_speed(*simulation->snapshot()), 0.5);
}

TEST(ShallowWaterOpenFace, LetsWaterOutAndCountsIt) {
  for (const int face : {kXMin, kXMax, kYMin, kYMax}) {
    Scene scene =
        shallow_tank(3, Vec3d(0.6, 0.6, 0.4), 0.02, box(Vec3d(0.2, 0.2, 0.0), Vec3d(0.4, 0.4, 0.2)));
    scene.faces[static_cast<std::size_t>(face)].kind = FaceKind::Open;
    const auto simulation = start(scene);
    run_until(*simulation, 3.0);
    const RunSummary summary = simulation->summary();
    EXPECT_GT(summary.outflow_volume, 0.7 * 0.008) << face;
    EXPECT_NEAR(summary.mass_error, 0.0, 1e-13) << face;
    EXPECT_NEAR(volume(*simulation->snapshot()) + summary.outflow_volume, 0.008, 1e-7);
  }
}

TEST(ShallowWaterOpenFace, ABoreLeavesWithoutComingBack) {
  const Stoker stoker(0.2, 0.05);
  std::vector<DepthAndVelocity> means(300, {0.05, 0.0});
  for (std::size_t i = 0; i < 200; ++i) means[i].depth = 0.2;
  Scene scene = channel(3.0, 0.01, means);
  scene.faces[kXMax].kind = FaceKind::Open;
  const auto simulation = start(scene);
  run_until(*simulation, 1.0);  // the bore has passed the end, 1 m away, at 0.6 s
  const auto snapshot = simulation->snapshot();
  EXPECT_NEAR(snapshot->columns->depth[290], stoker.middle_depth(), 2e-3);
  EXPECT_GT(simulation->summary().outflow_volume, 0.01);
}

TEST(ShallowWater, MeetsOutputTimesToTheBit) {
  const auto simulation = start(past_a_block());
  for (const double time : {0.1, 0.123456789, 0.2, 0.2000001}) {
    run_until(*simulation, time);
    EXPECT_EQ(simulation->time(), time);
  }
}

TEST(ShallowWater, SnapshotsDoNotChangeTheRun) {
  const auto watched = start(past_a_block());
  const auto alone = start(past_a_block());
  for (int k = 0; k < 60; ++k) {
    watched->step(1e3);
    (void)watched->snapshot();
    alone->step(1e3);
  }
  EXPECT_EQ(watched->snapshot()->columns->depth, alone->snapshot()->columns->depth);
}

TEST(ShallowWater, ParticlesOfASnapshotLieInTheWaterAndShowItsSurface) {
  const auto simulation = start(past_a_block());
  run_until(*simulation, 0.5);
  const auto snapshot = simulation->snapshot();
  const ColumnField& columns = *snapshot->columns;
  ASSERT_TRUE(is_finite(*snapshot));
  std::vector<double> highest(columns.size(), 0.0);
  for (std::size_t k = 0; k < snapshot->size(); ++k) {
    ASSERT_TRUE(k == 0 || snapshot->id[k - 1] < snapshot->id[k]);
    const std::size_t cell = snapshot->id[k] % columns.size();
    const Vec3f& at = snapshot->position[k];
    EXPECT_EQ(cell, columns.index(static_cast<std::size_t>(at.x() / 0.02F),
                                  static_cast<std::size_t>(at.y() / 0.02F)));
    EXPECT_GT(at.z(), columns.bed[cell]);
    EXPECT_LT(at.z(), columns.bed[cell] + columns.depth[cell]);
    EXPECT_NEAR(snapshot->pressure[k], 1000.0 * kGravity * (columns.bed[cell] + columns.depth[cell] - at.z()),
                0.01);
    highest[cell] = std::max<double>(highest[cell], at.z());
  }
  for (std::size_t cell = 0; cell < columns.size(); ++cell) {
    if (columns.depth[cell] < 5e-4F) continue;
    EXPECT_GT(highest[cell], columns.bed[cell] + columns.depth[cell] - 0.0101) << "half a cell or less below";
  }
}

TEST(ShallowWater, InThePlaneParticlesFillTheColumns) {
  const auto simulation =
      start(shallow_tank(2, Vec3d(0.4, 0.0, 0.4), 0.02, box(Vec3d::Zero(), Vec3d(0.2, 0.0, 0.2))));
  EXPECT_EQ(simulation->snapshot()->size(), 100U);
}

TEST(ShallowWater, AStepFarTooLargeEndsInAnErrorThatSaysWhenAndWhere) {
  Scene scene = past_a_block();
  scene.shallow_water.courant = 400.0;
  const auto simulation = start(scene);
  try {
    take_steps(*simulation, 200);
    FAIL() << "the run should have blown up";
  } catch (const BlowUpError& error) {
    EXPECT_THAT(std::string(error.what()), testing::ContainsRegex("t = [0-9.e-]+ s, step [0-9]+"));
    EXPECT_THAT(std::string(error.what()), testing::HasSubstr("the cell at ("));
    EXPECT_THAT(std::string(error.what()), testing::HasSubstr("shallow_water.courant"));
  }
}

TEST(ShallowWater, ADomainThatIsNoWholeNumberOfCellsIsRefused) {
  Scene scene = past_a_block();
  scene.shallow_water.cell_size = 0.035;
  EXPECT_THROW((void)Simulation::create(scene, 1), InputError);
}

}  // namespace
}  // namespace eisph
