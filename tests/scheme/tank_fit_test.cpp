#include "core/fluid_fit.hpp"
#include "core/water_volume.hpp"
#include "scheme/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kSpacing = 0.02;

Scene flat_tank(double length, double depth) {
  return tank(2, Vec3d(length, 0.0, depth + 0.3), kSpacing, box(Vec3d::Zero(), Vec3d(length, 0.0, depth)));
}

void add_block(Scene& scene, const Shape& shape) {
  scene.fluid.push_back({.shape = shape, .cut = true});
  scene.obstacles.push_back({"block", shape});
}

double particle_volume(const Snapshot& snapshot) {
  return snapshot.particle_mass / snapshot.reference_density;
}

double largest_density(const Snapshot& snapshot) {
  return *std::max_element(snapshot.number_density.begin(), snapshot.number_density.end());
}

/// Compression at t = 0 and volume of the water of a scene.
void expect_fits(const Scene& scene) {
  const auto simulation = start(scene);
  const auto snapshot = simulation->snapshot();
  EXPECT_LE(largest_density(*snapshot), 1.01);
  const double volume = water_volume(scene);
  EXPECT_NEAR(particle_volume(*snapshot) * static_cast<double>(snapshot->size()), volume, 1e-6 * volume);
  EXPECT_NEAR(particle_volume(*snapshot) / std::pow(scene.particle_spacing, scene.dimension), 1.0, 0.06);
}

/// Nothing is shot out of still water, and it comes to rest on its level: the root mean square of its speed
/// is `rest` at the end, m/s.
void expect_still(const Scene& scene, double depth, double seconds, double rest = 0.025,
                  double compression = 0.02) {
  const auto simulation = start(scene);
  // Half of the speed at which a particle that falls by its spacing arrives.
  const double slow = 0.5 * std::sqrt(2.0 * kGravity * kSpacing);
  for (int k = 1; k <= 20; ++k) {
    run_until(*simulation, 0.05 * seconds * k);
    const auto snapshot = simulation->snapshot();
    EXPECT_LT(largest_speed(*snapshot), slow);
    for (const Vec3f& at : snapshot->position) ASSERT_LT(at.z(), depth);
  }
  const RunSummary summary = simulation->summary();
  EXPECT_LE(summary.compression_max, compression);
  EXPECT_EQ(summary.penetrations, 0U);
  double squares = 0.0;
  const auto snapshot = simulation->snapshot();
  for (const Vec3f& velocity : snapshot->velocity) squares += velocity.squaredNorm();
  EXPECT_LT(std::sqrt(squares / static_cast<double>(snapshot->size())), rest);
}

TEST(TankFit, EveryLengthStartsUncompressed) {
  for (int k = 0; k <= 20; ++k) {
    SCOPED_TRACE(k);
    expect_fits(flat_tank(1.0 + 0.001 * k, 0.3));
    expect_fits(flat_tank(1.0 + 0.001 * k, 0.29 + 0.0013 * k));
  }
}

TEST(TankFit, EveryLengthWithBlocksStartsUncompressed) {
  for (int k = 0; k <= 20; ++k) {
    SCOPED_TRACE(k);
    const double length = 1.0 + 0.001 * k;
    Scene under_water = flat_tank(length, 0.307);
    add_block(under_water, box(Vec3d(0.4, 0.0, 0.1), Vec3d(0.4 + 0.2 * length, 0.0, 0.1 + 0.1 * length)));
    expect_fits(under_water);
    Scene on_the_floor = flat_tank(length, 0.3);
    add_block(on_the_floor, box(Vec3d(0.4, 0.0, 0.0), Vec3d(0.4 + 0.2 * length, 0.0, 0.1 * length)));
    expect_fits(on_the_floor);
  }
}

class StillTank : public testing::TestWithParam<double> {};

TEST_P(StillTank, StaysStill) {
  expect_still(flat_tank(GetParam(), 0.3), 0.3, 2.0);
  expect_still(flat_tank(GetParam(), 0.307), 0.307, 2.0);
}

INSTANTIATE_TEST_SUITE_P(Lengths, StillTank, testing::Values(1.0, 1.003, 1.01, 1.013, 1.018),
                         [](const auto& instance) {
                           return std::to_string(std::lround(1000.0 * instance.param)) + "_mm";
                         });

/// Largest compression in two seconds of still water about a block on the lattice, which the pressure of
/// object particles makes: what the fit is held against.
double compression_on_the_lattice(const Shape& block) {
  Scene scene = flat_tank(1.0, 0.3);
  add_block(scene, block);
  const auto simulation = start(scene);
  run_until(*simulation, 2.0);
  return simulation->summary().compression_max;
}

TEST(TankFit, StillWaterAboutABlockStaysStill) {
  Scene under_water = flat_tank(1.009, 0.307);
  add_block(under_water, box(Vec3d(0.403, 0.0, 0.1), Vec3d(0.611, 0.0, 0.207)));
  expect_still(under_water, 0.307, 2.0, 0.025,
               compression_on_the_lattice(box(Vec3d(0.4, 0.0, 0.1), Vec3d(0.6, 0.0, 0.2))) + 0.01);
  Scene on_the_floor = flat_tank(1.013, 0.3);
  add_block(on_the_floor, box(Vec3d(0.403, 0.0, 0.0), Vec3d(0.611, 0.0, 0.207)));
  expect_still(on_the_floor, 0.3, 2.0, 0.025,
               compression_on_the_lattice(box(Vec3d(0.4, 0.0, 0.0), Vec3d(0.6, 0.0, 0.2))) + 0.01);
}

TEST(TankFit, InSpace) {
  for (const double length : {0.4, 0.411, 0.427}) {
    SCOPED_TRACE(length);
    Scene scene = tank(3, Vec3d(length, 0.307, 0.4), 0.02, box(Vec3d::Zero(), Vec3d(length, 0.307, 0.213)));
    take_kernel_defaults(scene);
    expect_fits(scene);
    add_block(scene, box(Vec3d(0.14, 0.1, 0.0), Vec3d(0.14 + 0.3 * length, 0.201, 0.1)));
    expect_fits(scene);
    expect_still(scene, 0.213, 0.5, 0.04);
  }
}

TEST(TankFit, TheReportTellsGapsAndCompression) {
  Scene scene = flat_tank(1.011, 0.3);
  const InitialFit fit = Simulation::create(scene, 1)->initial_fit();
  ASSERT_EQ(fit.gaps.size(), 3U);
  EXPECT_EQ(fit.gaps[0].name, "x_min");
  EXPECT_NEAR(fit.gaps[0].spacings, 0.5 * 1.011 / 51.0 / kSpacing, 1e-9);
  EXPECT_EQ(fit.gaps[2].name, "z_min");
  EXPECT_LT(std::abs(fit.compression), 0.01);
  // Water that ends a spacing and a half before a wall does not touch it; a gap of a spacing is seen.
  scene = flat_tank(1.0, 0.3);
  scene.obstacles.push_back({"block", box(Vec3d(1.01, 0.0, 0.0), Vec3d(1.08, 0.0, 0.4))});
  scene.domain_max.x() = 1.1;
  const InitialFit loose = Simulation::create(scene, 1)->initial_fit();
  ASSERT_EQ(loose.gaps.size(), 3U);
  EXPECT_EQ(loose.gaps[2].name, "\"block\"");
  EXPECT_NEAR(loose.gaps[2].spacings, 1.0, 1e-9);
}

TEST(TankFit, AskingForTheFitChangesNothing) {
  Scene scene = flat_tank(1.011, 0.3);
  scene.fluid[0].angular_velocity = 0.5;
  const auto asked = Simulation::create(scene, 1);
  (void)asked->initial_fit();
  asked->initialise();
  const auto plain = start(scene);
  take_steps(*asked, 3);
  take_steps(*plain, 3);
  EXPECT_EQ(asked->snapshot()->position, plain->snapshot()->position);
  EXPECT_EQ(asked->snapshot()->velocity, plain->snapshot()->velocity);
}

}  // namespace
}  // namespace eisph
