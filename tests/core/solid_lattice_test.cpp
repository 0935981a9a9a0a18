#include "core/lattice.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kEverything = 1e9;
constexpr double kPi = std::numbers::pi;

Shape box(const Vec3d& min, const Vec3d& max, double rotation_z = 0.0) {
  Shape shape;
  shape.min = min;
  shape.max = max;
  shape.rotation_z = rotation_z;
  return shape;
}

Shape cylinder(const Vec3d& base, double radius, double height) {
  Shape shape;
  shape.kind = ShapeKind::Cylinder;
  shape.centre = base;
  shape.radius = radius;
  shape.height = height;
  return shape;
}

Shape ball(const Vec3d& centre, double radius) {
  Shape shape;
  shape.kind = ShapeKind::Sphere;
  shape.centre = centre;
  shape.radius = radius;
  return shape;
}

double total(const SolidLattice& lattice) {
  return std::accumulate(lattice.volume.begin(), lattice.volume.end(), 0.0);
}

double least_distance(const SolidLattice& lattice) {
  double least = kEverything;
  for (std::size_t p = 0; p < lattice.position.size(); ++p) {
    for (std::size_t q = 0; q < p; ++q)
      least = std::min(least, (lattice.position[p] - lattice.position[q]).norm());
  }
  return least;
}

TEST(SolidLattice, FillsABoxWithLayersHalfASpacingFromItsFaces) {
  const SolidLattice lattice =
      solid_lattice(box(Vec3d(1.0, 1.0, 0.0), Vec3d(1.3, 1.2, 0.1)), 0.1, kEverything, 3);
  ASSERT_EQ(lattice.position.size(), 3U * 2U * 2U) << "at least two layers along every axis";
  EXPECT_TRUE(lattice.position.front().isApprox(Vec3d(1.05, 1.05, 0.025)));
  EXPECT_TRUE(lattice.position.back().isApprox(Vec3d(1.25, 1.15, 0.075)));
  EXPECT_NEAR(total(lattice), 0.3 * 0.2 * 0.1, 1e-15);
  EXPECT_NEAR(lattice.spacing, 0.1, 1e-12);
}

TEST(SolidLattice, GivesADamThinnerThanTwoSpacingsTwoLayers) {
  const SolidLattice lattice =
      solid_lattice(box(Vec3d(0.8, 0.0, 0.0), Vec3d(0.825, 0.45, 0.2)), 0.02, 0.05, 3);
  EXPECT_EQ(lattice.position.size(), 2U * 23U * 10U);
  EXPECT_NEAR(total(lattice), 0.025 * 0.45 * 0.2, 1e-12);
}

TEST(SolidLattice, TurnsABoxAboutItsCentre) {
  const double angle = kPi / 6.0;
  const Shape shape = box(Vec3d(1.0, 2.0, 0.0), Vec3d(1.4, 2.2, 0.2), angle);
  const SolidLattice lattice = solid_lattice(shape, 0.1, kEverything, 3);
  ASSERT_EQ(lattice.position.size(), 16U);
  const Vec3d corner = Vec3d(1.2, 2.1, 0.05) + Vec3d(std::cos(angle) * -0.15 + std::sin(angle) * 0.05,
                                                     std::sin(angle) * -0.15 - std::cos(angle) * 0.05, 0.0);
  EXPECT_TRUE(lattice.position.front().isApprox(corner));
  for (const Vec3d& point : lattice.position) EXPECT_NEAR(shape.signed_distance(point, 3), -0.05, 1e-12);
}

TEST(SolidLattice, LeavesOutWhatLiesDeeperThanAsked) {
  // A cube of ten layers each way, of which the outer three are kept: 10^3 - 4^3.
  const SolidLattice lattice = solid_lattice(box(Vec3d::Zero(), Vec3d(1.0, 1.0, 1.0)), 0.1, 0.25, 3);
  EXPECT_EQ(lattice.position.size(), 1000U - 64U);
  EXPECT_NEAR(total(lattice), 0.936, 1e-12);
}

TEST(SolidLattice, FillsARectangleInTwoDimensions) {
  const SolidLattice lattice = solid_lattice(box(Vec3d(0.0, 0.0, 0.0), Vec3d(1.0, 0.0, 1.0)), 0.1, 0.15, 2);
  EXPECT_EQ(lattice.position.size(), 100U - 36U);
  for (const Vec3d& point : lattice.position) EXPECT_EQ(point.y(), 0.0);
  EXPECT_NEAR(total(lattice), 0.64, 1e-12) << "an area";
}

TEST(SolidLattice, FillsACylinderWithRingsThatAddUpToItsVolume) {
  const Shape shape = cylinder(Vec3d(0.5, 0.5, 0.1), 0.1, 0.3);
  const SolidLattice whole = solid_lattice(shape, 0.02, kEverything, 3);
  EXPECT_NEAR(total(whole), kPi * 0.01 * 0.3, 1e-12);
  // Rings at 0.09, 0.07, ... m: 28, 22, 16, 9 and 3 particles on 15 levels.
  EXPECT_EQ(whole.position.size(), 15U * (28U + 22U + 16U + 9U + 3U));
  double outermost = -kEverything;
  for (const Vec3d& point : whole.position) outermost = std::max(outermost, shape.signed_distance(point, 3));
  EXPECT_NEAR(outermost, -0.01, 1e-12) << "the first layer is half a spacing deep";
  EXPECT_GT(least_distance(whole), 0.8 * 0.02);
  // Two layers are a mantle 0.04 m thick: the inner cylinder of 0.06 m radius and 0.22 m height is missing.
  const SolidLattice mantle = solid_lattice(shape, 0.02, 0.035, 3);
  EXPECT_NEAR(total(mantle), kPi * (0.01 * 0.3 - 0.0036 * 0.22), 1e-12);
}

TEST(SolidLattice, FillsABallWithShellsThatAddUpToItsVolume) {
  const Shape shape = ball(Vec3d(0.5, 0.5, 0.5), 0.1);
  const SolidLattice whole = solid_lattice(shape, 0.02, kEverything, 3);
  EXPECT_NEAR(total(whole), shape.volume(3), 1e-12);
  EXPECT_NEAR(static_cast<double>(whole.position.size()) * 8e-6, shape.volume(3), 0.05 * shape.volume(3));
  EXPECT_GT(least_distance(whole), 0.5 * 0.02) << "a spiral has no close pairs";
  const SolidLattice shell = solid_lattice(shape, 0.02, 0.035, 3);
  EXPECT_NEAR(total(shell), shape.volume(3) * (1.0 - std::pow(0.6, 3)), 1e-12);
  for (const Vec3d& point : shell.position) {
    const double depth = -shape.signed_distance(point, 3);
    EXPECT_LT(std::min(std::abs(depth - 0.01), std::abs(depth - 0.03)), 1e-12);
  }
}

TEST(SolidLattice, FillsADiscInTwoDimensions) {
  const SolidLattice disc = solid_lattice(ball(Vec3d(0.5, 0.0, 0.5), 0.1), 0.02, kEverything, 2);
  EXPECT_NEAR(total(disc), kPi * 0.01, 1e-12) << "an area";
  EXPECT_EQ(disc.position.size(), 28U + 22U + 16U + 9U + 3U);
  for (const Vec3d& point : disc.position) EXPECT_EQ(point.y(), 0.0);
}

TEST(SolidLattice, SpacingIsTheLargestDistanceOfNeighbours) {
  const SolidLattice lattice = solid_lattice(box(Vec3d::Zero(), Vec3d(0.25, 0.2, 0.2)), 0.1, kEverything, 3);
  EXPECT_NEAR(lattice.spacing, 0.1, 1e-12);
  EXPECT_LE(solid_lattice(cylinder(Vec3d::Zero(), 0.1, 0.3), 0.02, kEverything, 3).spacing, 0.021);
}

TEST(SolidLattice, EstimateIsNearTheCount) {
  const auto compare = [](const Shape& shape, double depth, int dimension) {
    const auto count = static_cast<double>(solid_lattice(shape, 0.01, depth, dimension).position.size());
    EXPECT_NEAR(solid_particle_estimate(shape, 0.01, depth, dimension), count, 0.3 * count);
  };
  compare(box(Vec3d::Zero(), Vec3d(0.3, 0.2, 0.25)), 0.04, 3);
  compare(box(Vec3d::Zero(), Vec3d(0.3, 0.002, 0.25)), 0.04, 3);
  compare(cylinder(Vec3d::Zero(), 0.1, 0.3), 0.04, 3);
  compare(ball(Vec3d::Zero(), 0.15), 0.04, 3);
  compare(ball(Vec3d::Zero(), 0.15), 0.04, 2);
}

TEST(SceneSolids, KeepsTheOrderOfTheSceneAndDropsWhatAnEarlierSolidHolds) {
  Scene scene;
  scene.particle_spacing = 0.1;
  scene.domain_max = Vec3d(2.0, 2.0, 1.0);
  scene.obstacles.push_back({"first", box(Vec3d::Zero(), Vec3d(0.4, 0.4, 0.4))});
  scene.obstacles.push_back({"touching", box(Vec3d(0.4, 0.0, 0.0), Vec3d(0.8, 0.4, 0.4))});
  scene.gates.push_back({.name = "gate", .shape = box(Vec3d(0.2, 0.0, 0.0), Vec3d(0.6, 0.4, 0.8))});
  const SceneSolids solids = scene_solids(scene);
  ASSERT_EQ(solids.ranges.size(), 3U);
  EXPECT_EQ(solids.ranges[0].name, "first");
  EXPECT_EQ(solids.ranges[0].count, 64U);
  EXPECT_EQ(solids.ranges[1].count, 64U);
  EXPECT_EQ(solids.ranges[2].name, "gate");
  EXPECT_EQ(solids.ranges[2].first, 128U);
  EXPECT_EQ(solids.ranges[2].count, 64U) << "its lower half is inside the obstacles";
  EXPECT_EQ(solids.position.size(), 192U);
  EXPECT_EQ(solids.volume.size(), 192U);
}

TEST(SceneSolids, DropsWhatLiesOutsideTheDomain) {
  Scene scene;
  scene.particle_spacing = 0.1;
  scene.domain_max = Vec3d(1.0, 1.0, 1.0);
  scene.obstacles.push_back({"pillar", box(Vec3d(0.8, 0.0, 0.0), Vec3d(1.2, 0.4, 0.4))});
  const SceneSolids solids = scene_solids(scene);
  EXPECT_EQ(solids.position.size(), 32U);
  for (const Vec3d& point : solids.position) EXPECT_LT(point.x(), 1.0);
}

}  // namespace
}  // namespace eisph
