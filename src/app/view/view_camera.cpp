#include "app/view/view_camera.hpp"

#include "render/camera_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace eisph {

namespace {

constexpr double kSteepest = 89.0;
constexpr double kRadians = std::numbers::pi / 180.0;

double half_height_per_distance(const Camera& camera) {
  return std::tan(0.5 * camera.field_of_view * kRadians);
}

}  // namespace

void orbit(Camera& camera, double azimuth, double elevation) {
  const Vec3d back = camera.eye - camera.target;
  const double distance = back.norm();
  if (!(distance > 0.0)) return;
  // Straight from above the direction of the eye says nothing; what is up on the screen does.
  const bool upright = back.head<2>().norm() > 1e-6 * distance;
  const double turned = upright ? std::atan2(back.y(), back.x()) : std::atan2(-camera.up.y(), -camera.up.x());
  const double raised = std::asin(std::clamp(back.z() / distance, -1.0, 1.0));
  const double to = turned + azimuth * kRadians;
  const double above = std::clamp(raised + elevation * kRadians, -kSteepest * kRadians, kSteepest * kRadians);
  camera.eye = camera.target + distance * Vec3d(std::cos(above) * std::cos(to),
                                                std::cos(above) * std::sin(to), std::sin(above));
  camera.up = Vec3d::UnitZ();
}

void pan(Camera& camera, double right, double up, double pixels_per_metre) {
  const Vec3d forward = (camera.target - camera.eye).normalized();
  const Vec3d across = forward.cross(camera.up).normalized();
  const Vec3d move = (right * across + up * across.cross(forward)) / pixels_per_metre;
  camera.eye += move;
  camera.target += move;
}

void zoom(Camera& camera, double factor) {
  camera.eye = camera.target + factor * (camera.eye - camera.target);
  camera.orthographic_height *= factor;
}

void set_projection(Camera& camera, Projection projection) {
  if (camera.projection == projection) return;
  camera.projection = projection;
  const Vec3d back = camera.eye - camera.target;
  if (projection == Projection::Orthographic) {
    camera.orthographic_height = 2.0 * back.norm() * half_height_per_distance(camera);
  } else {
    const double distance = 0.5 * camera.orthographic_height / half_height_per_distance(camera);
    camera.eye = camera.target + distance * back.normalized();
  }
}

const char* preset_name(PresetView view) {
  switch (view) {
    case PresetView::Oblique:
      return "oblique";
    case PresetView::Front:
      return "front";
    case PresetView::Side:
      return "side";
    case PresetView::Top:
      return "top";
    case PresetView::AlongFlow:
      return "along flow";
  }
  return "";
}

Camera preset_camera(const Scene& scene, PresetView view, Projection projection, int frame_height,
                     int picture_width, int picture_height) {
  Vec3d towards_eye(0.42, -1.0, 0.78);
  Vec3d up = Vec3d::UnitZ();
  switch (view) {
    case PresetView::Oblique:
      break;
    case PresetView::Front:
      towards_eye = -Vec3d::UnitY();
      break;
    case PresetView::Side:
      towards_eye = Vec3d::UnitX();
      break;
    case PresetView::Top:
      towards_eye = Vec3d::UnitZ();
      up = Vec3d::UnitY();
      break;
    case PresetView::AlongFlow:
      towards_eye = Vec3d(-1.0, 0.0, 0.55);
      break;
  }
  return fitted_camera(scene, towards_eye, up, projection, frame_height, picture_width, picture_height);
}

}  // namespace eisph
