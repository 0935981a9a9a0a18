#include "render/depth_map.hpp"

#include "render/synthetic_scene.hpp"

#include <gmock/gmock.h>

namespace eisph {
namespace {

/// Red grows with depth from 0 to 1 m and is 0 to 255; no other part of a map has no green and blue.
ColourMap red_map() {
  ColourMap::Table table{};
  for (std::size_t k = 0; k < table.size(); ++k) table[k].red = static_cast<float>(k) / 255.0F;
  return ColourMap(table);
}

const FieldScale kMetre{"water depth (m)", 0.0, 1.0};

/// Basin of 4 x 2 m with a grid of 8 x 4 cells of the given depth.
struct Basin {
  Scene scene;
  DepthGrid depth;
  ImageSettings settings;

  explicit Basin(float water) {
    scene.particle_spacing = 0.1;
    scene.reference_depth = 1.0;
    scene.domain_max = Vec3d(4.0, 2.0, 2.0);
    depth.cell_size = 0.5;
    depth.columns = 8;
    depth.rows = 4;
    depth.depth.assign(32, water);
    settings.kind = ImageKind::DepthMap;
    settings.dry_depth = 0.05;
  }
  [[nodiscard]] Image draw(int width = 400, int height = 200, int border = 0) const {
    const TopView view = top_view(scene, settings, width, height, border);
    return draw_depth_map(scene, settings, depth, view, width, height, red_map(), kMetre);
  }
};

bool is_water(const Image& image, int x, int y) {
  return image.pixel(x, y)[1] == 0 && image.pixel(x, y)[2] == 0;
}

TEST(TopView, FitsTheFootprintAtEqualScalesInTheCentre) {
  const Basin basin(0.5F);
  const TopView wide = top_view(basin.scene, basin.settings, 1000, 220, 10);
  EXPECT_NEAR(wide.metres_per_pixel, 0.01, 1e-12);
  EXPECT_EQ(wide.area.width, 400);
  EXPECT_EQ(wide.area.height, 200);
  EXPECT_EQ(wide.area.x, 300);
  EXPECT_EQ(wide.area.y, 10);
  EXPECT_NEAR(wide.left, 0.0, 1e-12);
  EXPECT_NEAR(wide.top, 2.0, 1e-12);
}

TEST(TopView, MirrorsAcrossSymmetryFacesOnly) {
  Basin basin(0.5F);
  basin.settings.mirror = true;
  EXPECT_NEAR(top_view(basin.scene, basin.settings, 400, 400, 0).top, 2.0, 1e-12);
  basin.scene.faces[kYMax].kind = FaceKind::Symmetry;
  const TopView view = top_view(basin.scene, basin.settings, 400, 400, 0);
  EXPECT_NEAR(view.top, 4.0, 1e-12);
  EXPECT_EQ(view.area.height, 400);
  basin.scene.faces[kXMin].kind = FaceKind::Symmetry;
  EXPECT_NEAR(top_view(basin.scene, basin.settings, 400, 400, 0).left, -4.0, 1e-12);
}

TEST(DepthMap, DepthAboveTheThresholdIsWaterAndBelowItIsFloor) {
  Basin basin(0.049F);
  EXPECT_FALSE(is_water(basin.draw(), 200, 100));
  basin.depth.depth.assign(32, 0.051F);
  const Image wet = basin.draw();
  EXPECT_TRUE(is_water(wet, 200, 100));
  EXPECT_NEAR(wet.pixel(200, 100)[0], 255.0 * 0.051, 1.0);
  basin.settings.dry_depth = 0.06;
  EXPECT_FALSE(is_water(basin.draw(), 200, 100));
}

TEST(DepthMap, WithoutAThresholdDryCellsAreStillFloor) {
  Basin basin(0.0F);
  basin.settings.dry_depth = 0.0;
  EXPECT_FALSE(is_water(basin.draw(), 200, 100));
}

TEST(DepthMap, IsLinearBetweenCellCentres) {
  Basin basin(0.2F);
  for (std::size_t j = 0; j < 4; ++j) basin.depth.depth[j * 8 + 4] = 0.8F;
  basin.settings.draw_walls = false;
  const Image image = basin.draw();
  // Cell centres at x = 1.75 and 2.25 m; a pixel is 0.01 m.
  EXPECT_NEAR(image.pixel(174, 100)[0], 255.0 * 0.2, 2.0);
  EXPECT_NEAR(image.pixel(225, 100)[0], 255.0 * 0.8, 2.0);
  EXPECT_NEAR(image.pixel(200, 100)[0], 255.0 * 0.506, 2.0);
}

TEST(DepthMap, XPointsRightAndYUp) {
  Basin basin(0.0F);
  basin.depth.depth[3 * 8 + 7] = 1.0F;
  const Image image = basin.draw();
  EXPECT_TRUE(is_water(image, 380, 20));
  EXPECT_FALSE(is_water(image, 20, 20));
  EXPECT_FALSE(is_water(image, 380, 180));
}

TEST(DepthMap, WaterDoesNotSeepAcrossADam) {
  Basin basin(0.0F);
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) basin.depth.depth[j * 8 + i] = 1.0F;
  }
  basin.scene.obstacles.push_back(synthetic::box("dam", {2.0, 0.0, 0.0}, {2.5, 2.0, 1.0}));
  const Image image = basin.draw();
  EXPECT_TRUE(is_water(image, 197, 100)) << "full depth up to the dam";
  EXPECT_EQ(image.pixel(197, 100)[0], 255);
  for (int x = 200; x < 400; ++x) EXPECT_FALSE(is_water(image, x, 100)) << x;
}

TEST(DepthMap, ALiftedGateIsDrawnUntilItIsGone) {
  Basin basin(1.0F);
  Gate gate;
  gate.shape = synthetic::box("", {2.0, 0.0, 0.0}, {2.2, 2.0, 1.0}).shape;
  gate.motion = GateMotion::Lift;
  gate.speed = 1.0;
  gate.stroke = 0.5;
  basin.scene.gates.push_back(gate);
  basin.depth.time = 0.4;
  EXPECT_FALSE(is_water(basin.draw(), 210, 100));
  basin.depth.time = 0.6;
  EXPECT_TRUE(is_water(basin.draw(), 210, 100));
}

TEST(DepthMap, TheMirrorImageOfAHalfIsTheWhole) {
  synthetic::State full = synthetic::tank(0.02);
  synthetic::State half = synthetic::tank(0.02, true);
  // The half's obstacle may end at the symmetry plane or go on behind it.
  half.scene.obstacles.back().shape.max.y() = 0.6;
  ImageSettings settings;
  settings.kind = ImageKind::DepthMap;
  settings.mirror = true;
  const auto draw = [&](const synthetic::State& state) {
    const TopView view = top_view(state.scene, settings, 520, 300, 4);
    const FieldScale scale{"", 0.0, 0.15};
    return draw_depth_map(state.scene, settings, state.depth, view, 520, 300, red_map(), scale);
  };
  const Image whole = draw(full);
  const Image mirrored = draw(half);
  int largest = 0;
  for (std::size_t k = 0; k < whole.rgb.size(); ++k)
    largest = std::max(largest, std::abs(whole.rgb[k] - mirrored.rgb[k]));
  EXPECT_LE(largest, 1);
}

}  // namespace
}  // namespace eisph
