#include "scheme/scenes.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// A column behind a gate that opens at the given time.
Scene gated_column(double start_time) {
  Scene scene = tank(2, Vec3d(0.8, 0.0, 0.4), 0.01, box(Vec3d::Zero(), Vec3d(0.3, 0.0, 0.2)));
  Gate gate;
  gate.name = "gate";
  gate.shape = box(Vec3d(0.3, 0.0, 0.0), Vec3d(0.34, 0.0, 0.3));
  gate.start_time = start_time;
  scene.gates.push_back(gate);
  return scene;
}

TEST(InitialPressure, IsHydrostaticInAClosedTank) {
  const auto simulation = start(still_water_2d());
  // Up to the true surface, half a spacing above the uppermost particles.
  EXPECT_LT(hydrostatic_error(*simulation->snapshot(), 0.15), 0.01);
}

TEST(InitialPressure, IsHydrostaticBehindAClosedGate) {
  const auto simulation = start(gated_column(0.5));
  EXPECT_LT(hydrostatic_error(*simulation->snapshot(), 0.2), 0.01);
}

TEST(InitialPressure, FallsAtTheFrontWhenTheGateIsOpen) {
  const auto closed = start(gated_column(0.5))->snapshot();
  const auto open = start(gated_column(0.0))->snapshot();
  ASSERT_EQ(closed->size(), open->size());
  double front_closed = 0.0;
  double front_open = 0.0;
  double back_closed = 0.0;
  double back_open = 0.0;
  for (std::size_t k = 0; k < closed->size(); ++k) {
    const bool bottom = closed->position[k].z() < 0.05F;
    if (bottom && closed->position[k].x() > 0.27F) {
      front_closed += closed->pressure[k];
      front_open += open->pressure[k];
    }
    if (bottom && closed->position[k].x() < 0.05F) {
      back_closed += closed->pressure[k];
      back_open += open->pressure[k];
    }
    EXPECT_GE(open->pressure[k], 0.0F);
  }
  EXPECT_LT(front_open, 0.5 * front_closed) << "zero on the free face, hydrostatic behind a gate";
  EXPECT_LT(back_open, back_closed);
  EXPECT_GT(back_open, 0.6 * back_closed) << "a depth and a half away it is little changed";
}

TEST(InitialPressure, DoesNotDependOnHowThickTheGateIs) {
  const auto front_pressure = [](double thickness) {
    Scene scene = gated_column(0.5);
    scene.gates[0].shape.max.x() = 0.3 + thickness;
    const auto snapshot = start(scene)->snapshot();
    double sum = 0.0;
    for (std::size_t k = 0; k < snapshot->size(); ++k) {
      if (snapshot->position[k].x() > 0.29F) sum += snapshot->pressure[k];
    }
    return sum;
  };
  const double thin = front_pressure(0.02);
  EXPECT_NEAR(front_pressure(0.04), thin, 0.02 * thin);
  EXPECT_NEAR(front_pressure(0.2), thin, 0.02 * thin);
}

TEST(InitialPressure, AsHydrostaticOrZeroIsWhatItSays) {
  Scene scene = still_water_2d();
  scene.scheme.initial_pressure = InitialPressure::Hydrostatic;
  EXPECT_LT(hydrostatic_error(*start(scene)->snapshot(), 0.15), 1e-5);
  scene.scheme.initial_pressure = InitialPressure::Zero;
  const auto without = start(scene)->snapshot();
  for (const float pressure : without->pressure) EXPECT_EQ(pressure, 0.0F);
}

TEST(InitialPressure, BalancesGravityFromTheFirstStep) {
  // With the converged pressure still water starts with accelerations far below gravity, most of them at the
  // surface, one layer in fifteen, that has no pressure of its own; without it, it falls freely.
  Scene scene = still_water_2d();
  use_fixed_step(scene, 1e-4);
  const auto mean_acceleration = [&] {
    const auto simulation = start(scene);
    simulation->step(1.0);
    double sum = 0.0;
    for (const auto snapshot = simulation->snapshot(); const Vec3f& velocity : snapshot->velocity)
      sum += velocity.norm();
    return sum / (450.0 * 1e-4);
  };
  EXPECT_LT(mean_acceleration(), 0.15 * kGravity);
  scene.scheme.initial_pressure = InitialPressure::Zero;
  EXPECT_GT(mean_acceleration(), 0.5 * kGravity);
}

TEST(InitialPressure, OfFallingWaterIsZero) {
  const Scene scene = tank(2, Vec3d(1.0, 0.0, 2.0), 0.02, box(Vec3d(0.4, 0.0, 1.6), Vec3d(0.6, 0.0, 1.8)));
  const auto snapshot = start(scene)->snapshot();
  for (const float pressure : snapshot->pressure) EXPECT_LT(pressure, 1e-2F) << "Pa; rho g H is 1962";
}

}  // namespace
}  // namespace eisph
