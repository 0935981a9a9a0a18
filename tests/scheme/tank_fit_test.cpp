#include "core/fluid_fit.hpp"
#include "core/water_volume.hpp"
#include "scheme/scenes.hpp"

#include <algorithm>
#include <cstdio>

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

double particle_volume(const Snapshot& snapshot) { return snapshot.particle_mass / snapshot.reference_density; }

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

/// Nothing is shot out of still water, and nothing moves on.
void expect_still(const Scene& scene, double seconds) {
  const auto simulation = start(scene);
  double top = 0.0;
  double fastest = 0.0;
  for (int k = 1; k <= 20; ++k) {
    run_until(*simulation, 0.05 * seconds * k);
    const auto snapshot = simulation->snapshot();
    fastest = std::max(fastest, largest_speed(*snapshot));
    for (const Vec3f& at : snapshot->position) top = std::max<double>(top, at.z());
  }
  const RunSummary summary = simulation->summary();
  double squares = 0.0;
  const auto snapshot = simulation->snapshot();
  for (const Vec3f& velocity : snapshot->velocity) squares += velocity.squaredNorm();
  std::printf("  L %.3f N %zu compression %.4f fastest %.4f rms at end %.4f top %.4f gain %.2g of %.3g\n",
              scene.domain_max.x(), snapshot->size(), summary.compression_max, fastest,
              std::sqrt(squares / static_cast<double>(snapshot->size())), top, summary.energy_gain_max,
              summary.energy_initial);
  EXPECT_LE(summary.compression_max, 0.02);
  EXPECT_EQ(summary.penetrations, 0U);
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

TEST(TankFit, StillWaterStaysStill) {
  for (const double length : {1.0, 1.003, 1.007, 1.01, 1.013, 1.018}) expect_still(flat_tank(length, 0.3), 2.0);
  expect_still(flat_tank(1.009, 0.307), 2.0);
  Scene under_water = flat_tank(1.009, 0.307);
  add_block(under_water, box(Vec3d(0.403, 0.0, 0.1), Vec3d(0.611, 0.0, 0.207)));
  expect_still(under_water, 2.0);
  Scene on_the_floor = flat_tank(1.013, 0.3);
  add_block(on_the_floor, box(Vec3d(0.403, 0.0, 0.0), Vec3d(0.611, 0.0, 0.207)));
  expect_still(on_the_floor, 2.0);
  Scene aligned = flat_tank(1.0, 0.3);
  add_block(aligned, box(Vec3d(0.4, 0.0, 0.0), Vec3d(0.6, 0.0, 0.2)));
  expect_still(aligned, 2.0);
}

TEST(TankFit, InSpace) {
  for (const double length : {0.4, 0.411, 0.427}) {
    Scene scene = tank(3, Vec3d(length, 0.307, 0.4), 0.02, box(Vec3d::Zero(), Vec3d(length, 0.307, 0.213)));
    expect_fits(scene);
    add_block(scene, box(Vec3d(0.14, 0.1, 0.0), Vec3d(0.14 + 0.3 * length, 0.201, 0.1)));
    expect_fits(scene);
    expect_still(scene, 0.5);
  }
}

}  // namespace
}  // namespace eisph
