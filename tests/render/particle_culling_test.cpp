#include "render/particle_culling.hpp"

#include "render/frame_renderer.hpp"
#include "render/synthetic_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace eisph {
namespace {

Snapshot cube(int edge) {
  Snapshot snapshot;
  snapshot.particle_spacing = 0.01;
  snapshot.objects = std::make_shared<ObjectParticles>();
  for (int k = 0; k < edge; ++k) {
    for (int j = 0; j < edge; ++j) {
      for (int i = 0; i < edge; ++i)
        snapshot.position.emplace_back(0.01F * Vec3d(i + 0.5, j + 0.5, k + 0.5).cast<float>());
    }
  }
  return snapshot;
}

CameraView view_from(const Vec3d& eye, const Vec3d& target = Vec3d(0.1, 0.1, 0.1)) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  return {camera, 100, 100, 100, Bounds{Vec3d::Zero(), Vec3d(1.0, 1.0, 1.0)}};
}

TEST(VisibleParticles, KeepTheSurfaceAndLeaveOutTheInside) {
  const Snapshot snapshot = cube(24);
  // The floor is far below, so that all six faces count.
  const auto kept = visible_particles(snapshot, view_from({3.0, -3.0, 2.0}), -1.0);
  EXPECT_LT(kept.size(), snapshot.size() * 9 / 10);
  std::vector<bool> is_kept(snapshot.size(), false);
  for (const auto i : kept) is_kept[i] = true;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const Vec3f& x = snapshot.position[i];
    const float inside = std::min(x.minCoeff(), 0.24F - x.maxCoeff());
    if (inside < 0.025F) {
      EXPECT_TRUE(is_kept[i]) << x.transpose();
    }
  }
}

TEST(VisibleParticles, AFloorHidesTheLowestOnesFromAboveOnly) {
  const Snapshot snapshot = cube(24);
  const auto lowest_kept = [&](double eye_height) {
    const auto kept = visible_particles(snapshot, view_from({3.0, -3.0, eye_height}), 0.0);
    return std::count_if(kept.begin(), kept.end(), [&](auto i) {
      const Vec3f& x = snapshot.position[i];
      return x.z() < 0.01F && std::abs(x.x() - 0.12F) < 0.02F && std::abs(x.y() - 0.12F) < 0.02F;
    });
  };
  EXPECT_EQ(lowest_kept(2.0), 0);
  EXPECT_EQ(lowest_kept(-2.0), 16);
}

TEST(VisibleParticles, NothingIsLeftOutForAnEyeInTheWater) {
  const Snapshot snapshot = cube(24);
  EXPECT_EQ(visible_particles(snapshot, view_from({0.12, 0.12, 0.2}), 0.0).size(), snapshot.size());
}

TEST(VisibleParticles, ParticlesWithoutAFinitePositionAreLeftOut) {
  Snapshot snapshot = cube(3);
  snapshot.position[5].x() = std::numeric_limits<float>::quiet_NaN();
  snapshot.position[7].z() = std::numeric_limits<float>::infinity();
  EXPECT_EQ(visible_particles(snapshot, view_from({3.0, -3.0, 2.0}), 0.0).size(), 25U);
  EXPECT_EQ(finite_particles(snapshot).size(), 25U);
}

TEST(VisibleParticles, AnEmptySnapshotHasNone) {
  EXPECT_TRUE(visible_particles(cube(0), view_from({3.0, -3.0, 2.0}), 0.0).empty());
}

TEST(VisibleParticles, LeavingTheOthersOutDoesNotChangeTheFrame) {
  synthetic::State state = synthetic::tank(0.01);
  std::uint32_t random = 3;
  const auto noise = [&] {
    return 3e-3F *
           (static_cast<float>((random = random * 1664525U + 1013904223U) >> 8U) / 16777216.0F - 0.5F);
  };
  for (Vec3f& x : state.snapshot.position) x += Vec3f(noise(), noise(), noise());
  ImageSettings settings;
  settings.width = 640;
  settings.height = 480;
  ParticlePictureOptions all;
  all.cull_interior = false;
  const Image culled = FrameRenderer(state.scene).draw(settings, state.snapshot, state.depth);
  const Image full = FrameRenderer(state.scene, all).draw(settings, state.snapshot, state.depth);
  std::size_t different = 0;
  for (std::size_t k = 0; k < full.rgb.size(); k += 3) {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(full.rgb[k + c] - culled.rgb[k + c]));
    if (largest > 8) ++different;
  }
  // 0.02 % of the pixels.
  EXPECT_LE(different, full.rgb.size() / 3 / 5000);
}

}  // namespace
}  // namespace eisph
