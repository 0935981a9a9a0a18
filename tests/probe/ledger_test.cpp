#include "probe/ledger.hpp"

#include "probe/hand_made.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(Ledger, AddsUpMassEnergyAndMomentum) {
  Scene scene = hand_made_scene(3);
  scene.gravity = Vec3d(0.0, 0.0, -10.0);
  Snapshot snapshot = hand_made_snapshot(scene, {{0.5F, 0.25F, 0.6F}, {0.25F, 0.25F, 0.35F}});
  snapshot.particle_mass = 2.0;
  snapshot.velocity = {Vec3f(3.0F, 0.0F, 4.0F), Vec3f(-1.0F, 2.0F, 0.0F)};
  const LedgerEntry entry = take_ledger(snapshot, scene);
  EXPECT_DOUBLE_EQ(entry.mass, 4.0);
  EXPECT_DOUBLE_EQ(entry.kinetic_energy, 30.0);     // 0.5 * 2 * (25 + 5)
  EXPECT_NEAR(entry.potential_energy, 15.0, 1e-5);  // 2 * 10 * (0.5 + 0.25)
  EXPECT_EQ(entry.momentum, Vec3d(4.0, 4.0, 8.0));
}

TEST(Ledger, GivesTheEnergyOfTheColumnInTwoDimensions) {
  const Scene scene = hand_made_scene(2);
  const LedgerEntry entry =
      take_ledger(hand_made_snapshot(scene, lattice(scene, Vec3d(0.4, 0.0, 0.2))), scene);
  EXPECT_NEAR(entry.mass, 1000.0 * 0.4 * 0.2, 1e-9);
  EXPECT_NEAR(entry.potential_energy, 0.5 * 1000.0 * 9.81 * 0.4 * 0.2 * 0.2, 1e-5);
}

TEST(Ledger, TakesGravityAlongItsOwnDirection) {
  Scene scene = hand_made_scene(3);
  scene.gravity = Vec3d(-2.0, 0.0, 0.0);
  Snapshot snapshot = hand_made_snapshot(scene, {{0.5F, 0.25F, 0.6F}});
  snapshot.particle_mass = 3.0;
  EXPECT_NEAR(take_ledger(snapshot, scene).potential_energy, 3.0, 1e-6);
}

TEST(Ledger, RanksCompression) {
  const Scene scene = hand_made_scene(3);
  Snapshot snapshot = hand_made_snapshot(scene, std::vector<Vec3f>(100, Vec3f(0.5F, 0.2F, 0.2F)));
  // 37 k mod 100 runs through 0 to 99 out of order: the compressions are -0.50, -0.49, ... 0.49.
  for (int k = 0; k < 100; ++k) {
    snapshot.number_density[static_cast<std::size_t>(k)] = 0.5F + 0.01F * static_cast<float>(37 * k % 100);
  }
  const LedgerEntry entry = take_ledger(snapshot, scene);
  EXPECT_NEAR(entry.compression_max, 0.49, 1e-6);
  EXPECT_NEAR(entry.compression_p95, 0.44, 1e-6);  // 95 particles from -0.50 to 0.44
}

TEST(Ledger, LeavesNotANumberOutOfTheRanking) {
  const Scene scene = hand_made_scene(3);
  Snapshot snapshot = hand_made_snapshot(scene, std::vector<Vec3f>(3, Vec3f(0.5F, 0.2F, 0.2F)));
  snapshot.number_density = {std::numeric_limits<float>::quiet_NaN(), 1.25F, 0.5F};
  EXPECT_EQ(take_ledger(snapshot, scene).compression_max, 0.25);
}

TEST(Ledger, TakesCompressedParticlesAsSmallerAndThoseOnTheSurfaceAsTheyAre) {
  const Scene scene = hand_made_scene(3);
  Snapshot snapshot = hand_made_snapshot(scene, std::vector<Vec3f>(3, Vec3f(0.5F, 0.2F, 0.2F)));
  snapshot.number_density = {1.25F, 0.5F, 1.0F};
  EXPECT_NEAR(take_ledger(snapshot, scene).volume, 2.8 * 8e-6, 1e-12);
}

TEST(Ledger, PassesOnPenetrationsAndLosses) {
  const Scene scene = hand_made_scene(3);
  Snapshot snapshot = hand_made_snapshot(scene, {});
  snapshot.penetrations = 7;
  snapshot.lost_particles = 2;
  EXPECT_EQ(take_ledger(snapshot, scene).penetrations, 7.0);
  EXPECT_EQ(take_ledger(snapshot, scene).lost_particles, 2.0);
}

TEST(Ledger, IsZeroWithoutFluid) {
  const Scene scene = hand_made_scene(3);
  const LedgerEntry entry = take_ledger(hand_made_snapshot(scene, {}), scene);
  EXPECT_EQ(entry.mass, 0.0);
  EXPECT_EQ(entry.volume, 0.0);
  EXPECT_EQ(entry.potential_energy, 0.0);
  EXPECT_EQ(entry.compression_max, 0.0);
  EXPECT_EQ(entry.compression_p95, 0.0);
}

}  // namespace
}  // namespace eisph
