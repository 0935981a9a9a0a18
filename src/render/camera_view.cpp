#include "render/camera_view.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace eisph {

namespace {

/// Part of the picture's width and height that the default camera fills.
constexpr double kFilling = 0.94;

Eigen::Matrix4d look_at(const Camera& camera) {
  const Vec3d backward = camera.eye - camera.target;
  const Vec3d right = camera.up.cross(backward);
  if (!(backward.norm() > 0.0) || !(right.norm() > 1e-9 * camera.up.norm() * backward.norm())) {
    throw InputError(fmt::format(
        "camera: eye ({}, {}, {}) and target ({}, {}, {}) must differ, and up ({}, {}, {}) must not lie "
        "along the line between them",
        camera.eye.x(), camera.eye.y(), camera.eye.z(), camera.target.x(), camera.target.y(),
        camera.target.z(), camera.up.x(), camera.up.y(), camera.up.z()));
  }
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.block<1, 3>(0, 0) = right.normalized().transpose();
  view.block<1, 3>(1, 0) = backward.cross(right).normalized().transpose();
  view.block<1, 3>(2, 0) = backward.normalized().transpose();
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * camera.eye;
  return view;
}

double focal_length_of(const Camera& camera, int frame_height) {
  if (camera.projection == Projection::Orthographic) {
    if (!(camera.orthographic_height > 0.0)) {
      throw InputError(fmt::format("camera: orthographic_height = {}: a length above 0 m is expected",
                                   camera.orthographic_height));
    }
    return frame_height / camera.orthographic_height;
  }
  if (!(camera.field_of_view > 0.0 && camera.field_of_view < 180.0)) {
    throw InputError(fmt::format("camera: field_of_view = {}: an angle between 0 and 180 degrees is expected",
                                 camera.field_of_view));
  }
  return 0.5 * frame_height / std::tan(0.5 * camera.field_of_view * std::numbers::pi / 180.0);
}

/// Extent of the box in the picture, pixels from the picture's centre: (x0, y0) to (x1, y1), y upwards.
Eigen::Vector4d extent_in_picture(const Camera& camera, const Bounds& box, double focal_length) {
  const Eigen::Matrix4d view = look_at(camera);
  Eigen::Vector4d extent(1e300, 1e300, -1e300, -1e300);
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector4d eye = view * box.corner(k).homogeneous();
    const double scale =
        camera.projection == Projection::Perspective ? focal_length / -eye.z() : focal_length;
    extent.head<2>() = extent.head<2>().cwiseMin(scale * eye.head<2>());
    extent.tail<2>() = extent.tail<2>().cwiseMax(scale * eye.head<2>());
  }
  return extent;
}

Camera front_camera(const Bounds& box, int frame_height, int picture_width, int picture_height) {
  const Vec3d size = box.upper - box.lower;
  const double metres_per_pixel = std::max(size.x() / picture_width, size.z() / picture_height) / kFilling;
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.orthographic_height = metres_per_pixel * frame_height;
  camera.target = 0.5 * (box.lower + box.upper);
  camera.target.y() = 0.0;
  camera.eye = camera.target - Vec3d::UnitY() * std::max(size.x(), size.z());
  return camera;
}

}  // namespace

CameraView::CameraView(const Camera& camera, int frame_height, int picture_width, int picture_height,
                       const Bounds& visible)
    : perspective_(camera.projection == Projection::Perspective),
      focal_length_(focal_length_of(camera, frame_height)),
      picture_(0.5 * picture_width, 0.5 * picture_height, 0.0),
      eye_(camera.eye),
      exact_view_(look_at(camera)) {
  const double distance = (camera.eye - camera.target).norm();
  pixels_per_metre_ = perspective_ ? focal_length_ / distance : focal_length_;
  double near = std::numeric_limits<double>::max();
  double far = std::numeric_limits<double>::lowest();
  for (int k = 0; k < 8; ++k) {
    const double depth = -(exact_view_ * visible.corner(k).homogeneous()).z();
    near = std::min(near, depth);
    far = std::max(far, depth);
  }
  const double slack = 0.05 * (far - near) + 1e-6 * distance;
  near -= slack;
  far += slack;
  if (perspective_) {
    far = std::max(far, 0.02 * distance);
    near = std::max(near, 0.002 * far);
  }
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = focal_length_ / picture_.x();
  projection(1, 1) = focal_length_ / picture_.y();
  if (perspective_) {
    projection(2, 2) = -(far + near) / (far - near);
    projection(2, 3) = -2.0 * far * near / (far - near);
    projection(3, 2) = -1.0;
  } else {
    projection(2, 2) = -2.0 / (far - near);
    projection(2, 3) = -(far + near) / (far - near);
    projection(3, 3) = 1.0;
  }
  view_ = exact_view_.cast<float>();
  projection_ = projection.cast<float>();
}

Vec3d CameraView::project(const Vec3d& point) const {
  const Eigen::Vector4d eye = exact_view_ * point.homogeneous();
  const double scale = perspective_ ? focal_length_ / -eye.z() : focal_length_;
  return {picture_.x() + scale * eye.x(), picture_.y() - scale * eye.y(), -eye.z()};
}

bool CameraView::looks_from_above(double height) const {
  return perspective_ ? eye_.z() >= height : exact_view_(2, 2) >= 0.0;
}

bool CameraView::eye_inside(const Vec3d& lower, const Vec3d& upper) const {
  return perspective_ && (eye_.array() >= lower.array()).all() && (eye_.array() <= upper.array()).all();
}

Bounds framed_bounds(const Scene& scene) {
  double top = scene.domain_min.z() + 1.5 * scene.reference_depth;
  const auto include = [&](const Shape& shape) {
    Vec3d lower;
    Vec3d upper;
    shape.bounds(lower, upper);
    top = std::max(top, upper.z());
  };
  for (const Obstacle& obstacle : scene.obstacles) include(obstacle.shape);
  for (const Gate& gate : scene.gates) include(gate.shape);
  for (const FluidRegion& region : scene.fluid) {
    if (!region.cut) include(region.shape);
  }
  Bounds box{scene.domain_min, scene.domain_max};
  box.upper.z() = std::min(top, scene.domain_max.z());
  return box;
}

Bounds drawn_bounds(const Scene& scene) {
  Bounds box{scene.domain_min, scene.domain_max};
  const auto include = [&](const Shape& shape, double stroke) {
    Vec3d lower;
    Vec3d upper;
    shape.bounds(lower, upper);
    upper.z() += stroke;
    box.lower = box.lower.cwiseMin(lower);
    box.upper = box.upper.cwiseMax(upper);
  };
  for (const Obstacle& obstacle : scene.obstacles) include(obstacle.shape, 0.0);
  for (const Gate& gate : scene.gates) include(gate.shape, gate.stroke);
  // Particles reach beyond their centres, and a two-dimensional scene has no extent in y of its own.
  const double reach = 2.0 * scene.particle_spacing;
  return {box.lower.array() - reach, box.upper.array() + reach};
}

Camera fitted_camera(const Scene& scene, const Vec3d& towards_eye, const Vec3d& up, Projection projection,
                     int frame_height, int picture_width, int picture_height) {
  const Bounds box = framed_bounds(scene);
  Camera camera;
  camera.field_of_view = 28.0;
  camera.up = up;
  const Vec3d direction = towards_eye.normalized();
  const double focal_length = focal_length_of(camera, frame_height);
  double distance = 2.0 * (box.upper - box.lower).norm();
  camera.target = 0.5 * (box.lower + box.upper);
  if (projection == Projection::Orthographic) {
    camera.projection = projection;
    camera.eye = camera.target + distance * direction;
    const Eigen::Vector4d extent = extent_in_picture(camera, box, 1.0);
    camera.orthographic_height =
        frame_height * std::max((extent[2] - extent[0]) / (kFilling * picture_width),
                                (extent[3] - extent[1]) / (kFilling * picture_height));
    return camera;
  }
  // Each round centres the box and takes the distance at which it would fill the picture.
  for (int round = 0; round < 30; ++round) {
    camera.eye = camera.target + distance * direction;
    const Eigen::Vector4d extent = extent_in_picture(camera, box, focal_length);
    const Eigen::Vector2d centre = 0.5 * (extent.head<2>() + extent.tail<2>()) * distance / focal_length;
    const Eigen::Matrix4d view = look_at(camera);
    camera.target +=
        centre.x() * view.block<1, 3>(0, 0).transpose() + centre.y() * view.block<1, 3>(1, 0).transpose();
    distance *= std::max((extent[2] - extent[0]) / (kFilling * picture_width),
                         (extent[3] - extent[1]) / (kFilling * picture_height));
  }
  camera.eye = camera.target + distance * direction;
  return camera;
}

Camera default_camera(const Scene& scene, int frame_height, int picture_width, int picture_height) {
  if (scene.dimension == 2)
    return front_camera(framed_bounds(scene), frame_height, picture_width, picture_height);
  return fitted_camera(scene, Vec3d(0.42, -1.0, 0.78), Vec3d::UnitZ(), Projection::Perspective, frame_height,
                       picture_width, picture_height);
}

}  // namespace eisph
