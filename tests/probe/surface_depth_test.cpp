#include "probe/surface_depth.hpp"

#include "probe/depth_grid.hpp"
#include "probe/hand_made.hpp"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>

namespace eisph {
namespace {

class SurfaceDepthTest : public testing::TestWithParam<int> {
 protected:
  SurfaceDepthTest() {
    scene_.output.depth_rule = DepthRule::Surface;
    scene_.output.depth_cell_size = 0.025;
  }

  [[nodiscard]] DepthGrid grid_of(const Snapshot& water) const {
    return DepthGridBuilder(scene_).build(water);
  }
  /// Middle of column i, m.
  [[nodiscard]] static double x_of(std::size_t i) { return (static_cast<double>(i) + 0.5) * 0.025; }

  Scene scene_ = hand_made_scene(GetParam());
};

TEST_P(SurfaceDepthTest, IsTheLevelOfStillWaterUpToWallsAndCorners) {
  const DepthGrid grid = grid_of(still_water(scene_, Vec3d(1.0, 0.5, 0.2)));
  EXPECT_THAT(grid.depth, testing::Each(testing::FloatNear(0.2F, 1e-6F)));
}

TEST_P(SurfaceDepthTest, OfDisorderedWaterIsGoodToFivePercent) {
  Snapshot water = still_water(scene_, Vec3d(1.0, 0.5, 0.2));
  shake(water, 0.1 * scene_.particle_spacing);
  EXPECT_THAT(grid_of(water).depth, testing::Each(testing::FloatNear(0.2F, 0.01F)));
}

TEST_P(SurfaceDepthTest, EndsWithTheWater) {
  const DepthGrid grid = grid_of(still_water(scene_, Vec3d(0.5, 0.5, 0.2)));
  for (std::size_t i = 0; i < grid.columns; ++i) {
    const double expected = x_of(i) < 0.5 ? 0.2 : 0.0;
    if (std::abs(x_of(i) - 0.5) > 0.04) {
      EXPECT_NEAR(grid.at(i, 0), expected, 1e-6) << x_of(i);
    }
  }
}

TEST_P(SurfaceDepthTest, HasNoHolesInALayerThatHasThinnedOut) {
  std::vector<Vec3f> positions;
  const double apart = 3.0 * scene_.particle_spacing;
  for (double x = 0.5 * apart; x < 1.0; x += apart) {
    for (double y = 0.5 * apart; y < 0.5; y += apart) {
      positions.emplace_back(x, GetParam() == 2 ? 0.0 : y, 0.11);
      if (GetParam() == 2) break;
    }
  }
  const Snapshot water = hand_made_snapshot(scene_, positions);
  const DepthGrid grid = grid_of(water);
  EXPECT_THAT(grid.depth, testing::Each(testing::Gt(0.0F)));
  scene_.output.depth_rule = DepthRule::HighestParticle;
  EXPECT_THAT(grid_of(water).depth, testing::Contains(0.0F)) << "which the other rule has";
}

TEST_P(SurfaceDepthTest, KeepsTheVolume) {
  scene_.output.depth_cell_size = 0.02;
  Snapshot water = still_water(scene_, Vec3d(0.5, 0.5, 0.2));
  shake(water, 0.009);
  const DepthGrid grid = grid_of(water);
  const double sum = std::accumulate(grid.depth.begin(), grid.depth.end(), 0.0);
  const double volume = sum * (GetParam() == 2 ? 0.02 : 0.02 * 0.02);
  EXPECT_NEAR(volume, 0.5 * 0.2 * (GetParam() == 2 ? 1.0 : 0.5), 1e-6);
}

TEST_P(SurfaceDepthTest, IsTheLevelNextToAndAboveSolids) {
  scene_.obstacles.push_back({"high", box(Vec3d(0.2, -1.0, 0.1), Vec3d(0.4, 1.0, 0.5))});
  scene_.obstacles.push_back({"low", box(Vec3d(0.6, -1.0, 0.1), Vec3d(0.8, 1.0, 0.2))});
  const DepthGrid grid = grid_of(still_water(scene_, Vec3d(1.0, 0.5, 0.2)));
  for (std::size_t i = 0; i < grid.columns; ++i) {
    const bool in_high = x_of(i) > 0.2 && x_of(i) < 0.4;
    for (std::size_t j = 0; j < grid.rows; ++j) {
      EXPECT_NEAR(grid.at(i, j), in_high ? 0.0 : 0.2, 1e-6) << x_of(i) << ", row " << j;
    }
  }
}

TEST_P(SurfaceDepthTest, IsZeroWithoutWaterAndOnDrySolids) {
  scene_.obstacles.push_back({"block", box(Vec3d(0.2, -1.0, 0.1), Vec3d(0.4, 1.0, 0.2))});
  EXPECT_THAT(grid_of(hand_made_snapshot(scene_, {})).depth, testing::Each(0.0F));
}

TEST_P(SurfaceDepthTest, LeavesAGateOutOnceItIsGone) {
  Gate gate;
  gate.name = "gate";
  gate.shape = box(Vec3d(0.4, -1.0, 0.1), Vec3d(0.6, 1.0, 0.5));
  gate.start_time = 0.5;
  scene_.gates.push_back(gate);
  Snapshot water = still_water(hand_made_scene(GetParam()), Vec3d(1.0, 0.5, 0.2));
  water.time = 0.6;
  EXPECT_THAT(grid_of(water).depth, testing::Each(testing::FloatNear(0.2F, 1e-6F)));
}

TEST_P(SurfaceDepthTest, CountsTheWaterUnderALiftedGate) {
  Gate gate;
  gate.name = "gate";
  gate.shape = box(Vec3d(0.4, -1.0, 0.1), Vec3d(0.6, 1.0, 0.5));
  gate.motion = GateMotion::Lift;
  gate.speed = 1.0;
  gate.stroke = 0.4;
  scene_.gates.push_back(gate);
  Snapshot water = still_water(hand_made_scene(GetParam()), Vec3d(1.0, 0.5, 0.1));
  water.time = 0.2;
  EXPECT_THAT(grid_of(water).depth, testing::Each(testing::FloatNear(0.1F, 1e-6F)));
}

TEST_P(SurfaceDepthTest, CountsSprayByItsVolume) {
  Snapshot drops = hand_made_snapshot(scene_, {{0.3F, 0.25F, 0.3F}, {0.6F, 0.3F, 0.55F}});
  drops.number_density = {0.14F, 0.14F};
  const DepthGrid grid = grid_of(drops);
  double volume = 0.0;
  for (const float depth : grid.depth) volume += depth * std::pow(grid.cell_size, GetParam() - 1);
  const double water = 2.0 * drops.particle_mass / drops.reference_density;
  EXPECT_NEAR(volume, water, 0.02 * water);
}

INSTANTIATE_TEST_SUITE_P(Dimension, SurfaceDepthTest, testing::Values(2, 3));

TEST(SurfaceDepthAround, ACylinderAndATurnedBoxIsTheLevel) {
  Scene scene = hand_made_scene(3);
  scene.output.depth_rule = DepthRule::Surface;
  Shape cylinder;
  cylinder.kind = ShapeKind::Cylinder;
  cylinder.centre = Vec3d(0.3, 0.25, 0.1);
  cylinder.radius = 0.1;
  cylinder.height = 0.4;
  scene.obstacles.push_back({"cylinder", cylinder});
  scene.obstacles.push_back({"box", box(Vec3d(0.65, 0.15, 0.1), Vec3d(0.85, 0.35, 0.5), 0.4)});
  const DepthGrid grid = DepthGridBuilder(scene).build(still_water(scene, Vec3d(1.0, 0.5, 0.2)));
  double error_sum = 0.0;
  for (std::size_t i = 0; i < grid.columns; ++i) {
    for (std::size_t j = 0; j < grid.rows; ++j) {
      const Vec3d middle((static_cast<double>(i) + 0.5) * grid.cell_size,
                         (static_cast<double>(j) + 0.5) * grid.cell_size, 0.3);
      const bool in_solid =
          scene.obstacles[0].shape.contains(middle, 3) || scene.obstacles[1].shape.contains(middle, 3);
      if (in_solid) {
        EXPECT_EQ(grid.at(i, j), 0.0F);
      } else {
        // The lattice does not follow these faces.
        EXPECT_NEAR(grid.at(i, j), 0.2, 0.08) << middle.transpose();
        error_sum += std::abs(grid.at(i, j) - 0.2);
      }
    }
  }
  EXPECT_LT(error_sum / static_cast<double>(grid.depth.size()), 0.002);
}

}  // namespace
}  // namespace eisph
