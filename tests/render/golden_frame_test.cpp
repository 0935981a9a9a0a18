// Frames of made-up states against the pictures in golden/.

#include "core/error.hpp"
#include "render/frame_renderer.hpp"
#include "render/golden.hpp"
#include "render/synthetic_scene.hpp"
#include "render/virtual_display.hpp"

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace eisph {
namespace {

class GoldenFrame : public ::testing::Test {
 protected:
  static ImageSettings small(ImageKind kind = ImageKind::Particles) {
    ImageSettings settings;
    settings.kind = kind;
    settings.width = 320;
    settings.height = 240;
    if (kind == ImageKind::DepthMap) settings.colour_map = "depth_blue";
    return settings;
  }
  static void TearDownTestSuite() { display().reset(); }

  /// All contexts, or those in EISPH_TEST_CONTEXTS ("egl", say, on a server that has nothing else).
  static std::vector<ContextKind> contexts() {
    const char* names = std::getenv("EISPH_TEST_CONTEXTS");  // NOLINT(concurrency-mt-unsafe)
    std::istringstream words(names != nullptr ? names : "osmesa egl window");
    std::vector<ContextKind> kinds;
    for (std::string name; words >> name;) kinds.emplace_back(context_kind(name));
    if (kinds.empty()) throw InputError("EISPH_TEST_CONTEXTS names no context");
    return kinds;
  }
  /// One for all tests of the process.
  static void open_display() {
    if (!display()) display() = std::make_unique<VirtualDisplay>();
  }
  /// The frame of the first context, after making sure that the other contexts draw the same.
  static Image draw(const synthetic::State& state, const ImageSettings& settings) {
    const auto by = [&](ContextKind kind) {
      if (kind == ContextKind::Window) open_display();
      return FrameRenderer(state.scene, {.context = kind}).draw(settings, state.snapshot, state.depth);
    };
    const std::vector<ContextKind> kinds = contexts();
    Image frame = by(kinds.front());
    if (settings.kind != ImageKind::Particles) return frame;
    for (std::size_t k = 1; k < kinds.size(); ++k) {
      EXPECT_LE(different_pixels(frame, by(kinds[k])), allowed_different_pixels()) << context_name(kinds[k]);
    }
    return frame;
  }
  /// Half-way opened gate in the breach, and obstacles of the other shapes.
  static synthetic::State furnished_tank() {
    synthetic::State state = synthetic::tank(0.02);
    Gate gate;
    gate.shape = synthetic::box("", {0.8, 0.45, 0.0}, {0.825, 0.75, 0.2}).shape;
    gate.motion = GateMotion::Lift;
    gate.speed = 0.25;
    gate.stroke = 0.2;
    state.scene.gates.push_back(gate);
    state.scene.obstacles.push_back(synthetic::box("turned", {2.1, 0.1, 0.0}, {2.4, 0.2, 0.15}, 0.6));
    Obstacle pillar;
    pillar.shape.kind = ShapeKind::Cylinder;
    pillar.shape.centre = Vec3d(2.2, 0.6, 0.0);
    pillar.shape.radius = 0.1;
    pillar.shape.height = 0.2;
    state.scene.obstacles.push_back(pillar);
    Obstacle ball;
    ball.shape.kind = ShapeKind::Sphere;
    ball.shape.centre = Vec3d(2.25, 1.0, 0.12);
    ball.shape.radius = 0.12;
    state.scene.obstacles.push_back(ball);
    return state;
  }

 private:
  static std::unique_ptr<VirtualDisplay>& display() {
    static std::unique_ptr<VirtualDisplay> instance;
    return instance;
  }
};

TEST_F(GoldenFrame, ParticlesInPerspective) { expect_golden("perspective", draw(furnished_tank(), small())); }

TEST_F(GoldenFrame, SaysWhatDraws) {
  const synthetic::State state = furnished_tank();
  for (const ContextKind kind : contexts()) {
    if (kind == ContextKind::Window) open_display();
    FrameRenderer renderer(state.scene, {.context = kind});
    EXPECT_EQ(renderer.context_description(), "");
    static_cast<void>(renderer.draw(small(), state.snapshot, state.depth));
    EXPECT_THAT(renderer.context_description(), testing::HasSubstr(std::string(context_name(kind)) + ": "));
  }
}

TEST_F(GoldenFrame, ParticlesFromAGivenCameraOnADarkPage) {
  ImageSettings settings = small();
  settings.dark_background = true;
  settings.camera = Camera{};
  settings.camera->eye = Vec3d(2.8, 0.6, 0.5);
  settings.camera->target = Vec3d(1.3, 0.6, 0.0);
  expect_golden("close_dark", draw(furnished_tank(), settings));
}

TEST_F(GoldenFrame, OrthographicFromAbove) {
  ImageSettings settings = small();
  settings.camera = Camera{};
  settings.camera->projection = Projection::Orthographic;
  settings.camera->eye = Vec3d(1.3, 0.6, 3.0);
  settings.camera->target = Vec3d(1.3, 0.6, 0.0);
  settings.camera->up = Vec3d::UnitY();
  settings.camera->orthographic_height = 2.2;
  expect_golden("orthographic_above", draw(furnished_tank(), settings));
}

TEST_F(GoldenFrame, WaterSurface) {
  ImageSettings settings = small();
  settings.style = WaterStyle::Surface;
  settings.field = "water";
  settings.caption = "Smoothed surface of the particles";
  expect_golden("surface", draw(furnished_tank(), settings));
}

TEST_F(GoldenFrame, WaterSurfaceInTheColoursOfAFieldOnADarkPage) {
  ImageSettings settings = small();
  settings.style = WaterStyle::Surface;
  settings.dark_background = true;
  settings.camera = Camera{};
  settings.camera->eye = Vec3d(2.8, 0.6, 0.5);
  settings.camera->target = Vec3d(1.3, 0.6, 0.0);
  expect_golden("surface_speed_dark", draw(furnished_tank(), settings));
}

TEST_F(GoldenFrame, WallsAsOutlinesAndNoShadow) {
  ImageSettings settings = small();
  settings.glass = false;
  settings.shadow = false;
  expect_golden("plain", draw(furnished_tank(), settings));
}

/// A frame of a view, a depth map and two gauges.
Image draw_panels(int width, int height, bool dark) {
  synthetic::State state = synthetic::tank(0.02);
  ImageSettings view;
  view.name = "view";
  ImageSettings map;
  map.name = "map";
  map.kind = ImageKind::DepthMap;
  map.colour_map = "depth_blue";
  state.scene.images = {view, map};
  state.scene.end_time = 1.0;
  state.scene.gauges = {{.name = "dam", .x = 0.7, .y = 0.6}, {.name = "far", .x = 1.8, .y = 0.6}};
  ImageSettings panels;
  panels.kind = ImageKind::Panels;
  panels.width = width;
  panels.height = height;
  panels.dark_background = dark;
  panels.panels = {"view", "map"};
  panels.gauges = {"dam", "far"};
  std::vector<GaugeCurve> curves{{"dam", {}, {}}, {"far", {}, {}}};
  for (int k = 0; k <= 100; ++k) {
    const double time = 0.01 * k;
    for (GaugeCurve& curve : curves) curve.time.push_back(time);
    curves[0].surface.push_back(0.15 - 0.1 * time);
    curves[1].surface.push_back(time < 0.3 ? 0.0 : 0.06 * std::sqrt(time - 0.3));
  }
  return FrameRenderer(state.scene).draw(panels, state.snapshot, state.depth, curves);
}

TEST_F(GoldenFrame, PanelsSideBySide) { expect_golden("panels_wide", draw_panels(640, 360, false)); }

TEST_F(GoldenFrame, PanelsBelowEachOtherOnADarkPage) {
  expect_golden("panels_upright", draw_panels(360, 640, true));
}

TEST_F(GoldenFrame, PanelsThatCannotBeDrawnAreRefused) {
  EXPECT_THAT(
      [] { draw_panels(160, 160, false); },
      ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("3 panels are too many for 160 x 160")));
  const synthetic::State state = synthetic::tank(0.05);
  ImageSettings panels;
  panels.kind = ImageKind::Panels;
  panels.panels = {"absent"};
  EXPECT_THAT([&] { FrameRenderer(state.scene).draw(panels, state.snapshot, state.depth); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("absent")));
}

TEST_F(GoldenFrame, CutOpenAlongTheMiddle) {
  ImageSettings settings = small();
  settings.clip = ClipBox{{-1.0, 0.6, -1.0}, {4.0, 4.0, 2.0}};
  expect_golden("cut", draw(furnished_tank(), settings));
  settings.style = WaterStyle::Surface;
  expect_golden("cut_surface", draw(furnished_tank(), settings));
}

TEST_F(GoldenFrame, OtherParticlesInTheirOwnColours) {
  synthetic::State state = synthetic::channel(0.04);
  auto objects = std::make_shared<ObjectParticles>();
  BoundaryParticles boundary;
  for (int k = 0; k < 40; ++k) {
    const float x = 0.04F * static_cast<float>(k) + 0.02F;
    boundary.ghosts.emplace_back(x, 0.0F, -0.02F);
    boundary.virtual_particles.emplace_back(x, 0.0F, 0.0F);
    objects->position.emplace_back(x, 0.0F, 0.5F);
    objects->pressure.push_back(0.0F);
  }
  state.snapshot.objects = objects;
  ImageSettings settings = small();
  settings.field = "kind";
  settings.draw_ghosts = true;
  settings.draw_virtual_particles = true;
  FrameRenderer renderer(state.scene);
  const Image all = renderer.draw(settings, state.snapshot, state.depth, {}, boundary);
  expect_golden("particle_kinds", all);
  settings.draw_fluid = false;
  EXPECT_GT(different_pixels(all, renderer.draw(settings, state.snapshot, state.depth, {}, boundary)), 0.02);
}

TEST_F(GoldenFrame, TwoDimensions) {
  expect_golden("two_dimensions", draw(synthetic::channel(0.02), small()));
}

TEST_F(GoldenFrame, WithoutWallsAndObstacles) {
  ImageSettings settings = small();
  settings.draw_walls = false;
  settings.draw_obstacles = false;
  expect_golden("bare", draw(furnished_tank(), settings));
}

class GoldenField : public GoldenFrame, public ::testing::WithParamInterface<const char*> {};

TEST_P(GoldenField, ColoursTheParticles) {
  synthetic::State state = synthetic::tank(0.02);
  auto objects = std::make_shared<ObjectParticles>();
  for (int k = 0; k < 12; ++k) {
    for (int j = 0; j < 16; ++j) {
      objects->position.emplace_back(1.43F, 0.46F + 0.02F * static_cast<float>(j),
                                     0.01F + 0.02F * static_cast<float>(k));
    }
  }
  state.snapshot.objects = objects;
  ImageSettings settings = small();
  settings.field = GetParam();
  settings.colour_map.clear();
  expect_golden(std::string("field_") + GetParam(), draw(state, settings));
}

INSTANTIATE_TEST_SUITE_P(All, GoldenField,
                         ::testing::Values("speed", "velocity_x", "velocity_y", "velocity_z", "pressure",
                                           "depth", "kind"),
                         [](const auto& field) { return std::string(field.param); });

TEST_F(GoldenFrame, DepthMapInColour) {
  expect_golden("depth_colour", draw(furnished_tank(), small(ImageKind::DepthMap)));
}

TEST_F(GoldenFrame, DepthMapInGrey) {
  ImageSettings settings = small(ImageKind::DepthMap);
  settings.colour_map = "grey_depth";
  expect_golden("depth_grey", draw(furnished_tank(), settings));
}

TEST_F(GoldenFrame, DepthMapOfAHalfAndItsMirrorImage) {
  ImageSettings settings = small(ImageKind::DepthMap);
  expect_golden("depth_half", draw(synthetic::tank(0.02, true), settings));
  settings.mirror = true;
  expect_golden("depth_mirrored", draw(synthetic::tank(0.02, true), settings));
}

TEST_F(GoldenFrame, DepthMapWithAHighDryDepth) {
  ImageSettings settings = small(ImageKind::DepthMap);
  settings.dry_depth = 0.04;
  expect_golden("depth_threshold", draw(synthetic::tank(0.02), settings));
}

TEST_F(GoldenFrame, DepthProfile) {
  expect_golden("depth_profile", draw(synthetic::channel(0.02), small(ImageKind::DepthMap)));
}

TEST_F(GoldenFrame, TheSameFrameIsDrawnTwice) {
  const synthetic::State state = synthetic::tank(0.02);
  FrameRenderer renderer(state.scene);
  const Image first = renderer.draw(small(), state.snapshot, state.depth);
  ImageSettings other = small(ImageKind::DepthMap);
  other.width = 400;
  renderer.draw(other, state.snapshot, state.depth);
  EXPECT_EQ(renderer.draw(small(), state.snapshot, state.depth).rgb, first.rgb);
}

TEST_F(GoldenFrame, AnEmptyTankIsDrawn) {
  synthetic::State state = synthetic::tank(0.02);
  const double water = different_pixels(draw(state, small()), draw(synthetic::tank(0.04), small()));
  state.snapshot.position.clear();
  state.snapshot.velocity.clear();
  state.snapshot.pressure.clear();
  state.depth = DepthGrid{};
  EXPECT_GT(different_pixels(draw(synthetic::tank(0.02), small()), draw(state, small())), water);
  EXPECT_NO_THROW(draw(state, small(ImageKind::DepthMap)));
}

}  // namespace
}  // namespace eisph
