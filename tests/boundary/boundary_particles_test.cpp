#include "boundary/boundary_particles.hpp"

#include "boundary/tank_scene.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include <gmock/gmock.h>

namespace eisph {
namespace {

Snapshot particle_at(const Vec3f& position) {
  Snapshot snapshot;
  snapshot.position = {position};
  return snapshot;
}

TEST(BoundaryParticles, NothingIsMadeUnlessAskedFor) {
  const Scene scene = tank_scene(3);
  const BoundaryParticles none = boundary_particles(scene, particle_at({0.41F, -0.19F, 0.11F}), false, false);
  EXPECT_TRUE(none.ghosts.empty());
  EXPECT_TRUE(none.virtual_particles.empty());
}

TEST(BoundaryParticles, AParticleInACornerHasItsImagesBeyondTheWalls) {
  const Scene scene = tank_scene(3);  // from (0.4, -0.2, 0.1)
  const auto ghosts = boundary_particles(scene, particle_at({0.41F, -0.19F, 0.11F}), true, false).ghosts;
  std::set<std::tuple<int, int, int>> found;
  for (const Vec3f& at : ghosts) {
    found.emplace(static_cast<int>(std::lround(1e3F * at.x())), static_cast<int>(std::lround(1e3F * at.y())),
                  static_cast<int>(std::lround(1e3F * at.z())));
  }
  std::set<std::tuple<int, int, int>> expected;
  for (const int x : {410, 390}) {
    for (const int y : {-190, -210}) {
      for (const int z : {110, 90}) expected.emplace(x, y, z);
    }
  }
  expected.erase({410, -190, 110});  // the particle itself
  EXPECT_EQ(found, expected);
  EXPECT_TRUE(boundary_particles(scene, particle_at({0.9F, 0.1F, 0.3F}), true, false).ghosts.empty());
}

TEST(BoundaryParticles, WithoutGhostParticlesThereAreNone) {
  Scene scene = tank_scene(2);
  const Snapshot state = particle_at({0.41F, 0.0F, 0.3F});
  EXPECT_EQ(boundary_particles(scene, state, true, false).ghosts.size(), 1U);
  scene.boundary.ghost_particles = false;
  EXPECT_TRUE(boundary_particles(scene, state, true, false).ghosts.empty());
}

TEST(BoundaryParticles, VirtualParticlesCoverTheWallsAtHalfASpacing) {
  Scene scene = tank_scene(2);  // 1 x 0.5 m, dx / 2 = 0.01 m
  scene.faces[kZMax].kind = FaceKind::Open;
  scene.faces[kXMin].kind = FaceKind::Symmetry;
  const auto points = boundary_particles(scene, Snapshot{}, false, true).virtual_particles;
  const auto count = [&](auto is) { return std::count_if(points.begin(), points.end(), is); };
  EXPECT_EQ(points.size(), 101U + 51U) << "the floor and one side";
  EXPECT_EQ(count([](const Vec3f& at) { return std::abs(at.z() - 0.1F) < 1e-6F; }), 101 + 1);
  EXPECT_EQ(count([](const Vec3f& at) { return std::abs(at.x() - 1.4F) < 1e-6F; }), 51 + 1);
  scene.boundary.virtual_particles = false;
  EXPECT_TRUE(boundary_particles(scene, Snapshot{}, false, true).virtual_particles.empty());
}

}  // namespace
}  // namespace eisph
