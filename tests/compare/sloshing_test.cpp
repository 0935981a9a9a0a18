#include "compare/sloshing.hpp"

#include "compare/hydrostatic.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(HydrostaticPressure, RisesLinearlyBelowTheLevel) {
  EXPECT_DOUBLE_EQ(hydrostatic_pressure(0.3, 0.1), 1962.0);
  EXPECT_EQ(hydrostatic_pressure(0.3, 0.3), 0.0);
  EXPECT_EQ(hydrostatic_pressure(0.3, 0.4), 0.0);
  EXPECT_DOUBLE_EQ(hydrostatic_pressure(2.0, 0.0, 800.0, 10.0), 16000.0);
}

TEST(SloshingWave, HasThePeriodOfTheDispersionRelation) {
  // Computed by hand: k = pi, k H = pi / 2, tanh(pi / 2) = 0.9171523356672744.
  const SloshingWave wave(0.01, 1.0, 0.5);
  EXPECT_NEAR(wave.wave_number(), std::numbers::pi, 1e-15);
  EXPECT_NEAR(wave.angular_frequency(), std::sqrt(9.81 * std::numbers::pi * 0.9171523356672744), 1e-12);
  EXPECT_NEAR(wave.period() * wave.angular_frequency(), 2.0 * std::numbers::pi, 1e-12);
}

TEST(SloshingWave, TendsToShallowAndDeepWater) {
  EXPECT_NEAR(SloshingWave(1e-4, 100.0, 0.1).period(), 200.0 / std::sqrt(9.81 * 0.1), 1e-3);
  const double k = 4.0 * std::numbers::pi;
  EXPECT_NEAR(SloshingWave(1e-4, 1.0, 5.0, 4).angular_frequency(), std::sqrt(9.81 * k), 1e-9);
}

TEST(SloshingWave, StandsWithItsCrestAtTheWall) {
  const SloshingWave wave(0.02, 1.0, 0.5);
  EXPECT_DOUBLE_EQ(wave.surface(0.0, 0.0), 0.52);
  EXPECT_DOUBLE_EQ(wave.surface(1.0, 0.0), 0.48);
  EXPECT_NEAR(wave.surface(0.5, 0.123), 0.5, 1e-12);
  EXPECT_NEAR(wave.surface(0.0, 0.5 * wave.period()), 0.48, 1e-12);
  EXPECT_NEAR(wave.surface(0.3, 0.2), wave.surface(0.3, 0.2 + wave.period()), 1e-12);
  EXPECT_NEAR(SloshingWave(0.02, 1.0, 0.5, 2).surface(0.5, 0.0), 0.48, 1e-12);
}

TEST(SloshingWave, MovesTheSurfaceWithTheWater) {
  const SloshingWave wave(0.02, 1.3, 0.5, 3);
  constexpr double kStep = 1e-5;
  const double rise = (wave.surface(0.4, 0.2 + kStep) - wave.surface(0.4, 0.2 - kStep)) / (2.0 * kStep);
  EXPECT_NEAR(wave.velocity_z(0.4, 0.5, 0.2), rise, 1e-7);
}

TEST(SloshingWave, IsFreeOfDivergenceAndDoesNotCrossWalls) {
  const SloshingWave wave(0.02, 1.3, 0.5, 3);
  constexpr double kStep = 1e-5;
  const double du_dx =
      (wave.velocity_x(0.4 + kStep, 0.3, 0.2) - wave.velocity_x(0.4 - kStep, 0.3, 0.2)) / (2.0 * kStep);
  const double dw_dz =
      (wave.velocity_z(0.4, 0.3 + kStep, 0.2) - wave.velocity_z(0.4, 0.3 - kStep, 0.2)) / (2.0 * kStep);
  EXPECT_GT(std::abs(du_dx), 0.01);
  EXPECT_NEAR(du_dx + dw_dz, 0.0, 1e-7);
  EXPECT_NEAR(wave.velocity_x(0.0, 0.3, 0.2), 0.0, 1e-15);
  EXPECT_NEAR(wave.velocity_x(1.3, 0.3, 0.2), 0.0, 1e-14);
  EXPECT_EQ(wave.velocity_z(0.4, 0.0, 0.2), 0.0);
}

TEST(SloshingWave, HasThePressureThatAcceleratesTheWater) {
  const SloshingWave wave(0.02, 1.3, 0.5, 1);
  constexpr double kStep = 1e-5;
  const double dp_dx =
      (wave.pressure(0.4 + kStep, 0.3, 0.2) - wave.pressure(0.4 - kStep, 0.3, 0.2)) / (2.0 * kStep);
  const double du_dt =
      (wave.velocity_x(0.4, 0.3, 0.2 + kStep) - wave.velocity_x(0.4, 0.3, 0.2 - kStep)) / (2.0 * kStep);
  EXPECT_NEAR(du_dt, -dp_dx / 1000.0, 1e-6);
  EXPECT_NEAR(wave.pressure(0.65, 0.2, 0.0), hydrostatic_pressure(0.5, 0.2), 1e-9);
  EXPECT_EQ(wave.pressure(0.65, 0.9, 0.0), 0.0);
}

TEST(SloshingWave, RefusesATankWithoutLength) {
  EXPECT_THROW(SloshingWave(0.01, 0.0, 0.5), std::invalid_argument);
  EXPECT_THROW(SloshingWave(0.01, 1.0, 0.5, 0), std::invalid_argument);
}

}  // namespace
}  // namespace eisph
