#include "probe/surface_elements.hpp"

#include "probe/hand_made.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kPi = std::numbers::pi;

struct Sums {
  double area = 0.0;
  Vec3d closed = Vec3d::Zero();  ///< sum of n dA, zero for a closed surface
  double volume = 0.0;           ///< by the divergence theorem
};

Sums sums_of(const std::vector<SurfaceElement>& elements, int dimension) {
  Sums sums;
  for (const SurfaceElement& element : elements) {
    EXPECT_NEAR(element.normal.norm(), 1.0, 1e-12);
    sums.area += element.area;
    sums.closed += element.area * element.normal;
    sums.volume += element.area * element.point.dot(element.normal) / dimension;
  }
  return sums;
}

Shape round_shape(ShapeKind kind, double radius, double height) {
  Shape shape;
  shape.kind = kind;
  shape.centre = Vec3d(0.3, 0.2, 0.4);
  shape.radius = radius;
  shape.height = height;
  return shape;
}

TEST(SurfaceElements, OfATurnedBoxCloseAndHaveItsAreaAndVolume) {
  const Shape shape = box(Vec3d(0.1, 0.2, 0.3), Vec3d(0.4, 0.3, 0.5), 0.6);
  const Sums sums = sums_of(surface_elements(shape, 0.03, 3), 3);
  EXPECT_NEAR(sums.area, 2.0 * (0.3 * 0.1 + 0.3 * 0.2 + 0.1 * 0.2), 1e-12);
  EXPECT_NEAR(sums.closed.norm(), 0.0, 1e-12);
  EXPECT_NEAR(sums.volume, 0.3 * 0.1 * 0.2, 1e-12);
  for (const SurfaceElement& element : surface_elements(shape, 0.03, 3)) {
    EXPECT_NEAR(shape.signed_distance(element.point, 3), 0.0, 1e-12);
    EXPECT_LE(element.area, 0.03 * 0.03 + 1e-12);
  }
}

TEST(SurfaceElements, OfACylinderAndASphereCloseAndHaveTheirAreaAndVolume) {
  const Sums cylinder = sums_of(surface_elements(round_shape(ShapeKind::Cylinder, 0.1, 0.3), 0.02, 3), 3);
  EXPECT_NEAR(cylinder.area, 2.0 * kPi * 0.1 * (0.1 + 0.3), 1e-12);
  EXPECT_NEAR(cylinder.closed.norm(), 0.0, 1e-12);
  EXPECT_NEAR(cylinder.volume, kPi * 0.01 * 0.3, 1e-6);
  const Sums sphere = sums_of(surface_elements(round_shape(ShapeKind::Sphere, 0.1, 0.0), 0.02, 3), 3);
  EXPECT_NEAR(sphere.area, 4.0 * kPi * 0.01, 1e-12);
  EXPECT_NEAR(sphere.closed.norm(), 0.0, 1e-12);
  EXPECT_NEAR(sphere.volume, 4.0 / 3.0 * kPi * 0.001, 1e-12);
}

TEST(SurfaceElements, AreOutlinesInTwoDimensions) {
  const Sums outline = sums_of(surface_elements(box(Vec3d(0.1, 0.0, 0.3), Vec3d(0.4, 0.0, 0.5)), 0.03, 2), 2);
  EXPECT_NEAR(outline.area, 1.0, 1e-12);
  EXPECT_NEAR(outline.volume, 0.06, 1e-12);
  const Sums disc = sums_of(surface_elements(round_shape(ShapeKind::Sphere, 0.1, 0.0), 0.02, 2), 2);
  EXPECT_NEAR(disc.area, 2.0 * kPi * 0.1, 1e-12);
  EXPECT_NEAR(disc.volume, kPi * 0.01, 1e-12);
}

TEST(SurfaceElements, OfFlatSensorsLieInTheirPlaneAboutTheCentre) {
  const Vec3d centre(0.1, 0.2, 0.3);
  for (const Vec3d& normal : {Vec3d(1.0, 0.0, 0.0), Vec3d(0.0, 0.0, 1.0), Vec3d(0.6, 0.8, 0.0)}) {
    Vec3d middle = Vec3d::Zero();
    double disc = 0.0;
    for (const SurfaceElement& element : disc_elements(centre, normal, 0.1, 0.01, 3)) {
      EXPECT_NEAR((element.point - centre).dot(normal), 0.0, 1e-12);
      EXPECT_LT((element.point - centre).norm(), 0.05);
      middle += element.area * (element.point - centre);
      disc += element.area;
    }
    EXPECT_NEAR(disc, kPi * 0.0025, 1e-12);
    EXPECT_NEAR(middle.norm(), 0.0, 1e-12);
    EXPECT_NEAR(sums_of(square_elements(centre, normal, 0.1, 0.01, 3), 3).area, 0.01, 1e-12);
  }
  EXPECT_EQ(disc_elements(centre, Vec3d::UnitX(), 0.1, 0.0201, 2).size(), 5U);
  EXPECT_EQ(disc_elements(centre, Vec3d::UnitX(), 0.0, 0.02, 3).size(), 1U);
}

}  // namespace
}  // namespace eisph
