#include "probe/depth_grid.hpp"

#include "core/error.hpp"
#include "probe/hand_made.hpp"

#include <algorithm>

#include <gmock/gmock.h>

namespace eisph {
namespace {

TEST(DepthGridBuilder, DefaultsToCellsOfOneAndAHalfSpacings) {
  const Scene scene = hand_made_scene(3);
  EXPECT_DOUBLE_EQ(DepthGridBuilder(scene).build(hand_made_snapshot(scene, {})).cell_size, 0.03);
}

TEST(DepthGridBuilder, CoversTheWholeDomainWithAPartialLastColumn) {
  Scene scene = hand_made_scene(3);
  scene.domain_max = Vec3d(2.6, 1.2, 0.6);
  scene.output.depth_cell_size = 0.015;
  const DepthGrid grid = DepthGridBuilder(scene).build(hand_made_snapshot(scene, {{2.599F, 1.199F, 0.3F}}));
  EXPECT_EQ(grid.columns, 174U);  // 2.6 / 0.015 = 173.3
  EXPECT_EQ(grid.rows, 80U);      // a multiple: no cell for the rounding error
  EXPECT_FLOAT_EQ(grid.at(173, 79), 0.2F);
}

TEST(DepthGridBuilder, HoldsTheHighestParticleCentreAboveTheFloorInEachCell) {
  Scene scene = hand_made_scene(3);
  scene.output.depth_cell_size = 0.1;
  const std::vector<Vec3f> positions{
      {0.55F, 0.25F, 0.15F}, {0.51F, 0.29F, 0.35F}, {0.59F, 0.21F, 0.20F}, {0.61F, 0.25F, 0.12F}};
  const DepthGrid grid = DepthGridBuilder(scene).build(hand_made_snapshot(scene, positions, 0.75));
  EXPECT_EQ(grid.time, 0.75);
  EXPECT_EQ(grid.columns, 10U);
  EXPECT_EQ(grid.rows, 5U);
  EXPECT_FLOAT_EQ(grid.at(5, 2), 0.25F);
  EXPECT_FLOAT_EQ(grid.at(6, 2), 0.02F);
  EXPECT_EQ(std::count(grid.depth.begin(), grid.depth.end(), 0.0F), 48);
}

TEST(DepthGridBuilder, CountsParticlesOnTheUpperFacesAndLeavesOutThoseBeyond) {
  Scene scene = hand_made_scene(3);
  scene.output.depth_cell_size = 0.1;
  const DepthGridBuilder builder(scene);
  const DepthGrid on_face = builder.build(hand_made_snapshot(scene, {{1.0F, 0.5F, 0.2F}}));
  EXPECT_FLOAT_EQ(on_face.at(9, 4), 0.1F);
  const DepthGrid beyond = builder.build(
      hand_made_snapshot(scene, {{1.01F, 0.2F, 0.2F}, {-0.01F, 0.2F, 0.2F}, {0.5F, 0.51F, 0.2F}}));
  EXPECT_THAT(beyond.depth, testing::Each(0.0F));
}

TEST(DepthGridBuilder, IgnoresParticlesBelowTheFloor) {
  const Scene scene = hand_made_scene(3);
  const DepthGrid grid = DepthGridBuilder(scene).build(hand_made_snapshot(scene, {{0.5F, 0.2F, 0.05F}}));
  EXPECT_THAT(grid.depth, testing::Each(0.0F));
}

TEST(DepthGridBuilder, GivesTwoDimensionalScenesOneRowAboutTheirPlane) {
  Scene scene = hand_made_scene(2);
  scene.output.depth_cell_size = 0.1;
  const DepthGrid grid =
      DepthGridBuilder(scene).build(hand_made_snapshot(scene, {{0.05F, 0.0F, 0.3F}, {0.95F, 0.0F, 0.5F}}));
  EXPECT_EQ(grid.rows, 1U);
  EXPECT_DOUBLE_EQ(grid.origin_y, -0.05);
  EXPECT_FLOAT_EQ(grid.at(0, 0), 0.2F);
  EXPECT_FLOAT_EQ(grid.at(9, 0), 0.4F);
}

TEST(DepthGridBuilder, IgnoresLooseDropsInTheAirUnlessTheyAreToCount) {
  Scene scene = hand_made_scene(3);
  scene.output.depth_cell_size = 0.1;
  Snapshot snapshot = hand_made_snapshot(
      scene, {{0.55F, 0.25F, 0.2F}, {0.55F, 0.25F, 0.5F}, {0.75F, 0.25F, 0.5F}, {0.95F, 0.25F, 0.11F}});
  snapshot.number_density = {0.76F, 0.14F, 0.14F, 0.2F};
  const DepthGrid water = DepthGridBuilder(scene).build(snapshot);
  EXPECT_FLOAT_EQ(water.at(5, 2), 0.1F);
  EXPECT_EQ(water.at(7, 2), 0.0F);
  EXPECT_FLOAT_EQ(water.at(9, 2), 0.01F) << "a film on the floor";
  scene.output.ignore_spray = false;
  const DepthGrid all = DepthGridBuilder(scene).build(snapshot);
  EXPECT_FLOAT_EQ(all.at(5, 2), 0.4F);
  EXPECT_FLOAT_EQ(all.at(7, 2), 0.4F);
  EXPECT_FLOAT_EQ(all.at(9, 2), 0.01F);
}

TEST(DepthGridBuilder, RefusesACellSizeThatIsOfNoUse) {
  Scene scene = hand_made_scene(3);
  for (const double size : {-0.01, 1e-6}) {
    scene.output.depth_cell_size = size;
    EXPECT_THROW(DepthGridBuilder{scene}, InputError) << size;
  }
}

}  // namespace
}  // namespace eisph
