#include "core/scene_mirror.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

namespace eisph {
namespace {

Scene half_tank() {
  Scene scene;
  scene.domain_max = Vec3d(2.0, 0.6, 0.5);
  scene.faces[kYMax].kind = FaceKind::Symmetry;
  Obstacle dam;
  dam.shape.min = Vec3d(0.8, 0.0, 0.0);
  dam.shape.max = Vec3d(0.825, 0.45, 0.2);
  Obstacle block;
  block.shape.min = Vec3d(1.4, 0.45, 0.0);
  block.shape.max = Vec3d(1.5, 0.6, 0.25);
  Obstacle pile;
  pile.shape.kind = ShapeKind::Cylinder;
  pile.shape.centre = Vec3d(1.0, 0.2, 0.0);
  pile.shape.radius = 0.1;
  pile.shape.height = 0.3;
  scene.obstacles = {dam, block, pile};
  return scene;
}

TEST(SceneMirror, CompletesDomainAndSolids) {
  const Scene whole = completed_by_symmetry(half_tank());
  EXPECT_DOUBLE_EQ(whole.domain_max.y(), 1.2);
  EXPECT_EQ(whole.faces[kYMax].kind, FaceKind::Wall);
  ASSERT_EQ(whole.obstacles.size(), 5U);
  EXPECT_DOUBLE_EQ(whole.obstacles[1].shape.min.y(), 0.45);
  EXPECT_DOUBLE_EQ(whole.obstacles[1].shape.max.y(), 0.75);
  EXPECT_DOUBLE_EQ(whole.obstacles[3].shape.min.y(), 0.75);
  EXPECT_DOUBLE_EQ(whole.obstacles[3].shape.max.y(), 1.2);
  EXPECT_DOUBLE_EQ(whole.obstacles[4].shape.centre.y(), 1.0);
}

TEST(SceneMirror, EveryPointAndItsImageAreAsFarFromTheSolids) {
  Scene half = half_tank();
  half.obstacles[0].shape.rotation_z = std::numbers::pi / 7.0;
  const Scene whole = completed_by_symmetry(half);
  const auto distance = [&](double x, double y) {
    double nearest = 10.0;
    for (const Obstacle& obstacle : whole.obstacles)
      nearest = std::min(nearest, obstacle.shape.signed_distance(Vec3d(x, y, 0.1), 3));
    return nearest;
  };
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 12; ++j) {
      const double x = 0.1 * i;
      const double y = 0.05 * j;
      EXPECT_NEAR(distance(x, y), distance(x, 1.2 - y), 1e-12);
    }
  }
}

TEST(SceneMirror, LowerFaceIsCompletedDownwards) {
  Scene scene = half_tank();
  std::swap(scene.faces[kYMin], scene.faces[kYMax]);
  EXPECT_EQ(symmetry_plane_y(scene), 0.0);
  const Scene whole = completed_by_symmetry(scene);
  EXPECT_DOUBLE_EQ(whole.domain_min.y(), -0.6);
  EXPECT_DOUBLE_EQ(whole.obstacles[0].shape.min.y(), -0.45);
}

TEST(SceneMirror, LeavesAWholeTankAlone) {
  Scene scene = half_tank();
  scene.faces[kYMax].kind = FaceKind::Wall;
  EXPECT_FALSE(symmetry_plane_y(scene).has_value());
  EXPECT_EQ(completed_by_symmetry(scene).obstacles, scene.obstacles);
}

}  // namespace
}  // namespace eisph
