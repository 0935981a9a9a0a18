#include "core/lattice.hpp"

#include "core/error.hpp"

#include <chrono>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

Shape box(const Vec3d& min, const Vec3d& max) {
  Shape shape;
  shape.min = min;
  shape.max = max;
  return shape;
}

Scene tank(double spacing, int dimension = 3) {
  Scene scene;
  scene.dimension = dimension;
  scene.particle_spacing = spacing;
  scene.domain_max = Vec3d(2.6, 1.2, 0.6);
  return scene;
}

TEST(FluidLattice, CountsTheWaterOfTheDamBreakExactly) {
  Scene scene = tank(0.01);
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(0.8, 1.2, 0.15))});
  EXPECT_EQ(count_fluid_particles(scene), 144000U);
  EXPECT_EQ(fluid_particle_bound(scene), 144000.0);
  EXPECT_EQ(fluid_lattice(scene).position.size(), 144000U);
  scene.particle_spacing = 0.005;
  scene.fluid[0].shape.max.y() = 0.6;
  EXPECT_EQ(count_fluid_particles(scene), 576000U);
  scene.particle_spacing = 1.0 / 60.0;
  scene.fluid[0].shape.max.y() = 1.2;
  EXPECT_EQ(count_fluid_particles(scene), 48U * 72U * 9U);
}

TEST(FluidLattice, StartsHalfASpacingFromTheLowerCornerOfTheDomain) {
  Scene scene = tank(0.1);
  scene.domain_min = Vec3d(-1.0, 0.2, -0.3);
  scene.fluid.push_back(
      {.shape = box(Vec3d(-1.0, 0.2, -0.3), Vec3d(-0.8, 0.4, -0.1)), .velocity = {1.0, 2.0, 3.0}});
  const FluidLattice lattice = fluid_lattice(scene);
  ASSERT_EQ(lattice.position.size(), 8U);
  EXPECT_TRUE(lattice.position.front().isApprox(Vec3d(-0.95, 0.25, -0.25)));
  EXPECT_TRUE(lattice.position.back().isApprox(Vec3d(-0.85, 0.35, -0.15)));
  EXPECT_EQ(lattice.velocity.front(), Vec3d(1.0, 2.0, 3.0));
}

TEST(FluidLattice, LiesInThePlaneYZeroInTwoDimensions) {
  Scene scene = tank(0.01, 2);
  scene.domain_max = Vec3d(1.0, 0.0, 0.5);
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(1.0, 0.0, 0.3))});
  const FluidLattice lattice = fluid_lattice(scene);
  ASSERT_EQ(lattice.position.size(), 3000U);
  for (const Vec3d& position : lattice.position) EXPECT_EQ(position.y(), 0.0);
}

TEST(FluidLattice, LiesHalfALayerFromTheFacesOfARegionOffTheLattice) {
  Scene scene = tank(0.1, 2);
  scene.domain_max = Vec3d(1.03, 0.0, 1.0);
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(1.03, 0.0, 0.52))});
  const FluidLattice lattice = fluid_lattice(scene);
  ASSERT_EQ(lattice.position.size(), 50U);
  EXPECT_TRUE(lattice.position.front().isApprox(Vec3d(0.0515, 0.0, 0.052)));
  EXPECT_TRUE(lattice.position.back().isApprox(Vec3d(1.03 - 0.0515, 0.0, 0.52 - 0.052)));
  EXPECT_NEAR(lattice.particle_volume, 1.03 * 0.52 / 50.0, 1e-14);
  EXPECT_EQ(fluid_particle_bound(scene), 50.0);
  EXPECT_EQ(count_fluid_particles(scene), 50U);
}

TEST(FluidLattice, OfRegionsOnTheLatticeHasTheVolumeOfItsCubes) {
  Scene scene = tank(0.1);
  scene.fluid.push_back({.shape = box(Vec3d(-1.0, -1.0, -1.0), Vec3d(2.0, 0.1, 0.1))});
  const FluidLattice lattice = fluid_lattice(scene);
  ASSERT_EQ(lattice.position.size(), 20U) << "what reaches out of the domain is cut off";
  EXPECT_EQ(lattice.particle_volume, std::pow(0.1, 3));
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(lattice.position[i].x(), 0.05 + static_cast<double>(i) * 0.1) << "to the last bit";
  }
}

TEST(FluidLattice, OfHalfADomainIsThatOfTheWhole) {
  Scene whole = tank(0.02, 2);
  whole.domain_max = Vec3d(1.006, 0.0, 0.6);
  whole.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(1.006, 0.0, 0.3))});
  Scene half = whole;
  half.domain_max.x() = 0.503;
  half.faces[kXMax].kind = FaceKind::Symmetry;  // the region goes on beyond it
  const FluidLattice all = fluid_lattice(whole);
  const FluidLattice left = fluid_lattice(half);
  ASSERT_EQ(2 * left.position.size(), all.position.size());
  EXPECT_NEAR(left.particle_volume, all.particle_volume, 1e-15);
  std::size_t next = 0;
  for (const Vec3d& position : all.position) {
    if (position.x() > 0.503) continue;
    EXPECT_TRUE(position.isApprox(left.position[next++], 1e-12));
  }
  EXPECT_EQ(next, left.position.size());
}

TEST(FluidLattice, KeepsAsManyOfTheCellsThatASolidDividesAsTheirWaterFills) {
  Shape ball;
  ball.kind = ShapeKind::Sphere;
  ball.centre = Vec3d(0.51, 0.52, 0.3);
  ball.radius = 0.2;
  for (const int dimension : {2, 3}) {
    Scene scene = tank(0.02, dimension);
    scene.domain_max = Vec3d(1.0, 1.0, 0.8);
    scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(1.0, 1.0, 0.6))});
    scene.fluid.push_back({.shape = ball, .cut = true});
    scene.obstacles.push_back({"ball", ball});
    const FluidLattice lattice = fluid_lattice(scene);
    const double volume = scene.fluid[0].shape.volume(dimension) - ball.volume(dimension);
    const auto count = static_cast<double>(lattice.position.size());
    EXPECT_NEAR(count * lattice.particle_volume, volume, 1e-8);
    EXPECT_NEAR(lattice.particle_volume / std::pow(0.02, dimension), 1.0, 5e-4);
    for (const Vec3d& at : lattice.position) ASSERT_GT(ball.signed_distance(at, dimension), 0.0);
  }
}

TEST(FluidLattice, JoinsRegionsWithoutDoublingAndTakesCutsOut) {
  Scene scene = tank(0.1);
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(0.4, 0.4, 0.4)), .velocity = {1.0, 0.0, 0.0}});
  scene.fluid.push_back(
      {.shape = box(Vec3d(0.2, 0.0, 0.0), Vec3d(0.6, 0.4, 0.4)), .velocity = {2.0, 0.0, 0.0}});
  EXPECT_EQ(count_fluid_particles(scene), 96U);
  for (const auto lattice = fluid_lattice(scene); const std::size_t k : {std::size_t{0}, std::size_t{3}}) {
    const double expected = lattice.position[k].x() > 0.2 ? 2.0 : 1.0;
    EXPECT_EQ(lattice.velocity[k].x(), expected)
        << "the last region that contains a centre gives the velocity";
  }
  // A cut counts wherever it stands in the list.
  scene.fluid.insert(scene.fluid.begin(),
                     {.shape = box(Vec3d(0.1, 0.1, 0.1), Vec3d(0.3, 0.3, 0.3)), .cut = true});
  EXPECT_EQ(count_fluid_particles(scene), 96U - 8U);
}

TEST(FluidLattice, FillsABallWithAboutItsVolume) {
  Scene scene = tank(0.01);
  Shape ball;
  ball.kind = ShapeKind::Sphere;
  ball.centre = Vec3d(0.3, 0.3, 0.3);
  ball.radius = 0.2;
  scene.fluid.push_back({.shape = ball});
  EXPECT_NEAR(static_cast<double>(count_fluid_particles(scene)) * 1e-6, ball.volume(3),
              0.01 * ball.volume(3));
}

TEST(FluidLattice, JitterStaysWithinItsFractionAndInTheDomainAndRepeatsWithItsSeed) {
  Scene scene = tank(0.1);
  scene.domain_max = Vec3d(0.96, 0.4, 0.4);
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(0.96, 0.4, 0.4))});
  const FluidLattice regular = fluid_lattice(scene);
  scene.jitter = 0.2;
  const FluidLattice first = fluid_lattice(scene);
  const FluidLattice again = fluid_lattice(scene);
  scene.jitter_seed = 2;
  const FluidLattice other = fluid_lattice(scene);
  ASSERT_EQ(first.position.size(), regular.position.size());
  EXPECT_EQ(first.position, again.position);
  EXPECT_NE(first.position, other.position);
  double largest = 0.0;
  for (std::size_t p = 0; p < first.position.size(); ++p) {
    largest = std::max(largest, (first.position[p] - regular.position[p]).cwiseAbs().maxCoeff());
    EXPECT_LT(first.position[p].x(), 0.96);
  }
  EXPECT_LE(largest, 0.02 + 1e-12);
  EXPECT_GT(largest, 0.015);
}

TEST(FluidLattice, VisitsTheSameParticlesInTheSameOrderAsItStoresThem) {
  Scene scene = tank(0.1);
  scene.jitter = 0.1;
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(0.5, 0.5, 0.5))});
  const FluidLattice lattice = fluid_lattice(scene);
  std::size_t visited = 0;
  visit_fluid_lattice(scene, [&](const Vec3d& position, const Vec3d&) {
    EXPECT_EQ(position, lattice.position[visited]);
    return ++visited < 20;
  });
  EXPECT_EQ(visited, 20U) << "stops when told to";
}

TEST(FluidLattice, StopsCountingOneAboveTheLimit) {
  Scene scene = tank(0.01);
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(0.8, 1.2, 0.15))});
  EXPECT_EQ(count_fluid_particles(scene, 1000), 1001U);
  EXPECT_EQ(count_fluid_particles(scene, 144000), 144000U);
}

TEST(FluidLattice, RejectsAnAbsurdLatticeAtOnce) {
  Scene scene = tank(1e-5);
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(1.0, 1.0, 0.1))});
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW((void)count_fluid_particles(scene), InputError);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

}  // namespace
}  // namespace eisph
