#include "scheme/scenes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Two blocks that meet with a shear between them, in empty space: no walls near, no gravity, viscosity.
Scene colliding_blocks(int dimension, Stepping stepping) {
  const double depth = dimension == 2 ? 0.0 : 0.2;
  Scene scene = tank(dimension, Vec3d(1.0, dimension == 2 ? 0.0 : 1.0, 1.0), 0.02,
                     box(Vec3d(0.3, 0.4, 0.3), Vec3d(0.5, 0.4 + depth, 0.6)));
  scene.fluid[0].velocity = Vec3d(0.6, dimension == 2 ? 0.0 : 0.1, 0.2);
  FluidRegion other;
  other.shape = box(Vec3d(0.5, 0.4, 0.3), Vec3d(0.7, 0.4 + depth, 0.5));
  other.velocity = Vec3d(-0.5, 0.0, -0.1);
  scene.fluid.push_back(other);
  scene.gravity.setZero();
  scene.kinematic_viscosity = 2e-3;
  if (stepping == Stepping::Thesis) use_thesis_stepping(scene);
  use_fixed_step(scene, 1e-3);
  return scene;
}

struct Momenta {
  Vec3d linear = Vec3d::Zero();
  Vec3d angular = Vec3d::Zero();
  double speeds = 0.0;    ///< sum of |u|
  double energies = 0.0;  ///< sum of u^2 / 2
};

Momenta momenta(const Snapshot& snapshot) {
  Momenta sum;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const Vec3d velocity = snapshot.velocity[k].cast<double>();
    sum.linear += velocity;
    sum.angular += snapshot.position[k].cast<double>().cross(velocity);
    sum.speeds += velocity.norm();
    sum.energies += 0.5 * velocity.squaredNorm();
  }
  return sum;
}

struct MomentumCase {
  int dimension;
  Stepping stepping;
};

class Momentum : public testing::TestWithParam<MomentumCase> {};

TEST_P(Momentum, OfWaterWithoutWallsAndGravityIsKept) {
  const auto simulation = start(colliding_blocks(GetParam().dimension, GetParam().stepping));
  const Momenta before = momenta(*simulation->snapshot());
  take_steps(*simulation, 100);
  const auto snapshot = simulation->snapshot();
  const Momenta after = momenta(*snapshot);
  ASSERT_TRUE(is_finite(*snapshot));
  ASSERT_EQ(simulation->summary().penetrations, 0U);
  EXPECT_LT(after.energies, 0.9 * before.energies) << "forces have acted";
  // Pressure and viscous forces are pairwise opposite; each velocity is rounded to 6e-8 of itself and sums of
  // eight terms to about 3e-7 of the largest, at every one of 100 steps.
  EXPECT_LT((after.linear - before.linear).norm(), 1e-5 * before.speeds);
}

TEST_P(Momentum, OfInertWaterKeepsItsAngularPartToo) {
  if (GetParam().stepping != Stepping::Symplectic) return;
  // Pressure is central, and acts at the positions that move with the new velocity. The viscosity of the
  // fluid is not.
  Scene scene = colliding_blocks(GetParam().dimension, GetParam().stepping);
  scene.kinematic_viscosity = 0.0;
  // Taking pairs apart keeps the centre of mass and the momentum, not the moment of momentum.
  scene.scheme.pair_separation = 0.0;
  const auto simulation = start(scene);
  const Momenta before = momenta(*simulation->snapshot());
  take_steps(*simulation, 100);
  const Momenta after = momenta(*simulation->snapshot());
  EXPECT_LT(after.energies, 0.95 * before.energies) << "forces have acted";
  EXPECT_LT((after.angular - before.angular).norm(), 1e-5 * before.speeds);
  EXPECT_LT((after.linear - before.linear).norm(), 1e-5 * before.speeds);
}

INSTANTIATE_TEST_SUITE_P(Steppings, Momentum,
                         testing::Values(MomentumCase{2, Stepping::Symplectic},
                                         MomentumCase{2, Stepping::Thesis},
                                         MomentumCase{3, Stepping::Symplectic}));

TEST(Energy, OfADamBreakDoesNotGrow) {
  const auto simulation = start(dam_break_2d());
  run_until(*simulation, 0.4);
  const RunSummary summary = simulation->summary();
  EXPECT_LT(summary.energy_final, summary.energy_initial);
  // The worst that the method's own figures allow is 1.3 % of the energy at this step.
  EXPECT_LT(summary.energy_gain_max, 0.013 * summary.energy_initial);
}

}  // namespace
}  // namespace eisph
