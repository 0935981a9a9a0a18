#include "boundary/solid_sides.hpp"

#include "boundary/tank_scene.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kSpacing = 0.02;

SolidSides sides_of(const std::vector<Shape>& shapes, int dimension = 3) {
  SolidSides sides(tank_scene(dimension));
  sides.place({shapes.begin(), shapes.end()});
  return sides;
}

void expect_normal(const SolidSide& side, const Vec3d& expected) {
  EXPECT_NEAR((side.normal - expected.normalized()).norm(), 0.0, 1e-6) << side.normal.transpose();
}

/// A thick block in the middle of the tank, off its floor.
Shape block() { return box(Vec3d(0.7, 0.0, 0.2), Vec3d(1.0, 0.2, 0.4)); }

TEST(SolidSides, FaceAwayFromTheNearestFace) {
  const SolidSides sides = sides_of({block()});
  const auto of = [&](const Vec3d& point) {
    const auto found = sides.of(0, point);
    EXPECT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].across.isZero());
    return found[0];
  };
  expect_normal(of(Vec3d(0.71, 0.1, 0.3)), Vec3d(-1.0, 0.0, 0.0));
  expect_normal(of(Vec3d(0.85, 0.1, 0.37)), Vec3d(0.0, 0.0, 1.0));
  expect_normal(of(Vec3d(0.85, 0.03, 0.35)), Vec3d(0.0, -1.0, 0.0));
  // Equally near two and three faces: an edge and a corner.
  expect_normal(of(Vec3d(0.71, 0.1, 0.39)), Vec3d(-1.0, 0.0, 1.0));
  expect_normal(of(Vec3d(0.99, 0.19, 0.21)), Vec3d(1.0, 1.0, -1.0));
}

TEST(SolidSides, OfATurnedBoxAreTurned) {
  const double angle = std::numbers::pi / 6.0;
  const SolidSides sides = sides_of({box(Vec3d(0.7, 0.0, 0.2), Vec3d(1.0, 0.2, 0.4), angle)});
  const Vec3d outward(std::cos(angle), std::sin(angle), 0.0);
  const auto found = sides.of(0, Vec3d(0.85, 0.1, 0.3) + (0.15 - 0.01) * outward);
  ASSERT_EQ(found.size(), 1U);
  expect_normal(found[0], outward);
}

TEST(SolidSides, OfRoundSolidsAreRadial) {
  const SolidSides sides = sides_of({cylinder(Vec3d(0.9, 0.1, 0.1), 0.1, 0.3)});
  for (int k = 0; k < 8; ++k) {
    const Vec3d radial(std::cos(0.8 * k), std::sin(0.8 * k), 0.0);
    const auto found = sides.of(0, Vec3d(0.9, 0.1, 0.2) + 0.09 * radial);
    ASSERT_EQ(found.size(), 1U);
    expect_normal(found[0], radial);
  }
}

TEST(SolidSides, DoNotCountFacesOnAWallOrOnAnotherSolid) {
  // On the floor of the tank, and with a neighbour against its upper x face.
  const Shape standing = box(Vec3d(0.7, 0.0, 0.1), Vec3d(1.0, 0.2, 0.4));
  const SolidSides sides = sides_of({standing, box(Vec3d(1.0, -0.2, 0.1), Vec3d(1.2, 0.4, 0.4))});
  expect_normal(sides.of(0, Vec3d(0.73, 0.1, 0.11))[0], Vec3d(-1.0, 0.0, 0.0));
  expect_normal(sides.of(0, Vec3d(0.99, 0.1, 0.37))[0], Vec3d(0.0, 0.0, 1.0));
  // In the floor below a block: what continues the surface of the floor.
  const Shape floor = box(Vec3d(0.4, -0.2, 0.1), Vec3d(1.4, 0.4, 0.2));
  const SolidSides on_floor = sides_of({floor, block()});
  expect_normal(on_floor.of(0, Vec3d(0.85, 0.1, 0.17))[0], Vec3d(0.0, 0.0, 1.0));
}

TEST(SolidSides, OfAThinWallAreTwoEachSeenFromItsOwn) {
  const Shape wall = box(Vec3d(0.8, -0.2, 0.1), Vec3d(0.86, 0.4, 0.4));  // three spacings
  const SolidSides sides = sides_of({wall});
  for (const double depth : {0.01, 0.03, 0.05}) {
    const Vec3d particle(0.8 + depth, 0.1, 0.25);
    const auto found = sides.of(0, particle);
    ASSERT_EQ(found.size(), 2U) << depth;
    for (const SolidSide& side : found) {
      const Vec3d water(side.normal.x() < 0.0 ? 0.79 : 0.87, 0.1, 0.25);
      const Vec3d behind(side.normal.x() < 0.0 ? 0.87 : 0.79, 0.1, 0.25);
      EXPECT_NEAR(std::abs(side.normal.x()), 1.0, 1e-9);
      EXPECT_GT(side.across.dot(water - particle), side.middle);
      EXPECT_LT(side.across.dot(behind - particle), side.middle);
    }
    EXPECT_NEAR((found[0].normal + found[1].normal).norm(), 0.0, 1e-9);
  }
  // On its crest both sides face upwards and yet belong to the two halves.
  const auto crest = sides.of(0, Vec3d(0.83, 0.1, 0.39));
  ASSERT_EQ(crest.size(), 2U);
  for (const SolidSide& side : crest) {
    expect_normal(side, Vec3d(0.0, 0.0, 1.0));
    EXPECT_NEAR(std::abs(side.across.x()), 1.0, 1e-9);
  }
}

TEST(SolidSides, OfAThickWallAreOne) {
  const SolidSides sides = sides_of({box(Vec3d(0.8, -0.2, 0.1), Vec3d(0.8 + 6.0 * kSpacing, 0.4, 0.4))});
  for (int layer = 0; layer < 6; ++layer) {
    EXPECT_EQ(sides.of(0, Vec3d(0.8 + (layer + 0.5) * kSpacing, 0.1, 0.2)).size(), 1U) << layer;
  }
}

TEST(SolidSides, OfAThinWallAgainstTheTankAreOne) {
  const SolidSides sides = sides_of({box(Vec3d(0.4, -0.2, 0.1), Vec3d(0.44, 0.4, 0.4))});
  const auto found = sides.of(0, Vec3d(0.41, 0.1, 0.2));
  ASSERT_EQ(found.size(), 1U);
  expect_normal(found[0], Vec3d(1.0, 0.0, 0.0));
}

TEST(SolidSides, InThePlaneLeaveOutTheThirdAxis) {
  const SolidSides sides = sides_of({box(Vec3d(0.7, 0.0, 0.2), Vec3d(1.0, 0.0, 0.4))}, 2);
  const auto found = sides.of(0, Vec3d(0.71, 0.0, 0.3));
  ASSERT_EQ(found.size(), 1U);
  expect_normal(found[0], Vec3d(-1.0, 0.0, 0.0));
}

TEST(SolidSides, MayTouchWhatLiesBeforeAFace) {
  const SolidSides sides = sides_of({block()});
  const Vec3d particle(0.71, 0.1, 0.3);
  EXPECT_TRUE(sides.may_touch(0, particle, Vec3d(0.6, 0.0, 0.2), Vec3d(0.7, 0.2, 0.4)));
  EXPECT_FALSE(sides.may_touch(0, particle, Vec3d(0.6, 0.0, 0.42), Vec3d(0.7, 0.2, 0.5)));
}

}  // namespace
}  // namespace eisph
