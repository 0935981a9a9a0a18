#include "boundary/virtual_particles.hpp"

#include "boundary/tank_scene.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kSpacing = 0.02;
constexpr double kCutoff = 0.4 * kSpacing;
const double kStrength = 2.0 * 9.81 * 0.3;       // 2 g H
const double kCap = 5.0 * kStrength / kSpacing;  // the default of 5 in units of 2 g H / dx

/// c^2 [(r0/r)^4 - (r0/r)^2] / r
double law(double r) {
  const double ratio = kCutoff / r;
  return r < kCutoff ? kStrength * (std::pow(ratio, 4) - std::pow(ratio, 2)) / r : 0.0;
}

template <int Dim>
std::array<double, Dim> acceleration(const Scene& scene, const std::array<double, Dim>& at) {
  std::array<double, Dim> sum{};
  VirtualParticles<Dim>(scene).add_acceleration(at, sum);
  return sum;
}

TEST(Repulsion, FollowsTheLawUpToTheCutoffAndTheCap) {
  const Repulsion repulsion(tank_scene(3));
  EXPECT_EQ(repulsion.raw(kCutoff), 0.0);
  EXPECT_EQ(repulsion.raw(2.0 * kCutoff), 0.0);
  for (const double part : {0.3, 0.5, 0.7, 0.9, 0.99}) {
    EXPECT_NEAR(repulsion.raw(part * kCutoff), law(part * kCutoff), 1e-12 * law(part * kCutoff));
    EXPECT_LE(repulsion.capped(part * kCutoff), kCap * (1.0 + 1e-15));
  }
  EXPECT_DOUBLE_EQ(repulsion.capped(0.1 * kCutoff), kCap);
  EXPECT_DOUBLE_EQ(repulsion.capped(0.0), kCap);
  EXPECT_DOUBLE_EQ(repulsion.capped(-0.5 * kCutoff), kCap) << "what lies behind the surface is pushed out";
}

TEST(VirtualParticles, TheEvenFormActsByTheDistanceAlongTheNormal) {
  const Scene tank = tank_scene(3);
  const double r = 0.8 * kCutoff;
  const auto low = acceleration<3>(tank, {r, 0.3, 0.25});
  EXPECT_NEAR(low[0], law(r), 1e-9 * law(r));
  EXPECT_EQ(low[1], 0.0);
  EXPECT_EQ(low[2], 0.0);
  const auto high = acceleration<3>(tank, {0.5, 0.6 - r, 0.25});
  EXPECT_NEAR(high[1], -law(r), 1e-9 * law(r));
  const auto roof = acceleration<3>(tank, {0.5, 0.3, 0.5 - r});
  EXPECT_NEAR(roof[2], -law(r), 1e-9 * law(r));
  const auto floor = acceleration<2>(tank_scene(2), {0.5, r});
  EXPECT_NEAR(floor[1], law(r), 1e-9 * law(r));
}

TEST(VirtualParticles, TheEvenFormIsTheSameAllAlongAWall) {
  const Scene tank = tank_scene(3);
  const auto reference = acceleration<3>(tank, {0.5, 0.3, 0.006});
  for (int k = 0; k < 20; ++k) {
    const auto here = acceleration<3>(tank, {0.4 + 0.0013 * k, 0.3 + 0.0007 * k, 0.006});
    EXPECT_EQ(here[2], reference[2]);
    EXPECT_EQ(here[0], 0.0);
  }
}

TEST(VirtualParticles, NothingActsBeyondTheCutoff) {
  for (const RepulsionForm form : {RepulsionForm::Even, RepulsionForm::Lattice}) {
    Scene tank = tank_scene(3);
    tank.boundary.repulsion_form = form;
    const auto none = acceleration<3>(tank, {kCutoff * 1.0001, 0.3, 0.25});
    EXPECT_EQ(none[0], 0.0);
    EXPECT_EQ(none[1], 0.0);
    EXPECT_EQ(none[2], 0.0);
  }
}

TEST(VirtualParticles, TheSumOverAllWallsIsCapped) {
  for (const RepulsionForm form : {RepulsionForm::Even, RepulsionForm::Lattice}) {
    Scene tank = tank_scene(3);
    tank.boundary.repulsion_form = form;
    for (const double r : {1e-9, 1e-5, 1e-4, 1e-3}) {
      const auto corner = acceleration<3>(tank, {r, r, r});
      EXPECT_NEAR(std::hypot(corner[0], corner[1], corner[2]), kCap, 1e-9 * kCap) << r;
      for (const double component : corner) EXPECT_GT(component, 0.0) << "inwards";
    }
  }
}

TEST(VirtualParticles, SymmetryPlanesAndOpenFacesHaveNone) {
  Scene tank = tank_scene(3);
  tank.faces[kXMin].kind = FaceKind::Symmetry;
  tank.faces[kYMin].kind = FaceKind::Open;
  const auto push = acceleration<3>(tank, {0.001, 0.001, 0.25});
  EXPECT_EQ(push[0], 0.0);
  EXPECT_EQ(push[1], 0.0);
  tank.boundary.virtual_particles = false;
  EXPECT_TRUE(VirtualParticles<3>(tank).empty());
  EXPECT_FALSE(VirtualParticles<3>(tank_scene(3)).empty());
}

/// Sum over a stored lattice on the floor z = 0, nodes at k dx/2 from the corner and beyond the edges.
std::array<double, 3> stored_floor(const std::array<double, 3>& at) {
  std::array<double, 3> sum{};
  for (int i = -4; i <= 104; ++i) {
    for (int j = -4; j <= 64; ++j) {
      const std::array<double, 3> offset = {at[0] - 0.5 * kSpacing * i, at[1] - 0.5 * kSpacing * j, at[2]};
      const double r = std::hypot(offset[0], offset[1], offset[2]);
      for (std::size_t d = 0; d < 3; ++d) sum[d] += law(r) * offset[d] / r;
    }
  }
  const double size = std::hypot(sum[0], sum[1], sum[2]);
  for (double& component : sum) component *= size > kCap ? kCap / size : 1.0;
  return sum;
}

TEST(VirtualParticles, TheLatticeFormEqualsAStoredLattice) {
  Scene tank = tank_scene(3);
  tank.boundary.repulsion_form = RepulsionForm::Lattice;
  for (Face& face : tank.faces) face.kind = FaceKind::Open;
  tank.faces[kZMin].kind = FaceKind::Wall;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int acting = 0;
  for (int trial = 0; trial < 500; ++trial) {
    // Every tenth close to an edge of the floor.
    const double x = trial % 10 == 0 ? 0.01 * unit(generator) : unit(generator);
    const std::array<double, 3> at = {x, 0.6 * unit(generator), kCutoff * unit(generator)};
    const auto expected = stored_floor(at);
    const auto found = acceleration<3>(tank, at);
    for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(found[d], expected[d], 1e-9 * kCap) << "trial " << trial;
    acting += expected[2] > 0.0 ? 1 : 0;
  }
  EXPECT_GT(acting, 200);
}

TEST(VirtualParticles, CountsTheNodesOfTheLatticeAndStoresNoneForTheEvenForm) {
  Scene tank = tank_scene(3);
  EXPECT_EQ(VirtualParticles<3>(tank).count(), 0U);
  tank.boundary.repulsion_form = RepulsionForm::Lattice;
  for (Face& face : tank.faces) face.kind = FaceKind::Open;
  tank.faces[kZMin].kind = FaceKind::Wall;
  EXPECT_EQ(VirtualParticles<3>(tank).count(), 101U * 61U);
}

TEST(VirtualParticles, AHalfDomainSeesTheLatticeOfTheFullOne) {
  Scene full = tank_scene(3);
  full.boundary.repulsion_form = RepulsionForm::Lattice;
  Scene lower_half = full;
  lower_half.domain_max.y() = lower_half.domain_min.y() + 0.3;
  lower_half.faces[kYMax].kind = FaceKind::Symmetry;
  Scene upper_half = full;
  upper_half.domain_min.y() += 0.3;
  upper_half.faces[kYMin].kind = FaceKind::Symmetry;
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    const double x = unit(generator);
    // Half of them next to the symmetry plane.
    const double y = (trial % 2 == 0 ? 0.01 : 0.3) * unit(generator);
    const double z = kCutoff * unit(generator);
    const auto right = acceleration<3>(full, {x, 0.3 + y, z});
    const auto upper = acceleration<3>(upper_half, {x, y, z});
    const auto left = acceleration<3>(full, {x, 0.3 - y, z});
    const auto lower = acceleration<3>(lower_half, {x, 0.3 - y, z});
    for (std::size_t d = 0; d < 3; ++d) {
      // The same nodes up to round-off of their places, which the steep law magnifies.
      ASSERT_NEAR(upper[d], right[d], 1e-8 * kCap);
      ASSERT_NEAR(lower[d], left[d], 1e-8 * kCap);
      ASSERT_NEAR(lower[d], (d == 1 ? -1.0 : 1.0) * upper[d], 1e-8 * kCap) << "mirror images of each other";
    }
  }
}

}  // namespace
}  // namespace eisph
