#include "app/view/view_camera.hpp"

#include "render/camera_view.hpp"
#include "render/synthetic_scene.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

Camera camera_at(const Vec3d& eye) {
  Camera camera;
  camera.eye = eye;
  camera.target = Vec3d(1.0, 0.5, 0.0);
  return camera;
}

TEST(ViewCamera, OrbitsAtTheSameDistance) {
  Camera camera = camera_at({1.0, -1.5, 0.0});
  orbit(camera, 90.0, 0.0);
  EXPECT_NEAR((camera.eye - Vec3d(3.0, 0.5, 0.0)).norm(), 0.0, 1e-12);
  orbit(camera, 0.0, 30.0);
  EXPECT_NEAR(camera.eye.z(), 2.0 * std::sin(std::numbers::pi / 6.0), 1e-12);
  orbit(camera, 0.0, 500.0);
  EXPECT_NEAR((camera.eye - camera.target).norm(), 2.0, 1e-12);
  EXPECT_NEAR(camera.eye.z(), 2.0 * std::sin(89.0 * std::numbers::pi / 180.0), 1e-12) << "never over the top";
}

TEST(ViewCamera, OrbitFromTheTopKeepsWhatIsUp) {
  Camera camera = camera_at({1.0, 0.5, 2.0});
  camera.up = Vec3d::UnitY();
  orbit(camera, 0.0, -60.0);  // towards what is below on the screen
  EXPECT_LT(camera.eye.y(), 0.5);
  EXPECT_NEAR(camera.eye.x(), 1.0, 1e-9);
  EXPECT_EQ(camera.up, Vec3d::UnitZ());
}

TEST(ViewCamera, PansByPixels) {
  Camera camera = camera_at({1.0, -1.5, 1.0});
  const CameraView before(camera, 400, 600, 400, {Vec3d::Zero(), Vec3d::Ones()});
  pan(camera, 30.0, 20.0, before.pixels_per_metre());
  const CameraView after(camera, 400, 600, 400, {Vec3d::Zero(), Vec3d::Ones()});
  const Vec3d moved = after.project({1.0, 0.5, 0.0}) - before.project({1.0, 0.5, 0.0});
  EXPECT_NEAR(moved.x(), -30.0, 1.0);
  EXPECT_NEAR(moved.y(), 20.0, 1.0);
}

TEST(ViewCamera, KeepsTheSizeAtTheTargetWhenTheProjectionChanges) {
  Camera camera = camera_at({1.0, -1.5, 1.0});
  const auto scale = [&camera] {
    return CameraView(camera, 400, 600, 400, {Vec3d::Zero(), Vec3d::Ones()}).pixels_per_metre();
  };
  const double perspective = scale();
  set_projection(camera, Projection::Orthographic);
  EXPECT_NEAR(scale(), perspective, 1e-9 * perspective);
  zoom(camera, 0.5);
  EXPECT_NEAR(scale(), 2.0 * perspective, 1e-9 * perspective);
  set_projection(camera, Projection::Perspective);
  EXPECT_NEAR(scale(), 2.0 * perspective, 1e-9 * perspective);
}

TEST(ViewCamera, EveryPresetShowsTheWholeTank) {
  const Scene scene = synthetic::tank_scene(0.05);
  const Bounds box = framed_bounds(scene);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    for (const PresetView preset :
         {PresetView::Oblique, PresetView::Front, PresetView::Side, PresetView::Top, PresetView::AlongFlow}) {
      SCOPED_TRACE(preset_name(preset));
      const Camera camera = preset_camera(scene, preset, projection, 480, 640, 480);
      const CameraView view(camera, 480, 640, 480, drawn_bounds(scene));
      double widest = 0.0;
      for (int k = 0; k < 8; ++k) {
        const Vec3d at = view.project(box.corner(k));
        widest = std::max({widest, std::abs(at.x() - 320.0) / 320.0, std::abs(at.y() - 240.0) / 240.0});
      }
      EXPECT_LE(widest, 1.0);
      EXPECT_GT(widest, 0.85) << "and fills the picture";
    }
  }
}

}  // namespace
}  // namespace eisph
