#include "scheme/scenes.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// How deep the deepest particle is inside the shape, m; negative: none is.
double deepest(const Snapshot& snapshot, const Shape& shape, int dimension) {
  double depth = -1e9;
  for (const Vec3f& position : snapshot.position) {
    depth = std::max(depth, -shape.signed_distance(position.cast<double>(), dimension));
  }
  return depth;
}

struct ObstacleCase {
  const char* name;
  Shape shape;
};

class Obstacles : public testing::TestWithParam<ObstacleCase> {};

TEST_P(Obstacles, KeepTheWaterOut) {
  const Shape& shape = GetParam().shape;
  const Scene scene = dam_break_3d(shape);
  const auto simulation = start(scene, 2);
  double depth = -1e9;
  for (int part = 1; part <= 10; ++part) {
    run_until(*simulation, 0.03 * part);
    depth = std::max(depth, deepest(*simulation->snapshot(), shape, 3));
  }
  const auto snapshot = simulation->snapshot();
  ASSERT_TRUE(is_finite(*snapshot));
  EXPECT_TRUE(is_inside(*snapshot, scene));
  EXPECT_LE(depth, 1e-6) << "single precision of the snapshot";
  const RunSummary summary = simulation->summary();
  EXPECT_EQ(summary.penetrations, 0U);
  EXPECT_EQ(summary.lost_particles, 0U);
  EXPECT_GT(summary.object_particles, 0U);
  // The wave has reached the obstacle and passed beside it.
  double furthest = 0.0;
  for (const Vec3f& position : snapshot->position) furthest = std::max<double>(furthest, position.x());
  EXPECT_GT(furthest, 0.45);
  double pressure = 0.0;
  for (const float value : snapshot->objects->pressure) pressure = std::max<double>(pressure, value);
  EXPECT_GT(pressure, 100.0) << "Pa, on the obstacle";
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Obstacles,
    testing::Values(ObstacleCase{"box", box(Vec3d(0.3, 0.1, 0.0), Vec3d(0.36, 0.2, 0.2))},
                    ObstacleCase{"turned_box",
                                 box(Vec3d(0.3, 0.1, 0.0), Vec3d(0.38, 0.2, 0.2), std::numbers::pi / 5.0)},
                    ObstacleCase{"cylinder", cylinder(Vec3d(0.33, 0.15, 0.0), 0.05, 0.2)}),
    [](const auto& instance) { return instance.param.name; });

/// A column behind a gate that is lifted at 2 m/s from 0.05 s on.
Scene lifted_gate() {
  Scene scene = tank(2, Vec3d(0.6, 0.0, 0.5), 0.01, box(Vec3d::Zero(), Vec3d(0.15, 0.0, 0.2)));
  Gate gate;
  gate.name = "gate";
  gate.shape = box(Vec3d(0.15, 0.0, 0.0), Vec3d(0.18, 0.0, 0.3));
  gate.motion = GateMotion::Lift;
  gate.start_time = 0.05;
  gate.speed = 2.0;
  gate.stroke = 0.2;
  scene.gates.push_back(gate);
  return scene;
}

double furthest(const Snapshot& snapshot) {
  double x = 0.0;
  for (const Vec3f& position : snapshot.position) x = std::max<double>(x, position.x());
  return x;
}

TEST(Gates, HoldTheWaterUntilTheyAreLiftedAndLetItOutBelow) {
  const auto simulation = start(lifted_gate());
  const std::size_t closed = simulation->snapshot()->objects->position.size();
  while (simulation->time() < 0.05) {
    simulation->step(0.05);
    ASSERT_LE(furthest(*simulation->snapshot()), 0.15 + 1e-6) << "t = " << simulation->time();
  }
  run_until(*simulation, 0.1);
  EXPECT_EQ(simulation->snapshot()->objects->position.size(), closed) << "halfway up";
  EXPECT_GT(furthest(*simulation->snapshot()), 0.16);
  run_until(*simulation, 0.25);
  const auto snapshot = simulation->snapshot();
  EXPECT_TRUE(snapshot->objects->position.empty()) << "gone after 0.1 s";
  EXPECT_GT(furthest(*snapshot), 0.3);
  EXPECT_TRUE(is_finite(*snapshot));
  EXPECT_EQ(simulation->summary().penetrations, 0U);
}

TEST(Gates, ALiftedGateDelaysTheFront) {
  Scene instant = lifted_gate();
  instant.gates[0].motion = GateMotion::Instant;
  const auto slow = start(lifted_gate());
  const auto fast = start(instant);
  run_until(*slow, 0.2);
  run_until(*fast, 0.2);
  EXPECT_LT(furthest(*slow->snapshot()), furthest(*fast->snapshot()));
}

TEST(Gates, WaterRestsBehindAClosedGate) {
  Scene scene = lifted_gate();
  scene.gates[0].start_time = 100.0;
  const auto simulation = start(scene);
  run_until(*simulation, 0.5);
  const auto snapshot = simulation->snapshot();
  EXPECT_LE(furthest(*snapshot), 0.15 + 1e-6);
  EXPECT_LT(hydrostatic_error(*snapshot, 0.2), 0.03);
  EXPECT_EQ(simulation->summary().penetrations, 0U);
}

}  // namespace
}  // namespace eisph
