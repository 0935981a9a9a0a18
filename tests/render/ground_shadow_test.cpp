#include "render/ground_shadow.hpp"

#include "render/synthetic_scene.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// A bare floor of 2 x 1 m in cells of 1 cm under water of 0.2 m.
synthetic::State bare_floor() {
  synthetic::State state;
  state.scene.domain_max = Vec3d(2.0, 1.0, 1.0);
  state.scene.particle_spacing = 0.01;
  state.scene.reference_depth = 0.2;
  state.snapshot.particle_spacing = 0.01;
  return state;
}

float darkest(const GroundLight& light) { return *std::min_element(light.light.begin(), light.light.end()); }

TEST(GroundLight, NothingAboveTheFloorLeavesItLit) {
  const synthetic::State state = bare_floor();
  const GroundLight light = ground_light(state.scene, state.snapshot, true, 0.3);
  EXPECT_EQ(light.columns, 200);
  EXPECT_EQ(light.rows, 100);
  EXPECT_TRUE(std::all_of(light.light.begin(), light.light.end(), [](float cell) { return cell == 1.0F; }));
}

TEST(GroundLight, ABlockDarkensTheFloorBesideItAndNotFarAway) {
  synthetic::State state = bare_floor();
  state.scene.obstacles = {synthetic::box("block", {0.8, 0.4, 0.0}, {1.2, 0.6, 0.3})};
  const GroundLight light = ground_light(state.scene, state.snapshot, true, 0.3);
  float before = 0.0F;
  for (int column = 119; column < 150; ++column) {
    EXPECT_GE(light.at(column, 50), before) << column;
    before = light.at(column, 50);
  }
  EXPECT_LT(light.at(121, 50), 0.8F);
  EXPECT_EQ(light.at(160, 50), 1.0F);
  for (int column = 0; column < 100; ++column) {
    EXPECT_NEAR(light.at(column, 50), light.at(199 - column, 50), 1e-6F) << column;
    EXPECT_NEAR(light.at(column, 30), light.at(column, 69), 1e-6F) << column;
  }
  const GroundLight without = ground_light(state.scene, state.snapshot, false, 0.3);
  EXPECT_EQ(darkest(without), 1.0F);
}

TEST(GroundLight, AnEvenSheetTakesItsOpacity) {
  synthetic::State state = bare_floor();
  for (int j = 0; j < 100; ++j) {
    for (int i = 0; i < 200; ++i)
      synthetic::add_particle(state, {0.01 * (i + 0.5), 0.01 * (j + 0.5), 0.1}, Vec3d::Zero(), 0.0);
  }
  const GroundLight light = ground_light(state.scene, state.snapshot, false, 0.25);
  for (const float cell : light.light) EXPECT_NEAR(cell, 0.75F, 1e-4F);
}

TEST(GroundLight, AHigherDropHasAFainterShadow) {
  synthetic::State low = bare_floor();
  synthetic::add_particle(low, {1.0, 0.5, 0.01}, Vec3d::Zero(), 0.0);
  synthetic::State high = bare_floor();
  synthetic::add_particle(high, {1.0, 0.5, 0.3}, Vec3d::Zero(), 0.0);
  const float under_low = darkest(ground_light(low.scene, low.snapshot, false, 0.3));
  const float under_high = darkest(ground_light(high.scene, high.snapshot, false, 0.3));
  EXPECT_NEAR(under_low, 0.7F, 1e-6F);
  EXPECT_GT(under_high, 0.98F);
  EXPECT_LT(under_high, 1.0F);
}

TEST(GroundLight, ALiftedGateCastsNoShadowOnceItIsGone) {
  synthetic::State state = bare_floor();
  Gate gate;
  gate.shape = synthetic::box("gate", {1.0, 0.0, 0.0}, {1.05, 1.0, 0.3}).shape;
  gate.start_time = 0.5;
  state.scene.gates = {gate};
  EXPECT_LT(darkest(ground_light(state.scene, state.snapshot, true, 0.3)), 0.8F);
  state.snapshot.time = 0.6;
  EXPECT_EQ(darkest(ground_light(state.scene, state.snapshot, true, 0.3)), 1.0F);
}

}  // namespace
}  // namespace eisph
