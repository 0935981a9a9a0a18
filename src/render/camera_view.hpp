#pragma once

#include "core/scene.hpp"

#include <Eigen/Core>

namespace eisph {

/// Axis-aligned box, m.
struct Bounds {
  Vec3d lower = Vec3d::Zero();
  Vec3d upper = Vec3d::Zero();

  /// Corner 0 to 7: bit 0 chooses x, bit 1 y, bit 2 z.
  [[nodiscard]] Vec3d corner(int k) const {
    return {(k & 1) != 0 ? upper.x() : lower.x(), (k & 2) != 0 ? upper.y() : lower.y(),
            (k & 4) != 0 ? upper.z() : lower.z()};
  }
};

/// A camera seen through a picture of a given size: the rectangle of the frame in which the scene is drawn.
/// The target lies at the centre of the picture. The scale is that of the whole frame, so that field of view
/// and orthographic height mean what the scene file says whatever the captions take.
class CameraView {
 public:
  /// Sizes in pixels; `visible` is what must not be cut off in depth. Throws InputError for a camera that
  /// looks nowhere.
  CameraView(const Camera& camera, int frame_height, int picture_width, int picture_height,
             const Bounds& visible);

  [[nodiscard]] const Eigen::Matrix4f& view() const { return view_; }
  [[nodiscard]] const Eigen::Matrix4f& projection() const { return projection_; }
  [[nodiscard]] bool perspective() const { return perspective_; }
  /// Pixels per metre across the view, at the distance of the target.
  [[nodiscard]] double pixels_per_metre() const { return pixels_per_metre_; }
  /// Pixels per metre at unit distance (perspective), or everywhere.
  [[nodiscard]] double focal_length() const { return focal_length_; }
  /// Pixel position in the picture (x right, y down, from its upper left corner) and distance along the view
  /// axis in metres, which is negative behind the eye.
  [[nodiscard]] Vec3d project(const Vec3d& point) const;
  /// Whether a horizontal plane at `height` (m) shows its upper side, or its edge.
  [[nodiscard]] bool looks_from_above(double height) const;
  /// Whether a perspective view is from inside the box.
  [[nodiscard]] bool eye_inside(const Vec3d& lower, const Vec3d& upper) const;

 private:
  bool perspective_ = true;
  double focal_length_ = 0.0;
  double pixels_per_metre_ = 0.0;
  Vec3d picture_ = Vec3d::Zero();  ///< half size, pixels
  Vec3d eye_ = Vec3d::Zero();
  Eigen::Matrix4d exact_view_;
  Eigen::Matrix4f view_;
  Eigen::Matrix4f projection_;
};

/// What a picture of the scene should show: the footprint of the domain, up to one and a half reference
/// depths or the highest solid or water, whichever is more, but not above the domain.
[[nodiscard]] Bounds framed_bounds(const Scene& scene);
/// The domain and all solids: nothing beyond is drawn.
[[nodiscard]] Bounds drawn_bounds(const Scene& scene);
/// Camera that shows framed_bounds from the direction of `towards_eye`, with `up` upwards in the picture.
[[nodiscard]] Camera fitted_camera(const Scene& scene, const Vec3d& towards_eye, const Vec3d& up,
                                   Projection projection, int frame_height, int picture_width,
                                   int picture_height);
/// Camera that shows framed_bounds: from the front, side and above, or the front for two dimensions.
[[nodiscard]] Camera default_camera(const Scene& scene, int frame_height, int picture_width,
                                    int picture_height);

}  // namespace eisph
