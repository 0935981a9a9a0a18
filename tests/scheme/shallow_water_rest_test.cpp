#include "scheme/shallow_water_exact.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

struct Lake {
  const char* name;
  int dimension;
  SlopeLimiter limiter;
  bool ball;      ///< a smooth bump, else a block
  double height;  ///< of the solid, m; the water stands at 0.1 m
};

Scene lake_scene(const Lake& lake) {
  const Vec3d size = lake.dimension == 2 ? Vec3d(0.6, 0.0, 0.3) : Vec3d(0.6, 0.4, 0.3);
  const Vec3d water(0.6, size.y(), 0.1);
  Scene scene = shallow_tank(lake.dimension, size, 0.02, box(Vec3d::Zero(), water));
  scene.shallow_water.limiter = lake.limiter;
  Shape solid = box(Vec3d(0.22, 0.1, 0.0), Vec3d(0.34, 0.3, lake.height));
  if (lake.ball) {
    solid = Shape{};
    solid.kind = ShapeKind::Sphere;
    solid.radius = 0.2;
    solid.centre = Vec3d(0.29, 0.21, lake.height - solid.radius);
  }
  scene.obstacles.push_back({"solid", solid});
  FluidRegion cut;
  cut.cut = true;
  cut.shape = solid;
  scene.fluid.push_back(cut);
  return scene;
}

class LakeAtRest : public testing::TestWithParam<Lake> {};

TEST_P(LakeAtRest, StaysAtRestToRoundOff) {
  const auto simulation = start(lake_scene(GetParam()));
  const auto before = simulation->snapshot();
  take_steps(*simulation, 1000);
  const auto after = simulation->snapshot();
  EXPECT_LT(largest_column_speed(*after), 1e-13);
  double deepest = 0.0;
  double shallowest = 1.0;
  for (std::size_t k = 0; k < before->columns->size(); ++k) {
    EXPECT_NEAR(after->columns->depth[k], before->columns->depth[k], 1e-8) << k;
    deepest = std::max<double>(deepest, before->columns->depth[k]);
    shallowest = std::min<double>(shallowest, before->columns->depth[k]);
  }
  EXPECT_FLOAT_EQ(static_cast<float>(deepest), 0.1F);
  EXPECT_NEAR(shallowest, std::max(0.0, 0.1 - GetParam().height), 2e-3) << "the solid is there";
  EXPECT_NEAR(simulation->summary().mass_error, 0.0, 1e-13);
}

constexpr auto kMinmod = SlopeLimiter::Minmod;
constexpr auto kCentral = SlopeLimiter::MonotonisedCentral;
INSTANTIATE_TEST_SUITE_P(Lakes, LakeAtRest,
                         testing::Values(Lake{"SubmergedBumpMinmod", 3, kMinmod, true, 0.06},
                                         Lake{"SubmergedBumpCentral", 3, kCentral, true, 0.06},
                                         Lake{"IslandMinmod", 3, kMinmod, true, 0.15},
                                         Lake{"IslandCentral", 3, kCentral, true, 0.15},
                                         Lake{"SubmergedBlockMinmod", 3, kMinmod, false, 0.06},
                                         Lake{"SubmergedBlockCentral", 3, kCentral, false, 0.06},
                                         Lake{"EmergedBlockMinmod", 3, kMinmod, false, 0.2},
                                         Lake{"EmergedBlockCentral", 3, kCentral, false, 0.2},
                                         Lake{"SubmergedBumpInThePlane", 2, kCentral, true, 0.06},
                                         Lake{"EmergedBlockInThePlane", 2, kCentral, false, 0.2}),
                         [](const auto& lake) { return lake.param.name; });

TEST(LakeAtRest, WithAnInclinedShoreOfLevelStepsHasNoFlow) {
  // Steps of 1 cm that rise out of the water, which must not creep up or drain them.
  Scene scene = shallow_tank(2, Vec3d(1.0, 0.0, 0.5), 0.02, box(Vec3d::Zero(), Vec3d(1.0, 0.0, 0.1)));
  for (int k = 0; k < 20; ++k) {
    const Shape step = box(Vec3d(0.3 + 0.02 * k, 0.0, 0.0), Vec3d(0.7, 0.0, 0.013 * (k + 1)));
    scene.obstacles.push_back({"step", step});
    FluidRegion cut;
    cut.cut = true;
    cut.shape = step;
    scene.fluid.push_back(cut);
  }
  const auto simulation = start(scene);
  take_steps(*simulation, 1000);
  EXPECT_LT(largest_column_speed(*simulation->snapshot()), 1e-13);
}

}  // namespace
}  // namespace eisph
