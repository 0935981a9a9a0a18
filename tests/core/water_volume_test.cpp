#include "app/fluid_volume.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

FluidRegion box(const Vec3d& min, const Vec3d& max, bool cut = false) {
  FluidRegion region;
  region.shape.min = min;
  region.shape.max = max;
  region.cut = cut;
  return region;
}

Scene scene_of(std::vector<FluidRegion> regions, int dimension = 3) {
  Scene scene;
  scene.dimension = dimension;
  scene.fluid = std::move(regions);
  return scene;
}

TEST(FluidVolume, OfAFlatTankIsItsBox) {
  const double volume = 0.8 * 1.2 * 0.15;
  EXPECT_NEAR(fluid_volume(scene_of({box({0, 0, 0}, {0.8, 1.2, 0.15})})), volume, 2e-3 * volume);
}

TEST(FluidVolume, CountsWaterOfOverlappingRegionsOnce) {
  const Scene scene = scene_of({box({0, 0, 0}, {0.6, 1, 1}), box({0.4, 0, 0}, {1, 1, 1})});
  EXPECT_NEAR(fluid_volume(scene), 1.0, 1e-3);
}

TEST(FluidVolume, LeavesOutWhatIsCut) {
  FluidRegion ball;
  ball.cut = true;
  ball.shape.kind = ShapeKind::Sphere;
  ball.shape.centre = {0.5, 0.5, 0.5};
  ball.shape.radius = 0.3;
  const double cut = 4.0 / 3.0 * std::numbers::pi * 0.027;
  EXPECT_NEAR(fluid_volume(scene_of({box({0, 0, 0}, {1, 1, 1}), ball})), 1.0 - cut, 1e-3);
}

TEST(FluidVolume, IsAnAreaInTwoDimensions) {
  const Scene scene =
      scene_of({box({0.1, 0, 0}, {0.2, 0, 0.2}), box({0.15, 0, 0.1}, {0.3, 0, 0.3}, true)}, 2);
  EXPECT_NEAR(fluid_volume(scene), 0.02 - 0.005, 1.5e-5);
}

}  // namespace
}  // namespace eisph
