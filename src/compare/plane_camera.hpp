#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace eisph {

/// View of the floor of a tank by a pinhole camera whose lens may distort: a projective transform from the
/// floor to the picture, then a radial distortion about the centre of the picture,
/// u_d = c + (u - c) (1 + k1 r^2), with r the distance from the centre over half the picture's diagonal.
/// Positions on the floor are (x, y) in metres; pixels count to the right and down from the upper left
/// corner.
class PlaneCamera {
 public:
  PlaneCamera() = default;
  /// `homography` takes (x, y, 1) to undistorted pixels (times a factor).
  PlaneCamera(const Eigen::Matrix3d& homography, double k1, int width, int height);

  [[nodiscard]] Eigen::Vector2d pixel_of(const Eigen::Vector2d& plane) const;
  [[nodiscard]] Eigen::Vector2d plane_of(const Eigen::Vector2d& pixel) const;
  /// Length on the floor of one pixel about a point of it, m: the root of the area that a pixel covers.
  [[nodiscard]] double pixel_length(const Eigen::Vector2d& plane) const;

  [[nodiscard]] const Eigen::Matrix3d& homography() const { return homography_; }
  [[nodiscard]] double k1() const { return k1_; }

 private:
  Eigen::Matrix3d homography_ = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Identity();
  Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();  ///< pixels
  double half_diagonal_ = 1.0;                        ///< pixels
  double k1_ = 0.0;
};

/// A point of the floor and where it is seen.
struct ReferencePoint {
  std::string name;
  Eigen::Vector2d plane = Eigen::Vector2d::Zero();  ///< m
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

struct Registration {
  PlaneCamera camera;
  std::vector<double> residual_pixels;  ///< by point: distance of the fitted from the given pixel
  std::vector<double> residual_metres;  ///< by point: the same on the floor
  double rms_pixels = 0.0;
  double rms_metres = 0.0;
};

/// Camera with the least squares of the distances in pixels. Throws InputError for fewer than four points
/// (five with distortion), points that coincide, points that lie on one line but one or fewer, and a picture
/// that shows the floor as in a mirror.
[[nodiscard]] Registration register_points(const std::vector<ReferencePoint>& points, int width, int height,
                                           bool radial_distortion);

/// Registrations of the same points, each moved by normal deviates of `pick_error` (pixels) in both
/// directions: how well the registration can be repeated. Reproducible by the seed.
[[nodiscard]] std::vector<Registration> perturbed_registrations(const std::vector<ReferencePoint>& points,
                                                                int width, int height, bool radial_distortion,
                                                                double pick_error, int repetitions,
                                                                unsigned seed);

}  // namespace eisph
