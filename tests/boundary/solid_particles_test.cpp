#include "boundary/solid_particles.hpp"

#include "boundary/tank_scene.hpp"
#include "core/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kSpacing = 0.02;

Scene scene_with(const Shape& shape) {
  Scene scene = tank_scene(3);
  scene.obstacles.push_back({"obstacle", shape});
  return scene;
}

Scene scene_with_gate(const Gate& gate) {
  Scene scene = tank_scene(3);
  scene.gates.push_back(gate);
  return scene;
}

Gate lifted_gate() {
  Gate gate;
  gate.name = "gate";
  gate.shape = box(Vec3d(0.8, -0.2, 0.1), Vec3d(0.84, 0.4, 0.4));
  gate.motion = GateMotion::Lift;
  gate.start_time = 0.5;
  gate.speed = 2.5;
  gate.stroke = 0.2;
  return gate;
}

TEST(SolidParticles, FillAnObstacleWithItsVolume) {
  const SolidParticles solids(scene_with(box(Vec3d(0.8, 0.0, 0.1), Vec3d(0.9, 0.1, 0.2))));
  EXPECT_EQ(solids.particles(), 125U);
  double volume = 0.0;
  for (std::size_t k = 0; k < solids.size(); ++k) {
    if (solids.is_first_side(k)) volume += solids.volume(k);
    EXPECT_EQ(solids.rise_speed(k), 0.0);
    EXPECT_EQ(solids.pressure(k), 0.0F);
  }
  EXPECT_NEAR(volume, 1e-3, 1e-12);
  EXPECT_NEAR(solids.spacing(), kSpacing, 1e-12);
}

TEST(SolidParticles, LeaveOutWhatLiesInsideAnEarlierSolid) {
  Scene scene = scene_with(box(Vec3d(0.8, 0.0, 0.1), Vec3d(0.9, 0.1, 0.2)));
  scene.obstacles.push_back({"overlapping", box(Vec3d(0.84, 0.0, 0.1), Vec3d(0.94, 0.1, 0.2))});
  EXPECT_EQ(SolidParticles(scene).particles(), 125U + 50U);
}

TEST(SolidParticles, LeaveOutWhatLiesOutsideTheDomain) {
  // The images of the particles inside stand for those outside; these would count twice.
  const SolidParticles solids(scene_with(box(Vec3d(0.8, -0.3, 0.1), Vec3d(0.9, -0.1, 0.2))));
  double least = 0.0;
  for (std::size_t k = 0; k < solids.size(); ++k) least = std::min(least, solids.position(k).y());
  EXPECT_GT(least, -0.2);
}

TEST(SolidParticles, AreTheObjectParticlesThatAreReportedOfTheScene) {
  Scene scene = scene_with(cylinder(Vec3d(0.9, 0.1, 0.1), 0.08, 0.2));
  scene.obstacles.push_back({"turned", box(Vec3d(1.0, 0.0, 0.1), Vec3d(1.2, 0.1, 0.3), 0.4)});
  scene.gates.push_back(lifted_gate());
  const SolidParticles solids(scene);
  const SceneSolids reported = scene_solids(scene);
  ASSERT_EQ(solids.particles(), reported.position.size());
  EXPECT_GT(solids.size(), solids.particles()) << "the gate is thin";
  std::size_t particle = 0;
  for (std::size_t k = 0; k < solids.size(); ++k) {
    if (k > 0 && solids.is_first_side(k)) ++particle;
    EXPECT_EQ(solids.position(k), reported.position[particle]);
    EXPECT_EQ(solids.volume(k), reported.volume[particle]);
  }
}

TEST(SolidParticles, AnInstantGateIsThereUntilItsTimeAndGoneFromThenOn) {
  Gate gate = lifted_gate();
  gate.motion = GateMotion::Instant;
  SolidParticles solids(scene_with_gate(gate));
  const std::size_t all = solids.size();
  ASSERT_GT(all, 0U);
  EXPECT_FALSE(solids.update(0.25));
  EXPECT_FALSE(solids.update(0.4999));
  EXPECT_EQ(solids.size(), all);
  EXPECT_TRUE(solids.update(0.5));
  EXPECT_EQ(solids.size(), 0U);
  EXPECT_FALSE(solids.update(0.6)) << "nothing changes any more";
}

TEST(SolidParticles, AGateThatOpensAtTheStartIsNeverThere) {
  Gate gate = lifted_gate();
  gate.motion = GateMotion::Instant;
  gate.start_time = 0.0;
  EXPECT_EQ(SolidParticles(scene_with_gate(gate)).size(), 0U);
}

TEST(SolidParticles, ALiftedGateRisesAtItsSpeedAndVanishesAtTheEndOfItsStroke) {
  SolidParticles solids(scene_with_gate(lifted_gate()));
  const std::size_t all = solids.size();
  const Vec3d closed = solids.position(0);
  EXPECT_FALSE(solids.update(0.4));
  EXPECT_EQ(solids.rise_speed(0), 0.0);
  EXPECT_TRUE(solids.update(0.5)) << "its particles start to move";
  EXPECT_EQ(solids.rise_speed(0), 2.5);
  EXPECT_TRUE(solids.update(0.54));
  EXPECT_NEAR((solids.position(0) - closed - Vec3d(0.0, 0.0, 0.1)).norm(), 0.0, 1e-12);
  EXPECT_EQ(solids.size(), all);
  EXPECT_TRUE(solids.update(0.5801)) << "0.2 m at 2.5 m/s take 0.08 s";
  EXPECT_EQ(solids.size(), 0U);
}

TEST(SolidParticles, WaterPassesUnderALiftedGateAndNotThroughAClosedOne) {
  SolidParticles solids(scene_with_gate(lifted_gate()));
  Vec3d normal;
  Vec3d low(0.81, 0.1, 0.15);
  EXPECT_TRUE(solids.push_out(low, normal));
  solids.update(0.54);
  low = Vec3d(0.81, 0.1, 0.15);
  EXPECT_FALSE(solids.push_out(low, normal)) << "0.05 m above the floor, under the gate raised by 0.1 m";
  Vec3d high(0.81, 0.1, 0.45);
  EXPECT_TRUE(solids.push_out(high, normal)) << "now it reaches higher";
}

TEST(SolidParticles, KeepPressuresByParticleWhenAGateLeaves) {
  Gate gate = lifted_gate();
  gate.motion = GateMotion::Instant;
  Scene scene = scene_with_gate(gate);
  scene.obstacles.push_back({"obstacle", box(Vec3d(1.1, 0.0, 0.1), Vec3d(1.2, 0.1, 0.2))});
  SolidParticles solids(scene);
  for (std::size_t k = 0; k < solids.size(); ++k) {
    solids.pressure(k) = static_cast<float>(solids.position(k).x());
  }
  solids.update(0.5);
  ASSERT_EQ(solids.particles(), 125U);
  for (std::size_t k = 0; k < solids.size(); ++k) {
    EXPECT_EQ(solids.pressure(k), static_cast<float>(solids.position(k).x()));
  }
}

/// Points in and around the shape: after push_out none is inside, and those that were outside have not moved.
void expect_pushed_out(const Shape& shape, const Vec3d& lower, const Vec3d& upper) {
  const SolidParticles solids(scene_with(shape));
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int inside = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Vec3d point;
    for (int d = 0; d < 3; ++d) point[d] = lower[d] + unit(generator) * (upper[d] - lower[d]);
    const Vec3d before = point;
    const double distance = shape.signed_distance(point, 3);
    Vec3d normal = Vec3d::Zero();
    const bool pushed = solids.push_out(point, normal);
    ASSERT_EQ(pushed, distance < 0.0);
    if (!pushed) {
      ASSERT_EQ(point, before);
      continue;
    }
    ++inside;
    ASSERT_NEAR(normal.norm(), 1.0, 1e-9);
    ASSERT_GE(shape.signed_distance(point, 3), 0.0);
    ASSERT_LE(shape.signed_distance(point, 3), 1e-9) << "no further than the surface";
    ASSERT_NEAR((point - before).norm(), -distance, 1e-9) << "by the shortest way";
    ASSERT_GT(normal.dot(point - before), 0.0);
  }
  EXPECT_GT(inside, 200);
}

TEST(SolidParticles, PushOutOfABox) {
  expect_pushed_out(box(Vec3d(0.8, 0.0, 0.1), Vec3d(0.95, 0.1, 0.3)), Vec3d(0.75, -0.05, 0.1),
                    Vec3d(1.0, 0.15, 0.35));
}

TEST(SolidParticles, PushOutOfARotatedBox) {
  expect_pushed_out(box(Vec3d(0.8, 0.0, 0.1), Vec3d(1.0, 0.1, 0.3), std::numbers::pi / 5.0),
                    Vec3d(0.75, -0.1, 0.1), Vec3d(1.05, 0.2, 0.35));
}

TEST(SolidParticles, PushOutOfACylinder) {
  expect_pushed_out(cylinder(Vec3d(0.9, 0.1, 0.1), 0.08, 0.2), Vec3d(0.8, 0.0, 0.1), Vec3d(1.0, 0.2, 0.35));
}

TEST(SolidParticles, RepelAlongTheNormalByTheDistanceToTheSurface) {
  const Scene scene = scene_with(box(Vec3d(0.8, 0.0, 0.1), Vec3d(1.0, 0.1, 0.3)));
  const SolidParticles solids(scene);
  const Repulsion repulsion = repulsion_of_solids(scene);
  const double r = 0.8 * repulsion.cutoff;
  Vec3d push = Vec3d::Zero();
  solids.add_repulsion(Vec3d(0.8 - r, 0.05, 0.2), push);
  EXPECT_NEAR((push - Vec3d(-repulsion.capped(r), 0.0, 0.0)).norm(), 0.0, 1e-6 * push.norm());
  push.setZero();
  solids.add_repulsion(Vec3d(0.9, 0.05, 0.3 + r), push);
  EXPECT_NEAR((push - Vec3d(0.0, 0.0, repulsion.capped(r))).norm(), 0.0, 1e-6 * push.norm());
  push.setZero();
  solids.add_repulsion(Vec3d(0.8 - 1.001 * repulsion.cutoff, 0.05, 0.2), push);
  EXPECT_EQ(push.norm(), 0.0);
  // From within, still outwards.
  solids.add_repulsion(Vec3d(0.801, 0.05, 0.2), push);
  EXPECT_NEAR((push - Vec3d(-repulsion.cap, 0.0, 0.0)).norm(), 0.0, 1e-6 * push.norm());
}

TEST(SolidParticles, ACylinderRepelsRadially) {
  const Scene scene = scene_with(cylinder(Vec3d(0.9, 0.1, 0.1), 0.08, 0.2));
  const SolidParticles solids(scene);
  const Repulsion repulsion = repulsion_of_solids(scene);
  const double r = 0.7 * repulsion.cutoff;
  for (int k = 0; k < 12; ++k) {
    const double angle = k * std::numbers::pi / 6.0;
    const Vec3d radial(std::cos(angle), std::sin(angle), 0.0);
    Vec3d push = Vec3d::Zero();
    solids.add_repulsion(Vec3d(0.9, 0.1, 0.2) + (0.08 + r) * radial, push);
    EXPECT_NEAR((push - repulsion.capped(r) * radial).norm(), 0.0, 1e-6 * push.norm());
  }
}

TEST(SolidParticles, RepelLessFarThanWalls) {
  // Water at rest lies half a spacing before a solid, disturbed by less than a quarter.
  const Scene scene = scene_with(cylinder(Vec3d(0.9, 0.1, 0.1), 0.08, 0.2));
  EXPECT_DOUBLE_EQ(repulsion_of_solids(scene).cutoff, 0.25 * kSpacing);
  EXPECT_DOUBLE_EQ(Repulsion(scene).cutoff, 0.4 * kSpacing);
}

TEST(SolidParticles, WithoutRepulsionTheyPushNobodyInsideOrOutside) {
  Scene scene = scene_with(box(Vec3d(0.8, 0.0, 0.1), Vec3d(1.0, 0.1, 0.3)));
  scene.boundary.object_repulsion = false;
  const SolidParticles solids(scene);
  for (const Vec3d& point : {Vec3d(0.799, 0.05, 0.2), Vec3d(0.81, 0.05, 0.2)}) {
    Vec3d push = Vec3d::Zero();
    solids.add_repulsion(point, push);
    EXPECT_EQ(push, Vec3d(Vec3d::Zero()));
  }
}

}  // namespace
}  // namespace eisph
