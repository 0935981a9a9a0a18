#include "render/fluid_surface.hpp"

#include "render/colour_map.hpp"
#include "render/frame_renderer.hpp"
#include "render/synthetic_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kSpacing = 0.02;

/// Still water of `layers` particles on part of a floor of 0.8 x 0.8 m.
synthetic::State pool(int layers, int columns = 40) {
  synthetic::State state;
  state.scene.particle_spacing = kSpacing;
  state.scene.reference_depth = 0.2;
  state.scene.domain_max = Vec3d(0.8, 0.8, 0.6);
  state.snapshot.particle_spacing = kSpacing;
  state.snapshot.objects = std::make_shared<ObjectParticles>();
  for (int k = 0; k < layers; ++k) {
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < columns; ++i)
        synthetic::add_particle(state, kSpacing * Vec3d(i + 0.5, j + 0.5, k + 0.5), {0.7, 0.0, 0.0}, 0.0);
    }
  }
  return state;
}

/// From straight above, without anything that is not floor or water.
ImageSettings from_above(WaterStyle style) {
  ImageSettings settings;
  settings.width = 320;
  settings.height = 240;
  settings.style = style;
  settings.field = style == WaterStyle::Surface ? "water" : "speed";
  settings.shadow = false;
  settings.camera = Camera{};
  settings.camera->projection = Projection::Orthographic;
  settings.camera->eye = Vec3d(0.4, 0.4, 3.0);
  settings.camera->target = Vec3d(0.4, 0.4, 0.0);
  settings.camera->up = Vec3d::UnitY();
  settings.camera->orthographic_height = 0.6;
  return settings;
}

Image draw(const synthetic::State& state, const ImageSettings& settings) {
  return FrameRenderer(state.scene).draw(settings, state.snapshot, state.depth);
}

/// Mean and largest deviation from it of a channel in a square of 40 pixels about (x, y).
struct Patch {
  double mean = 0.0;
  double spread = 0.0;
};

Patch patch(const Image& image, int channel, int x = 160, int y = 110) {
  Patch result;
  for (int row = y - 20; row < y + 20; ++row) {
    for (int column = x - 20; column < x + 20; ++column)
      result.mean += image.pixel(column, row)[channel] / 1600.0;
  }
  for (int row = y - 20; row < y + 20; ++row) {
    for (int column = x - 20; column < x + 20; ++column)
      result.spread = std::max(result.spread, std::abs(image.pixel(column, row)[channel] - result.mean));
  }
  return result;
}

TEST(FluidSurface, StillWaterIsFlatWhereSpheresAreNot) {
  const synthetic::State state = pool(5);
  EXPECT_GT(patch(draw(state, from_above(WaterStyle::Spheres)), 1).spread, 15.0);
  EXPECT_LT(patch(draw(state, from_above(WaterStyle::Surface)), 1).spread, 4.0);
}

TEST(FluidSurface, LightFallsExponentiallyWithTheDepth) {
  // With c(d) = c(inf) + (c(0) - c(inf)) T(d) under the same mirror image, T(2 d) = T(d)^2.
  const auto green = [](const synthetic::State& state) {
    return patch(draw(state, from_above(WaterStyle::Surface)), 1).mean;
  };
  const double deep = green(pool(29));
  const double shallow = green(pool(4));
  const double double_depth = green(pool(8));
  const double fourfold = green(pool(16));
  const double once = shallow - deep;
  const double twice = double_depth - deep;
  const double four_times = fourfold - deep;
  ASSERT_GT(once, 30.0);
  // T(8) / T(4) = T(4), and T(16) / T(8) = T(8) = T(4)^2.
  EXPECT_NEAR(four_times / twice, std::pow(twice / once, 2), 0.05);
}

TEST(WaterPieces, OfColumnsHaveTheirVolume) {
  synthetic::State state = pool(1);
  EXPECT_EQ(water_pieces(state.snapshot, 0.0).size(), 1600U);
  auto columns = std::make_shared<ColumnField>();
  columns->cell_size = 0.04;
  columns->origin_x = 1.0;
  columns->columns = 3;
  columns->rows = 1;
  columns->bed = {0.1F, 0.0F, 0.0F};
  columns->depth = {0.5F, 0.0F, 0.08F};
  state.snapshot.columns = columns;
  const std::vector<WaterPiece> pieces = water_pieces(state.snapshot, 2.0);
  ASSERT_EQ(pieces.size(), 5U);
  double first = 0.0;
  for (int k = 0; k < 4; ++k) first += pieces[static_cast<std::size_t>(k)].volume;
  EXPECT_NEAR(first * std::pow(kSpacing, 3), 0.5 * 0.04 * 0.04, 1e-8);
  EXPECT_NEAR(pieces[4].volume * std::pow(kSpacing, 3), 0.08 * 0.04 * 0.04, 1e-8);
  EXPECT_NEAR(pieces[0].position.x(), 1.02, 1e-6);
  EXPECT_NEAR(pieces[0].position.z(), 2.1 + 0.0625, 1e-6);
  EXPECT_NEAR(pieces[4].position.x(), 1.1, 1e-6);
}

TEST(FluidSurface, FieldsKeepTheColourOfTheBar) {
  ImageSettings settings = from_above(WaterStyle::Surface);
  settings.field = "speed";
  settings.range = {0.0, 1.0};
  const Image frame = draw(pool(10), settings);
  const Colour expected = ColourMap::load("viridis").at(0.7);
  const std::array channels{expected.red, expected.green, expected.blue};
  for (int c = 0; c < 3; ++c) {
    // Lit from above: a little darker than the bar, and a little of the sky in it.
    EXPECT_NEAR(patch(frame, c).mean, 255.0 * channels[static_cast<std::size_t>(c)], 26.0) << c;
  }
}

TEST(FluidSurface, ASolidBeforeTheWaterHidesIt) {
  synthetic::State wet = pool(6);
  synthetic::State dry = pool(0);
  for (synthetic::State* state : {&wet, &dry})
    state->scene.obstacles = {synthetic::box("lid", {-0.1, -0.1, 0.3}, {0.9, 0.9, 0.32})};
  EXPECT_EQ(draw(wet, from_above(WaterStyle::Surface)).rgb, draw(dry, from_above(WaterStyle::Surface)).rgb);
}

TEST(FluidSurface, ADropIsSeenAtItsPlaceAndSizeInTheAirAndOnTheFloor) {
  for (const double height : {0.3, 0.01}) {
    synthetic::State state = pool(0);
    const Image bare = draw(state, from_above(WaterStyle::Surface));
    synthetic::add_particle(state, {0.4, 0.4, height}, Vec3d::Zero(), 0.0);
    state.snapshot.number_density.back() = 0.1F;
    const Image drop = draw(state, from_above(WaterStyle::Surface));
    int changed = 0;
    double x = 0.0;
    for (int row = 0; row < drop.height; ++row) {
      for (int column = 0; column < drop.width; ++column) {
        if (std::equal(drop.pixel(column, row), drop.pixel(column, row) + 3, bare.pixel(column, row)))
          continue;
        ++changed;
        x += column;
      }
    }
    // 240 pixels to 0.6 m, radius half a spacing: a disc of 50 pixels, and the pixels on its rim.
    EXPECT_GT(changed, 40) << height;
    EXPECT_LT(changed, 90) << height;
    EXPECT_NEAR(x / changed, 160.0, 1.0) << height;
  }
}

TEST(FluidSurface, ASphereLeavesThePictureBitByBit) {
  for (const auto style : {WaterStyle::Spheres, WaterStyle::Surface}) {
    for (const Vec3d& way : {Vec3d(1.0, 0.0, 0.0), Vec3d(0.0, 1.0, 0.0)}) {
      synthetic::State state = pool(0);
      state.scene.particle_spacing = 0.1;
      state.snapshot.particle_spacing = 0.1;
      FrameRenderer renderer(state.scene);
      const Image bare = renderer.draw(from_above(style), state.snapshot, state.depth);
      synthetic::add_particle(state, Vec3d::Zero(), Vec3d::Zero(), 0.0);
      int first = 0;
      int before = 0;
      int last = 0;
      for (int pixels = 0; pixels <= 200; pixels += 4) {
        const Vec3d place = Vec3d(0.4, 0.4, 0.1) + 0.0025 * pixels * way;
        state.snapshot.position.back() = place.cast<float>();
        const Image frame = renderer.draw(from_above(style), state.snapshot, state.depth);
        last = 0;
        for (std::size_t k = 0; k < frame.rgb.size(); k += 3) {
          if (!std::equal(&frame.rgb[k], &frame.rgb[k] + 3, &bare.rgb[k])) ++last;
        }
        if (pixels == 0) first = before = last;
        EXPECT_LT(std::abs(last - before), first / 4) << way.transpose() << " " << pixels;
        before = last;
      }
      EXPECT_GT(first, 500);
      EXPECT_EQ(last, 0);
    }
  }
}

TEST(FluidSurface, AVeryWideFrameHasTheSameScale) {
  const synthetic::State state = pool(4);
  for (const auto style : {WaterStyle::Spheres, WaterStyle::Surface}) {
    int narrow = 0;
    for (const int width : {460, 4600}) {
      ImageSettings settings = from_above(style);
      settings.width = width;
      settings.height = 200;
      const Image frame = draw(state, settings);
      int wet = 0;  // bluer than red, unlike floor, page and text; above the colour bar
      for (int row = 40; row < 140; ++row) {
        for (int column = 0; column < width; ++column) {
          if (frame.pixel(column, row)[2] > frame.pixel(column, row)[0] + 20) ++wet;
        }
      }
      if (width == 460) narrow = wet;
      EXPECT_GT(wet, 5000);
      EXPECT_NEAR(wet, narrow, 0.01 * narrow) << width;
    }
  }
}

TEST(FluidSurface, ADropThatIsNearlyOfTheSurfaceIsSmoothFromNearby) {
  synthetic::State state = pool(4);
  synthetic::add_particle(state, {0.41, 0.41, 0.145}, Vec3d::Zero(), 0.0);
  ImageSettings settings = from_above(WaterStyle::Surface);
  settings.camera->orthographic_height = 0.12;  // 40 pixels to a spacing
  const Image frame = draw(state, settings);
  // What a pixel differs from the mean of its neighbours, mean over a square about the drop.
  double roughness = 0.0;
  for (int row = 60; row < 160; ++row) {
    for (int column = 110; column < 210; ++column) {
      const double mean = 0.5 * (frame.pixel(column - 1, row)[1] + frame.pixel(column + 1, row)[1]);
      roughness += std::abs(frame.pixel(column, row)[1] - mean) / 10000.0;
    }
  }
  EXPECT_LT(roughness, 0.5);
}

TEST(FluidSurface, TheCullingOfHiddenParticlesChangesNothing) {
  const synthetic::State state = synthetic::tank(0.02);
  ImageSettings settings;
  settings.width = 320;
  settings.height = 240;
  settings.style = WaterStyle::Surface;
  settings.field = "water";
  ParticlePictureOptions all;
  all.cull_interior = false;
  const Image culled = FrameRenderer(state.scene).draw(settings, state.snapshot, state.depth);
  const Image whole = FrameRenderer(state.scene, all).draw(settings, state.snapshot, state.depth);
  std::size_t different = 0;
  for (std::size_t k = 0; k < culled.rgb.size(); ++k) {
    if (std::abs(culled.rgb[k] - whole.rgb[k]) > 8) ++different;
  }
  EXPECT_LT(different, culled.rgb.size() / 500);
}

}  // namespace
}  // namespace eisph
