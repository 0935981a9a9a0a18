#include "scheme/scenes.hpp"
#include "scheme/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

const LatticeConstants kLattice = lattice_constants<2>(KernelKind::QuinticSpline, 1.42);

TEST(TimeStepping, MeetsEveryOutputTimeToTheBit) {
  const auto simulation = start(dam_break_2d());
  for (const double until : {0.001, 0.0137, 0.02, 0.0200001, 1.0 / 30.0, 0.1 / 3.0 + 1e-4, 0.05}) {
    while (simulation->time() != until) {
      const double before = simulation->time();
      simulation->step(until);
      ASSERT_GT(simulation->time(), before);
      ASSERT_LE(simulation->time(), until);
    }
    EXPECT_EQ(simulation->time(), until);
    EXPECT_EQ(simulation->snapshot()->time, until);
  }
}

TEST(TimeStepping, DividesTheTimeLeftIntoEqualSteps) {
  Scene scene = dam_break_2d();
  use_fixed_step(scene, 1e-3);
  const auto simulation = start(scene);
  for (int part = 0; part < 4; ++part) {
    simulation->step(3.5e-3);
    EXPECT_NEAR(simulation->time_step(), 3.5e-3 / 4.0, 1e-15) << "3.5 admissible steps are four";
  }
  EXPECT_EQ(simulation->time(), 3.5e-3);
  simulation->step(4.5e-3);
  EXPECT_EQ(simulation->steps(), 5U) << "one whole step is not cut in two by round-off";
  EXPECT_EQ(simulation->time(), 4.5e-3);
}

TEST(TimeStepping, TheAdaptiveStepFollowsTheFastestParticle) {
  const Scene scene = dam_break_2d();
  const double reference = scene.scheme.phi * 0.01 / std::sqrt(2.0 * kGravity * 0.2);
  EXPECT_DOUBLE_EQ(admissible_time_step(scene, kLattice, 0.0), reference);
  EXPECT_DOUBLE_EQ(admissible_time_step(scene, kLattice, 1.0), reference) << "slower than the speed expected";
  EXPECT_DOUBLE_EQ(admissible_time_step(scene, kLattice, 8.0), scene.scheme.phi * 0.01 / 8.0);
  const auto simulation = start(scene);
  EXPECT_DOUBLE_EQ(simulation->plan().time_step, reference);
  simulation->step(10.0);
  EXPECT_LE(simulation->time_step(), reference);
  EXPECT_GT(simulation->time_step(), 0.99 * reference);
}

TEST(TimeStepping, TheReferenceSpeedCountsByItsWeight) {
  Scene scene = dam_break_2d();
  scene.scheme.reference_speed_weight = 0.5;
  const double expected = std::sqrt(2.0 * kGravity * 0.2);
  const double unit = scene.scheme.phi * 0.01;
  EXPECT_DOUBLE_EQ(admissible_time_step(scene, kLattice, 0.4 * expected), unit / (0.5 * expected));
  EXPECT_DOUBLE_EQ(admissible_time_step(scene, kLattice, 0.6 * expected), unit / (0.6 * expected));
  scene.fluid[0].angular_velocity = 20.0;
  EXPECT_GT(scene.initial_speed(), 0.7 * expected);
  EXPECT_DOUBLE_EQ(admissible_time_step(scene, kLattice, 0.1), unit / scene.initial_speed()) << "in full";
}

/// The largest decay rate of a wave of velocity along the axes and the diagonals of the lattice under either
/// form of the viscous term, by brute force. 1/s for nu = 1 m^2/s.
double fastest_decay(const Scene& scene) {
  const double dx = scene.particle_spacing;
  const double h = scene.smoothing_length();
  double fastest = 0.0;
  for (int n = 1; n <= 16; ++n) {
    const double wave_number = std::numbers::pi / dx * n / 16.0;
    double straight = 0.0;
    double oblique = 0.0;
    double along = 0.0;
    double across = 0.0;
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const double q = std::hypot(i, j) * dx / h;
        if (q == 0.0 || q >= kKernelSupport) continue;
        // 2 nu V (x_ij . grad W) / (r^2 + eta^2) u_ij
        const double slope =
            QuinticSpline::derivative(q) * kernel_normalisation<2>(scene.kernel) / (h * h * h);
        const double r = q * h;
        const double weight = -2.0 * dx * dx * slope * r / (r * r + 1e-4 * h * h);
        // 2 (D + 2) nu V (u_ij . x_ij) / (r^2 + eta^2) grad W, as on the free surface
        const double radial = 4.0 * weight * (1.0 - std::cos(wave_number * i * dx)) / (i * i + j * j);
        along += radial * i * i;
        across += radial * j * j;
        straight += weight * (1.0 - std::cos(wave_number * i * dx));
        oblique += weight * (1.0 - std::cos(wave_number * (i + j) * dx));
      }
    }
    fastest = std::max({fastest, straight, oblique, along, across});
  }
  return fastest;
}

TEST(TimeStepping, ViscosityLimitsTheStep) {
  Scene scene = dam_break_2d();
  scene.artificial_viscosity = 0.0;
  scene.kinematic_viscosity = 1.0;
  // A step of 2 / rate would turn the fastest wave into its negative.
  EXPECT_NEAR(admissible_time_step(scene, kLattice, 0.0) * fastest_decay(scene), kViscousPart * 2.0, 1e-3);
}

TEST(TimeStepping, TheFixedStepIsThatOfTheScene) {
  Scene scene = dam_break_2d();
  use_fixed_step(scene, 2.5e-4);
  EXPECT_EQ(admissible_time_step(scene, kLattice, 100.0), 2.5e-4);
}

TEST(TimeStepping, ArtificialViscosityIsThatOfItsFormula) {
  Scene scene = dam_break_2d();
  scene.artificial_viscosity = 0.05;
  const double sound_speed = 10.0 * std::sqrt(kGravity * 0.2);
  EXPECT_NEAR(artificial_kinematic_viscosity(scene), 0.05 * 0.0142 * sound_speed / 8.0, 1e-12);
  scene.dimension = 3;
  EXPECT_NEAR(artificial_kinematic_viscosity(scene), 0.05 * 0.0142 * sound_speed / 10.0, 1e-12);
}

TEST(TimeStepping, TheVolumeCorrectionFollowsTheStepUnlessGiven) {
  Scene scene = dam_break_2d();
  const double unit = 0.01 / std::sqrt(2.0 * kGravity * 0.2);
  EXPECT_NEAR(volume_correction_factor(scene, 0.17 * unit, 0.0), 0.51, 1e-12);
  EXPECT_EQ(volume_correction_factor(scene, 0.5 * unit, 0.0), 1.0);
  scene.scheme.volume_correction = 0.25;
  EXPECT_EQ(volume_correction_factor(scene, 0.5 * unit, 0.0), 0.25);
  scene.scheme.volume_correction.reset();
  scene.scheme.stepping = Stepping::Thesis;
  EXPECT_EQ(volume_correction_factor(scene, 0.5 * unit, 0.0), 0.1);
}

TEST(TimeStepping, CountsStepsAndReportsTheSummaryOfTheRun) {
  Scene scene = dam_break_2d();
  use_fixed_step(scene, 5e-4);
  const auto simulation = start(scene);
  take_steps(*simulation, 10);
  const RunSummary summary = simulation->summary();
  EXPECT_EQ(summary.steps, 10U);
  EXPECT_EQ(summary.fluid_particles, 300U);
  EXPECT_NEAR(summary.simulated_time, 5e-3, 1e-15);
  EXPECT_NEAR(summary.time_step_mean, 5e-4, 1e-15);
  EXPECT_GT(summary.particle_steps_per_second, 0.0);
  double stages = 0.0;
  for (const auto& [stage, nanoseconds] : summary.stage_ns_per_particle_step) stages += nanoseconds;
  EXPECT_NEAR(stages * summary.particle_steps_per_second * 1e-9, 1.0, 1e-6) << "the stages make up the loop";
  double bytes = 0.0;
  for (const auto& [array, size] : summary.state_bytes_by_array) bytes += size;
  EXPECT_NEAR(bytes / 300.0, summary.state_bytes_per_particle, 1.0);
}

}  // namespace
}  // namespace eisph
