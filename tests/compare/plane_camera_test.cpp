#include "compare/plane_camera.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

constexpr int kWidth = 1000;
constexpr int kHeight = 800;

/// A floor of 1.8 x 1.2 m seen from above at an angle, y upwards in the picture.
PlaneCamera tilted(double k1) {
  Eigen::Matrix3d homography;
  homography << 520.0, 12.0, 40.0, -9.0, -530.0, 720.0, 0.02, -0.05, 1.0;
  return {homography, k1, kWidth, kHeight};
}

std::vector<ReferencePoint> seen_by(const PlaneCamera& camera, const std::vector<Vector2d>& planes) {
  std::vector<ReferencePoint> points;
  for (const Vector2d& plane : planes)
    points.push_back({fmt::format("p{}", points.size()), plane, camera.pixel_of(plane)});
  return points;
}

const std::vector<Vector2d> kCorners = {{0.0, 0.0}, {1.8, 0.0}, {1.8, 1.2}, {0.0, 1.2}};
const std::vector<Vector2d> kMore = {{0.0, 0.0}, {1.8, 0.0}, {1.8, 1.2}, {0.0, 1.2},
                                     {0.6, 0.4}, {0.9, 0.4}, {0.9, 0.8}, {0.6, 0.8}};

std::string refusal(const std::vector<ReferencePoint>& points, bool distortion = false) {
  return error_of<InputError>([&] { (void)register_points(points, kWidth, kHeight, distortion); });
}

TEST(PlaneCamera, GoesThereAndBack) {
  for (const double k1 : {0.0, -0.08, 0.05}) {
    const PlaneCamera camera = tilted(k1);
    for (const Vector2d& plane : kMore)
      EXPECT_LT((camera.plane_of(camera.pixel_of(plane)) - plane).norm(), 1e-12);
  }
}

TEST(PlaneCamera, PixelLengthIsThatOfAPlainScale) {
  const Eigen::Matrix3d scale = Eigen::Vector3d(500.0, -500.0, 1.0).asDiagonal();
  EXPECT_NEAR(PlaneCamera(scale, 0.0, kWidth, kHeight).pixel_length({0.3, 0.2}), 0.002, 1e-12);
}

TEST(RegisterPoints, FourCornersDetermineTheTransform) {
  const PlaneCamera camera = tilted(0.0);
  const Registration found = register_points(seen_by(camera, kCorners), kWidth, kHeight, false);
  EXPECT_LT(found.rms_pixels, 1e-9);
  EXPECT_LT((found.camera.pixel_of({0.7, 0.3}) - camera.pixel_of({0.7, 0.3})).norm(), 1e-9);
}

TEST(RegisterPoints, MorePointsDetermineTheDistortionToo) {
  const PlaneCamera camera = tilted(-0.07);
  const Registration found = register_points(seen_by(camera, kMore), kWidth, kHeight, true);
  EXPECT_NEAR(found.camera.k1(), -0.07, 1e-9);
  EXPECT_LT(found.rms_pixels, 1e-8);
  EXPECT_LT((found.camera.plane_of({300.0, 500.0}) - camera.plane_of({300.0, 500.0})).norm(), 1e-10);
}

TEST(RegisterPoints, WithoutDistortionItsTracesAreInTheResiduals) {
  const Registration found = register_points(seen_by(tilted(-0.07), kMore), kWidth, kHeight, false);
  EXPECT_GT(found.rms_pixels, 1.0);
  EXPECT_LT(found.rms_pixels, 20.0);
  // A pixel is about 1.9 mm.
  EXPECT_NEAR(found.rms_metres / found.rms_pixels, 1.9e-3, 0.4e-3);
}

TEST(RegisterPoints, LeastSquaresOfPixelsBeatAnyNeighbour) {
  std::vector<ReferencePoint> points = seen_by(tilted(0.0), kMore);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k].pixel +=
        Vector2d(std::cos(7.0 * static_cast<double>(k)), std::sin(11.0 * static_cast<double>(k)));
  const Registration best = register_points(points, kWidth, kHeight, false);
  const auto squares = [&](const Eigen::Matrix3d& homography) {
    const PlaneCamera camera(homography, 0.0, kWidth, kHeight);
    double sum = 0.0;
    for (const ReferencePoint& point : points)
      sum += (camera.pixel_of(point.plane) - point.pixel).squaredNorm();
    return sum;
  };
  const double least = squares(best.camera.homography());
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      for (const double sign : {-1.0, 1.0}) {
        Eigen::Matrix3d changed = best.camera.homography();
        changed(row, column) += sign * 1e-4 * std::max(1.0, std::abs(changed(row, column)));
        EXPECT_GE(squares(changed), least - 1e-9);
      }
    }
  }
}

TEST(RegisterPoints, RefusesPointsThatDetermineNothing) {
  const PlaneCamera camera = tilted(0.0);
  EXPECT_THAT(refusal(seen_by(camera, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}})), HasSubstr("at least 4"));
  EXPECT_THAT(refusal(seen_by(camera, kCorners), true), HasSubstr("at least 5"));
  EXPECT_THAT(refusal(seen_by(camera, {{0.0, 0.0}, {0.5, 0.0}, {1.0, 0.0}, {0.3, 1.0}})),
              HasSubstr("lie on one line"));
  std::vector<ReferencePoint> twice = seen_by(camera, kCorners);
  twice[3].plane = twice[1].plane;
  EXPECT_THAT(refusal(twice), testing::AllOf(HasSubstr("\"p1\" and \"p3\""), HasSubstr("same position")));
}

TEST(RegisterPoints, RefusesAMirrorImageAndExchangedPoints) {
  std::vector<ReferencePoint> points = seen_by(tilted(0.0), kCorners);
  for (ReferencePoint& point : points) point.pixel.y() = kHeight - point.pixel.y();
  EXPECT_THAT(refusal(points), HasSubstr("mirror"));
  points = seen_by(tilted(0.0), kCorners);
  std::swap(points[0].pixel, points[1].pixel);
  EXPECT_THAT(refusal(points), HasSubstr("exchanged"));
}

TEST(PerturbedRegistrations, ScatterAsMuchAsThePickErrorSays) {
  const PlaneCamera camera = tilted(0.0);
  const auto points = seen_by(camera, kCorners);
  const auto registrations = perturbed_registrations(points, kWidth, kHeight, false, 1.0, 400, 3);
  ASSERT_EQ(registrations.size(), 400U);
  double squares = 0.0;
  for (const Registration& one : registrations)
    squares += (one.camera.pixel_of(points[0].plane) - points[0].pixel).squaredNorm();
  EXPECT_NEAR(std::sqrt(squares / 400.0), std::sqrt(2.0), 0.1);
  const auto again = perturbed_registrations(points, kWidth, kHeight, false, 1.0, 400, 3);
  EXPECT_EQ(again[17].camera.homography(), registrations[17].camera.homography());
  const auto other = perturbed_registrations(points, kWidth, kHeight, false, 1.0, 1, 4);
  EXPECT_NE(other[0].camera.homography(), registrations[0].camera.homography());
}

}  // namespace
}  // namespace eisph
