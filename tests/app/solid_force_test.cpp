#include "probe/force.hpp"
#include "scheme/scheme_scenes.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kWeight = kDensity * kGravity;  ///< of water, N/m^3

Scene with_defaults(Scene scene) {
  scene.smoothing_ratio = default_smoothing_ratio(scene.kernel, scene.dimension);
  scene.scheme.free_surface_threshold = default_free_surface_threshold(scene.kernel, scene.dimension);
  return scene;
}

/// What a run did to its first solid.
struct ForceRecord {
  std::vector<double> time;
  std::vector<Vec3d> force;
  std::uint64_t penetrations = 0;

  [[nodiscard]] Vec3d mean(double from) const {
    Vec3d sum = Vec3d::Zero();
    double count = 0.0;
    for (std::size_t k = 0; k < time.size(); ++k) {
      if (time[k] < from) continue;
      sum += force[k];
      count += 1.0;
    }
    return sum / count;
  }
};

ForceRecord record_force(const Scene& scene, double end) {
  constexpr double kInterval = 0.02;
  const auto simulation = start(scene);
  ForceProbe probe;
  probe.obstacle = scene.obstacles[0].name;
  ForceRecord record;
  for (int k = 0; k * kInterval <= end + 1e-9; ++k) {
    run_until(*simulation, k * kInterval);
    const auto snapshot = simulation->snapshot();
    record.time.push_back(k * kInterval);
    record.force.push_back(water_force(probe, FluidField(scene, *snapshot)).force);
  }
  record.penetrations = simulation->summary().penetrations;
  return record;
}

/// Water of 0.4 m at rest against a thick wall; H/dx = 20.
Scene against_a_wall() {
  Scene scene = tank(2, Vec3d(0.6, 0.0, 0.6), 0.02, box(Vec3d::Zero(), Vec3d(0.4, 0.0, 0.4)));
  scene.obstacles.push_back({"wall", box(Vec3d(0.4, 0.0, 0.0), Vec3d(0.5, 0.0, 0.6))});
  return scene;
}

TEST(SolidForce, OnAWallThatHoldsWaterIsHydrostatic) {
  const Scene scene = against_a_wall();
  const ForceRecord record = record_force(scene, 3.0);
  const double exact = 0.5 * kWeight * 0.4 * 0.4;
  EXPECT_NEAR(record.force[0].x(), exact, 0.03 * exact);
  EXPECT_NEAR(record.mean(2.5).x(), exact, 0.03 * exact);
  EXPECT_EQ(record.penetrations, 0U);
}

TEST(SolidForce, OnADamWithWaterAtTwoLevelsDoesNotDependOnItsThickness) {
  const double exact = 0.5 * kWeight * (0.4 * 0.4 - 0.2 * 0.2);
  for (const int layers : {2, 3, 4, 8}) {
    const double back = 0.4 + 0.02 * layers;
    Scene scene = tank(2, Vec3d(1.0, 0.0, 0.6), 0.02, box(Vec3d::Zero(), Vec3d(0.4, 0.0, 0.4)));
    FluidRegion lower = scene.fluid[0];
    lower.shape = box(Vec3d(back, 0.0, 0.0), Vec3d(1.0, 0.0, 0.2));
    scene.fluid.push_back(lower);
    scene.obstacles.push_back({"dam", box(Vec3d(0.4, 0.0, 0.0), Vec3d(back, 0.0, 0.6))});
    const ForceRecord record = record_force(scene, 2.0);
    EXPECT_NEAR(record.force[0].x(), exact, 0.04 * exact) << layers << " layers";
    EXPECT_NEAR(record.mean(1.5).x(), exact, 0.04 * exact) << layers << " layers";
    EXPECT_EQ(record.penetrations, 0U);
  }
}

/// Buoyancy in every record of the first 0.1 s, and at the end.
void expect_buoyancy(const Scene& scene, double end, double exact, double early, double late) {
  const ForceRecord record = record_force(scene, end);
  for (std::size_t k = 0; k < record.time.size() && record.time[k] < 0.101; ++k) {
    EXPECT_NEAR(record.force[k].z(), exact, early * exact) << record.time[k] << " s";
  }
  EXPECT_NEAR(record.mean(end - 0.5).z(), exact, late * exact);
  EXPECT_EQ(record.penetrations, 0U);
}

/// A square of 0.2 m in the middle of water 0.6 m deep.
Scene sunken_square() {
  Scene scene = tank(2, Vec3d(1.0, 0.0, 0.8), 0.02, box(Vec3d::Zero(), Vec3d(1.0, 0.0, 0.6)));
  FluidRegion hole = scene.fluid[0];
  hole.shape = box(Vec3d(0.4, 0.0, 0.2), Vec3d(0.6, 0.0, 0.4));
  hole.cut = true;
  scene.fluid.push_back(hole);
  scene.obstacles.push_back({"box", hole.shape});
  return scene;
}

TEST(SolidForce, OnASunkenBoxIsItsBuoyancy) {
  expect_buoyancy(sunken_square(), 2.0, kWeight * 0.04, 0.15, 0.03);
}

TEST(SolidForce, OnASunkenDiscIsItsBuoyancy) {
  Scene scene = sunken_square();
  Shape disc;
  disc.kind = ShapeKind::Sphere;
  disc.centre = Vec3d(0.5, 0.0, 0.3);
  disc.radius = 0.1;
  scene.fluid[1].shape = disc;
  scene.obstacles[0].shape = disc;
  expect_buoyancy(scene, 2.0, kWeight * std::numbers::pi * 0.01, 0.15, 0.03);
}

class SolidForceOnATurnedBox : public testing::TestWithParam<int> {};

TEST_P(SolidForceOnATurnedBox, IsItsBuoyancy) {
  Scene scene = tank(3, Vec3d(0.8, 0.8, 0.8), 0.04, box(Vec3d::Zero(), Vec3d(0.8, 0.8, 0.6)));
  FluidRegion hole = scene.fluid[0];
  hole.shape = box(Vec3d(0.24, 0.24, 0.2), Vec3d(0.56, 0.56, 0.4), GetParam() * std::numbers::pi / 180.0);
  hole.cut = true;
  scene.fluid.push_back(hole);
  scene.obstacles.push_back({"box", hole.shape});
  expect_buoyancy(with_defaults(scene), 2.0, kWeight * 0.32 * 0.32 * 0.2, 0.15, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Degrees, SolidForceOnATurnedBox, testing::Values(0, 17, 30, 45));

class SolidForceOfSchemes : public testing::TestWithParam<const char*> {};

TEST_P(SolidForceOfSchemes, OnASunkenBoxIsItsBuoyancy) {
  const Scene scene = with_method(sunken_square(), {GetParam(), Stepping::Symplectic});
  // Pressure waves of the start pass through all the first second.
  expect_buoyancy(scene, 1.0, kWeight * 0.04, 0.2, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SolidForceOfSchemes, testing::Values("isph", "wcsph", "delta_sph"));

/// Where a dam break of 1 m of water over a floor stands at 1.8 s, from the dam, m; H/dx = 20.
struct WayOverFloor {
  double front = 0.0;
  double mean = 0.0;  ///< of all its water
};

WayOverFloor way_over_floor(bool objects, double wall_slip, bool object_no_slip) {
  const double bottom = objects ? -0.2 : 0.0;
  Scene scene = tank(2, Vec3d(14.0, 0.0, 2.0), 0.05, box(Vec3d::Zero(), Vec3d(2.0, 0.0, 1.0)));
  scene.domain_min.z() = bottom;
  scene.faces[kZMin].slip_factor = wall_slip;
  scene.boundary.object_no_slip = object_no_slip;
  if (objects) scene.obstacles.push_back({"floor", box(Vec3d(0.0, 0.0, bottom), Vec3d(14.0, 0.0, 0.0))});
  const auto simulation = start(scene);
  run_until(*simulation, 1.8);
  WayOverFloor way;
  const auto snapshot = simulation->snapshot();
  for (const Vec3f& position : snapshot->position) {
    way.front = std::max<double>(way.front, position.x() - 2.0);
    way.mean += (position.x() - 1.0) / static_cast<double>(snapshot->size());
  }
  EXPECT_EQ(simulation->summary().penetrations, 0U);
  return way;
}

TEST(SolidFloor, SlipsLikeAWallThatMirrors) {
  const WayOverFloor wall = way_over_floor(false, 1.0, false);
  const WayOverFloor floor = way_over_floor(true, 1.0, false);
  EXPECT_NEAR(floor.front, wall.front, 0.02 * wall.front);
  EXPECT_NEAR(floor.mean, wall.mean, 0.01 * wall.mean);
}

TEST(SolidFloor, SticksLikeAWallThatMirrors) {
  // Single drops fly ahead over a wall that sticks; the mean does not mind them.
  const double slippery = way_over_floor(false, 1.0, false).mean;
  const double wall = way_over_floor(false, 0.0, false).mean;
  EXPECT_LT(wall, 0.9 * slippery) << "friction shows";
  EXPECT_NEAR(way_over_floor(true, 1.0, true).mean, wall, 0.05 * wall);
}

}  // namespace
}  // namespace eisph
