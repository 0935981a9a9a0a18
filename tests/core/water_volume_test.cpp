#include "core/water_volume.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kPi = std::numbers::pi;

FluidRegion box(const Vec3d& min, const Vec3d& max, bool cut = false, double rotation_z = 0.0) {
  FluidRegion region;
  region.shape.min = min;
  region.shape.max = max;
  region.shape.rotation_z = rotation_z;
  region.cut = cut;
  return region;
}

FluidRegion round(ShapeKind kind, const Vec3d& centre, double radius, double height, bool cut) {
  FluidRegion region;
  region.shape.kind = kind;
  region.shape.centre = centre;
  region.shape.radius = radius;
  region.shape.height = height;
  region.cut = cut;
  return region;
}

Scene scene_of(std::vector<FluidRegion> regions, int dimension = 3) {
  Scene scene;
  scene.dimension = dimension;
  scene.domain_max = Vec3d(1.0, 1.0, 1.0);
  scene.fluid = std::move(regions);
  return scene;
}

TEST(WaterVolume, OfAFlatTankIsItsBox) {
  EXPECT_NEAR(water_volume(scene_of({box({0, 0, 0}, {0.8, 1.0, 0.15})})), 0.12, 1e-12);
}

TEST(WaterVolume, CountsWaterOfOverlappingRegionsOnceAndNoneOutsideTheDomain) {
  const Scene scene = scene_of({box({-0.5, 0, 0}, {0.6, 1, 1}), box({0.4, 0, 0}, {1, 1.5, 1})});
  EXPECT_NEAR(water_volume(scene), 1.0, 1e-12);
}

TEST(WaterVolume, IsAnAreaInTwoDimensions) {
  const Scene scene =
      scene_of({box({0.1, 0, 0}, {0.2, 0, 0.2}), box({0.15, 0, 0.1}, {0.3, 0, 0.3}, true)}, 2);
  EXPECT_NEAR(water_volume(scene), 0.02 - 0.005, 1e-13);
  const FluidRegion disc = round(ShapeKind::Sphere, {0.5, 0, 0.5}, 0.2, 0.0, true);
  EXPECT_NEAR(water_volume(scene_of({box({0, 0, 0}, {1, 0, 0.5}), disc}, 2)), 0.5 - 0.02 * kPi, 1e-9);
}

TEST(WaterVolume, LeavesOutRoundShapes) {
  const FluidRegion water = box({0, 0, 0}, {1, 1, 0.5});
  const FluidRegion ball = round(ShapeKind::Sphere, {0.5, 0.5, 0.25}, 0.2, 0.0, true);
  EXPECT_NEAR(water_volume(scene_of({water, ball})), 0.5 - 4.0 / 3.0 * kPi * 0.008, 1e-9);
  const FluidRegion half_ball = round(ShapeKind::Sphere, {0.5, 0.5, 0.5}, 0.2, 0.0, true);
  EXPECT_NEAR(water_volume(scene_of({water, half_ball})), 0.5 - 2.0 / 3.0 * kPi * 0.008, 1e-9);
  const FluidRegion column = round(ShapeKind::Cylinder, {0.5, 0.0, 0.1}, 0.2, 0.2, true);
  EXPECT_NEAR(water_volume(scene_of({water, column})), 0.5 - 0.5 * kPi * 0.04 * 0.2, 1e-9);
}

TEST(WaterVolume, LeavesOutRotatedBoxes) {
  const FluidRegion water = box({0, 0, 0}, {1, 1, 0.5});
  const FluidRegion turned = box({0.3, 0.4, 0.1}, {0.7, 0.6, 0.3}, true, 0.4);
  EXPECT_NEAR(water_volume(scene_of({water, turned})), 0.5 - 0.4 * 0.2 * 0.2, 1e-12);
  // A square with its diagonal along the wall: half of it is in the water.
  const FluidRegion corner = box({0.4, -0.1, 0.0}, {0.6, 0.1, 1.0}, true, 0.25 * kPi);
  EXPECT_NEAR(water_volume(scene_of({water, corner})), 0.5 - 0.02 * 0.5, 1e-12);
}

}  // namespace
}  // namespace eisph
