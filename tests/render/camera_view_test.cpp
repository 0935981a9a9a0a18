#include "render/camera_view.hpp"

#include "core/error.hpp"
#include "render/synthetic_scene.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const Bounds kBox{Vec3d(-1.0, -1.0, -1.0), Vec3d(1.0, 1.0, 1.0)};

Camera front() {
  Camera camera;
  camera.eye = Vec3d(0.0, -5.0, 0.0);
  camera.field_of_view = 2.0 * std::atan(0.1) * 180.0 / std::numbers::pi;
  return camera;
}

TEST(CameraView, PerspectivePlacesPointsByTheirDistance) {
  // tan(field of view / 2) = 0.1: 200 pixels of frame height are 1000 pixels of focal length.
  const CameraView view(front(), 200, 160, 120, kBox);
  EXPECT_NEAR(view.focal_length(), 1000.0, 1e-9);
  EXPECT_NEAR(view.pixels_per_metre(), 200.0, 1e-9);
  EXPECT_TRUE(view.project(Vec3d::Zero()).isApprox(Vec3d(80.0, 60.0, 5.0)));
  EXPECT_TRUE(view.project(Vec3d(0.1, 0.0, 0.2)).isApprox(Vec3d(100.0, 20.0, 5.0)));
  EXPECT_TRUE(view.project(Vec3d(0.1, 5.0, 0.2)).isApprox(Vec3d(90.0, 40.0, 10.0)));
  EXPECT_LT(view.project(Vec3d(0.0, -6.0, 0.0)).z(), 0.0);
}

TEST(CameraView, OrthographicIgnoresDistance) {
  Camera camera = front();
  camera.projection = Projection::Orthographic;
  camera.orthographic_height = 4.0;
  const CameraView view(camera, 200, 160, 120, kBox);
  EXPECT_NEAR(view.pixels_per_metre(), 50.0, 1e-12);
  EXPECT_TRUE(view.project(Vec3d(1.0, 0.0, 0.5)).isApprox(Vec3d(130.0, 35.0, 5.0)));
  EXPECT_TRUE(view.project(Vec3d(1.0, 3.0, 0.5)).isApprox(Vec3d(130.0, 35.0, 8.0)));
}

TEST(CameraView, MatricesAgreeWithTheProjectedPixels) {
  Camera camera;
  camera.eye = Vec3d(3.0, -4.0, 2.5);
  camera.target = Vec3d(0.2, 0.1, -0.3);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    camera.projection = projection;
    camera.orthographic_height = 3.0;
    const CameraView view(camera, 480, 600, 400, kBox);
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector4f clip =
          view.projection() * view.view() * kBox.corner(k).cast<float>().homogeneous();
      const Vec3d pixel = view.project(kBox.corner(k));
      EXPECT_NEAR(300.0 * (1.0 + clip.x() / clip.w()), pixel.x(), 1e-2);
      EXPECT_NEAR(200.0 * (1.0 - clip.y() / clip.w()), pixel.y(), 1e-2);
      EXPECT_LT(std::abs(clip.z() / clip.w()), 1.0F) << "corner " << k << " is cut off in depth";
    }
  }
}

TEST(CameraView, CamerasThatLookNowhereAreRefused) {
  Camera camera = front();
  camera.eye = camera.target;
  EXPECT_THAT([&] { return CameraView(camera, 100, 100, 100, kBox); },
              ThrowsMessage<InputError>(HasSubstr("eye")));
  camera = front();
  camera.up = Vec3d::UnitY();
  EXPECT_THAT([&] { return CameraView(camera, 100, 100, 100, kBox); },
              ThrowsMessage<InputError>(HasSubstr("up")));
  camera = front();
  camera.field_of_view = 180.0;
  EXPECT_THAT([&] { return CameraView(camera, 100, 100, 100, kBox); },
              ThrowsMessage<InputError>(HasSubstr("field_of_view = 180")));
  camera.projection = Projection::Orthographic;
  EXPECT_THAT([&] { return CameraView(camera, 100, 100, 100, kBox); },
              ThrowsMessage<InputError>(HasSubstr("orthographic_height = 0")));
}

TEST(CameraView, KnowsWhetherItLooksFromAboveAndFromInside) {
  Camera camera = front();
  camera.eye.z() = 1.0;
  const CameraView above(camera, 100, 100, 100, kBox);
  EXPECT_TRUE(above.looks_from_above(0.5));
  EXPECT_FALSE(above.looks_from_above(1.5));
  EXPECT_FALSE(above.eye_inside(kBox.lower, kBox.upper));
  EXPECT_TRUE(above.eye_inside(Vec3d(-1.0, -6.0, 0.0), Vec3d(1.0, 0.0, 2.0)));
}

/// Smallest and largest pixel of the box.
std::array<Eigen::Vector2d, 2> extent(const CameraView& view, const Bounds& box) {
  std::array<Eigen::Vector2d, 2> result{Eigen::Vector2d(1e9, 1e9), Eigen::Vector2d(-1e9, -1e9)};
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector2d pixel = view.project(box.corner(k)).head<2>();
    result[0] = result[0].cwiseMin(pixel);
    result[1] = result[1].cwiseMax(pixel);
  }
  return result;
}

TEST(DefaultCamera, ShowsTheWholeFootprintAndFillsThePicture) {
  for (const int dimension : {2, 3}) {
    for (const auto& [width, height] : {std::pair(1200, 500), std::pair(600, 300), std::pair(200, 700)}) {
      Scene scene = synthetic::tank_scene(0.02);
      scene.dimension = dimension;
      const CameraView view(default_camera(scene, 720, width, height), 720, width, height,
                            drawn_bounds(scene));
      Bounds box = framed_bounds(scene);
      if (dimension == 2) box.lower.y() = box.upper.y() = 0.0;
      const auto [lower, upper] = extent(view, box);
      EXPECT_GE(lower.minCoeff(), 0.0);
      EXPECT_LE(upper.x(), width);
      EXPECT_LE(upper.y(), height);
      const Eigen::Vector2d filled = (upper - lower).cwiseQuotient(Eigen::Vector2d(width, height));
      EXPECT_NEAR(filled.maxCoeff(), 0.94, 0.01);
    }
  }
}

TEST(DefaultCamera, ATallOpenDomainDoesNotShrinkTheView) {
  Scene scene = synthetic::tank_scene(0.02);
  const Camera low = default_camera(scene, 720, 1200, 500);
  scene.domain_max.z() = 5.0;
  const Camera high = default_camera(scene, 720, 1200, 500);
  EXPECT_TRUE(low.eye.isApprox(high.eye));
  EXPECT_NEAR(framed_bounds(scene).upper.z(), 0.25, 1e-12) << "the obstacle is the highest solid";
}

TEST(DefaultCamera, TwoDimensionalScenesAreSeenFromTheFront) {
  const Scene scene = synthetic::channel(0.02).scene;
  const CameraView view(default_camera(scene, 720, 1200, 500), 720, 1200, 500, drawn_bounds(scene));
  EXPECT_FALSE(view.perspective());
  const Vec3d left = view.project(Vec3d(0.0, 0.0, 0.0));
  EXPECT_GT(view.project(Vec3d(1.0, 0.0, 0.0)).x(), left.x());
  EXPECT_LT(view.project(Vec3d(0.0, 0.0, 0.1)).y(), left.y());
}

}  // namespace
}  // namespace eisph
