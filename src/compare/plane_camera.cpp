#include "compare/plane_camera.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace eisph {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;

constexpr int kHomographyNumbers = 8;
constexpr int kInversionSteps = 20;
constexpr double kLineTolerance = 1e-6;  ///< of the extent: how near a line points count as on it

/// Moves points to their centre and scales them to a mean distance of sqrt 2 from it.
Matrix3d normalisation(const std::vector<Vector2d>& points) {
  Vector2d centre = Vector2d::Zero();
  for (const Vector2d& point : points) centre += point;
  centre /= static_cast<double>(points.size());
  double distance = 0.0;
  for (const Vector2d& point : points) distance += (point - centre).norm();
  distance /= static_cast<double>(points.size());
  const double scale = std::sqrt(2.0) / distance;
  Matrix3d transform = Matrix3d::Identity();
  transform(0, 0) = transform(1, 1) = scale;
  transform(0, 2) = -scale * centre.x();
  transform(1, 2) = -scale * centre.y();
  return transform;
}

/// Direct linear transform on normalised coordinates.
Matrix3d linear_homography(const std::vector<Vector2d>& planes, const std::vector<Vector2d>& pixels) {
  const Matrix3d from = normalisation(planes);
  const Matrix3d to = normalisation(pixels);
  const auto rows = static_cast<Eigen::Index>(2 * planes.size());
  // At least nine rows, so that the decomposition has all nine directions.
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(rows, 9), 9);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const Eigen::Vector3d p = from * planes[k].homogeneous();
    const Eigen::Vector3d q = to * pixels[k].homogeneous();
    const auto row = static_cast<Eigen::Index>(2 * k);
    system.row(row) << p.transpose(), 0.0, 0.0, 0.0, -q.x() * p.transpose();
    system.row(row + 1) << 0.0, 0.0, 0.0, p.transpose(), -q.y() * p.transpose();
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(system, Eigen::ComputeFullV);
  const Eigen::VectorXd h = decomposition.matrixV().col(8);
  Matrix3d normalised;
  normalised << h(0), h(1), h(2), h(3), h(4), h(5), h(6), h(7), h(8);
  const Matrix3d homography = to.inverse() * normalised * from;
  return homography / homography(2, 2);
}

/// Distances in pixels as a function of the eight numbers of the transform, in units of a first guess, and of
/// the distortion.
struct PixelDistances {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const std::vector<ReferencePoint>* points;
  Matrix3d guess;
  Matrix3d to_guess;  ///< normalises pixels

  int width;
  int height;
  bool distorted;

  [[nodiscard]] PlaneCamera camera(const Eigen::VectorXd& x) const {
    Matrix3d change;
    change << 1.0 + x(0), x(1), x(2), x(3), 1.0 + x(4), x(5), x(6), x(7), 1.0;
    return {to_guess.inverse() * change * to_guess * guess, distorted ? x(kHomographyNumbers) : 0.0, width,
            height};
  }
  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& distances) const {
    const PlaneCamera candidate = camera(x);
    for (std::size_t k = 0; k < points->size(); ++k) {
      const Vector2d off = candidate.pixel_of((*points)[k].plane) - (*points)[k].pixel;
      distances.segment<2>(static_cast<Eigen::Index>(2 * k)) = off;
    }
    return 0;
  }
  [[nodiscard]] int inputs() const { return kHomographyNumbers + (distorted ? 1 : 0); }
  [[nodiscard]] int values() const { return static_cast<int>(2 * points->size()); }
};

PlaneCamera fitted_camera(const std::vector<ReferencePoint>& points, int width, int height, bool distorted) {
  std::vector<Vector2d> planes;
  std::vector<Vector2d> pixels;
  for (const ReferencePoint& point : points) {
    planes.push_back(point.plane);
    pixels.push_back(point.pixel);
  }
  PixelDistances distances{.points = &points,
                           .guess = linear_homography(planes, pixels),
                           .to_guess = normalisation(pixels),

                           .width = width,
                           .height = height,
                           .distorted = distorted};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(distances.inputs());
  if (distances.values() < distances.inputs()) return distances.camera(x);
  Eigen::NumericalDiff<PixelDistances, Eigen::Central> derivatives(distances);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<PixelDistances, Eigen::Central>> solver(derivatives);
  solver.parameters.maxfev = 2000;
  solver.parameters.xtol = 1e-14;
  solver.parameters.ftol = 1e-14;
  solver.minimize(x);
  return distances.camera(x);
}

/// Whether a line through two of the points has all others on it, or all but one.
bool all_but_one_on_a_line(const std::vector<Vector2d>& points) {
  double extent = 0.0;
  for (const Vector2d& a : points) {
    for (const Vector2d& b : points) extent = std::max(extent, (a - b).norm());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const Vector2d along = (points[j] - points[i]).normalized();
      const auto off = std::count_if(points.begin(), points.end(), [&](const Vector2d& point) {
        const Vector2d from = point - points[i];
        return std::abs(along.x() * from.y() - along.y() * from.x()) > kLineTolerance * extent;
      });
      if (off <= 1) return true;
    }
  }
  return false;
}

void check_distinct(const std::vector<ReferencePoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const bool same_plane = (points[i].plane - points[j].plane).norm() == 0.0;
      const bool same_pixel = (points[i].pixel - points[j].pixel).norm() == 0.0;
      if (!same_plane && !same_pixel) continue;
      throw InputError(fmt::format("reference points \"{}\" and \"{}\" have the same {}", points[i].name,
                                   points[j].name, same_plane ? "position" : "pixel"));
    }
  }
}

void check_points(const std::vector<ReferencePoint>& points, bool distorted) {
  const std::size_t fewest = distorted ? 5 : 4;
  if (points.size() < fewest) {
    throw InputError(fmt::format("{} reference points; at least {} are needed{}", points.size(), fewest,
                                 distorted ? " with radial distortion" : ""));
  }
  check_distinct(points);
  std::vector<Vector2d> planes;
  std::vector<Vector2d> pixels;
  for (const ReferencePoint& point : points) {
    planes.push_back(point.plane);
    pixels.push_back(point.pixel);
  }
  for (const bool on_floor : {true, false}) {
    if (!all_but_one_on_a_line(on_floor ? planes : pixels)) continue;
    throw InputError(
        fmt::format("the reference points lie on one line, or all but one do, {}; four of them have to be "
                    "such that no three lie on a line",
                    on_floor ? "on the floor" : "in the picture"));
  }
}

/// In a picture the y of the floor runs upwards and pixels count down, so that areas change their sign.
void check_orientation(const Registration& registration, const std::vector<ReferencePoint>& points) {
  const auto w_of = [&](const Vector2d& plane) {
    return (registration.camera.homography() * plane.homogeneous()).z();
  };
  const double w = w_of(points.front().plane);
  for (const ReferencePoint& point : points) {
    if (w_of(point.plane) * w > 0.0) continue;
    throw InputError("the reference points cannot all be in front of the camera: are two of them exchanged?");
  }
  if (registration.camera.homography().determinant() / (w * w * w) > 0.0) {
    throw InputError(
        "the reference points show the floor as in a mirror; pixels count to the right and down from the "
        "upper "
        "left corner");
  }
}

}  // namespace

PlaneCamera::PlaneCamera(const Matrix3d& homography, double k1, int width, int height)
    : homography_(homography),
      inverse_(homography.inverse()),
      centre_(0.5 * width, 0.5 * height),
      half_diagonal_(0.5 * std::hypot(width, height)),
      k1_(k1) {}

Vector2d PlaneCamera::pixel_of(const Vector2d& plane) const {
  Vector2d undistorted = (homography_ * plane.homogeneous()).eval().hnormalized();
  if (k1_ == 0.0) return undistorted;
  const Vector2d off = undistorted - centre_;
  const double r2 = off.squaredNorm() / (half_diagonal_ * half_diagonal_);
  return centre_ + off * (1.0 + k1_ * r2);
}

Vector2d PlaneCamera::plane_of(const Vector2d& pixel) const {
  Vector2d undistorted = pixel;
  if (k1_ != 0.0) {
    // r_d = r (1 + k1 r^2), by Newton's method from r = r_d.
    const Vector2d off = pixel - centre_;
    const double distorted = off.norm() / half_diagonal_;
    double r = distorted;
    for (int k = 0; k < kInversionSteps; ++k) {
      const double change = (r * (1.0 + k1_ * r * r) - distorted) / (1.0 + 3.0 * k1_ * r * r);
      r -= change;
      if (std::abs(change) < 1e-15) break;
    }
    if (distorted > 0.0) undistorted = centre_ + off * (r / distorted);
  }
  return (inverse_ * undistorted.homogeneous()).eval().hnormalized();
}

double PlaneCamera::pixel_length(const Vector2d& plane) const {
  const Vector2d pixel = pixel_of(plane);
  const Vector2d right = plane_of(pixel + Vector2d(0.5, 0.0)) - plane_of(pixel - Vector2d(0.5, 0.0));
  const Vector2d down = plane_of(pixel + Vector2d(0.0, 0.5)) - plane_of(pixel - Vector2d(0.0, 0.5));
  return std::sqrt(std::abs(right.x() * down.y() - right.y() * down.x()));
}

Registration register_points(const std::vector<ReferencePoint>& points, int width, int height,
                             bool radial_distortion) {
  check_points(points, radial_distortion);
  Registration registration;
  registration.camera = fitted_camera(points, width, height, radial_distortion);
  check_orientation(registration, points);
  double pixels = 0.0;
  double metres = 0.0;
  for (const ReferencePoint& point : points) {
    registration.residual_pixels.push_back((registration.camera.pixel_of(point.plane) - point.pixel).norm());
    registration.residual_metres.push_back((registration.camera.plane_of(point.pixel) - point.plane).norm());
    pixels += std::pow(registration.residual_pixels.back(), 2);
    metres += std::pow(registration.residual_metres.back(), 2);
  }
  registration.rms_pixels = std::sqrt(pixels / static_cast<double>(points.size()));
  registration.rms_metres = std::sqrt(metres / static_cast<double>(points.size()));
  return registration;
}

std::vector<Registration> perturbed_registrations(const std::vector<ReferencePoint>& points, int width,
                                                  int height, bool radial_distortion, double pick_error,
                                                  int repetitions, unsigned seed) {
  std::mt19937_64 random(seed);
  // Two uniform numbers make two normal ones (Box & Muller 1958): the library's distribution may differ
  // between implementations.
  const auto uniform = [&random] { return (static_cast<double>(random() >> 11U) + 0.5) * 0x1p-53; };
  std::vector<Registration> registrations;
  for (int k = 0; k < repetitions; ++k) {
    std::vector<ReferencePoint> moved = points;
    for (ReferencePoint& point : moved) {
      const double radius = pick_error * std::sqrt(-2.0 * std::log(uniform()));
      const double angle = 2.0 * M_PI * uniform();
      point.pixel += radius * Vector2d(std::cos(angle), std::sin(angle));
    }
    registrations.push_back(register_points(moved, width, height, radial_distortion));
  }
  return registrations;
}

}  // namespace eisph
