#include "scheme/scenes.hpp"

#include <array>
#include <map>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kSpacing = 0.0125;
constexpr double kHalfWidth = 0.15;

Scene full_domain() { return dam_break_3d(box(Vec3d(0.25, 0.1, 0.0), Vec3d(0.35, 0.2, 0.2)), kSpacing); }

Scene half_domain() {
  Scene scene = full_domain();
  scene.domain_max.y() = kHalfWidth;
  scene.fluid[0].shape.max.y() = kHalfWidth;
  scene.obstacles[0].shape.max.y() = kHalfWidth;
  scene.faces[kYMax] = {FaceKind::Symmetry, 1.0};
  return scene;
}

/// Rows of a snapshot at t = 0 by lattice point.
std::map<std::array<long, 3>, std::size_t> rows_by_place(const Snapshot& snapshot) {
  std::map<std::array<long, 3>, std::size_t> rows;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    std::array<long, 3> node{};
    for (std::size_t d = 0; d < 3; ++d) {
      node[d] = std::lround(snapshot.position[k][static_cast<Eigen::Index>(d)] / kSpacing - 0.5);
    }
    rows[node] = k;
  }
  return rows;
}

/// Largest differences of the half domain from the full one, particle by particle.
struct Difference {
  double velocity = 0.0;
  double position = 0.0;
  double corner_transverse = 0.0;  ///< of the transverse velocity near symmetry plane and end wall
  int corner_particles = 0;
};

class SymmetryPlane : public testing::Test {
 protected:
  void SetUp() override {
    full_rows_ = rows_by_place(*full_->snapshot());
    half_rows_ = rows_by_place(*half_->snapshot());
    ASSERT_EQ(2 * half_rows_.size(), full_rows_.size());
  }

  Difference advance_and_compare(double time) {
    run_until(*full_, time);
    run_until(*half_, time);
    const auto full = full_->snapshot();
    const auto half = half_->snapshot();
    Difference worst;
    for (const auto& [node, k] : half_rows_) {
      const std::size_t twin = full_rows_.at(node);
      const Vec3f velocity = half->velocity[k] - full->velocity[twin];
      const Vec3f position = half->position[k] - full->position[twin];
      worst.velocity = std::max<double>(worst.velocity, velocity.norm());
      worst.position = std::max<double>(worst.position, position.norm());
      const bool corner =
          full->position[twin].x() < 3.0 * kSpacing && full->position[twin].y() > kHalfWidth - 3.0 * kSpacing;
      if (!corner) continue;
      ++worst.corner_particles;
      worst.corner_transverse = std::max<double>(worst.corner_transverse, std::abs(velocity.y()));
    }
    return worst;
  }

  std::unique_ptr<Simulation> full_ = start(full_domain(), 2);
  std::unique_ptr<Simulation> half_ = start(half_domain(), 2);
  std::map<std::array<long, 3>, std::size_t> full_rows_;
  std::map<std::array<long, 3>, std::size_t> half_rows_;
};

TEST_F(SymmetryPlane, AHalfDomainRunsLikeTheFullOneAlsoInTheCornerWithTheEndWall) {
  // Both runs differ by the order of their sums only: 1e-7 at first, which collisions of particles magnify.
  // Speeds reach 1.5 m/s.
  const Difference early = advance_and_compare(0.05);
  EXPECT_LT(early.velocity, 1e-3);
  EXPECT_LT(early.position, 1e-5);
  EXPECT_GT(early.corner_particles, 50);
  EXPECT_LT(early.corner_transverse, 1e-4);
  const Difference late = advance_and_compare(0.15);
  EXPECT_LT(late.corner_transverse, 1e-3);
  EXPECT_GT(late.corner_particles, 30);
  RecordProperty("velocity_early", std::to_string(early.velocity));
  RecordProperty("corner_early", std::to_string(early.corner_transverse));
  RecordProperty("velocity_late", std::to_string(late.velocity));
  RecordProperty("corner_late", std::to_string(late.corner_transverse));
  EXPECT_EQ(half_->summary().penetrations, 0U);
}

TEST_F(SymmetryPlane, AParticleThatWouldCrossChangesPlacesWithItsImage) {
  // A lone particle 5 mm from the plane, inviscid and on the free surface like its image, so that nothing
  // holds it: after 20 ms at 1 m/s it would be 15 mm beyond; its image is 15 mm inside, on its way back.
  Scene scene = tank(3, Vec3d(0.3, 0.3, 0.5), 0.01, box(Vec3d(0.29, 0.1, 0.4), Vec3d(0.3, 0.11, 0.41)));
  scene.faces[kXMax].kind = FaceKind::Symmetry;
  scene.artificial_viscosity = 0.0;
  scene.fluid[0].velocity = Vec3d(1.0, 0.0, 0.0);
  use_fixed_step(scene, 1e-3);
  const auto simulation = start(scene);
  run_until(*simulation, 0.02);
  const auto snapshot = simulation->snapshot();
  ASSERT_EQ(snapshot->size(), 1U);
  EXPECT_NEAR(snapshot->position[0].x(), 0.285, 1e-5);
  EXPECT_NEAR(snapshot->velocity[0].x(), -1.0, 1e-5);
  EXPECT_EQ(simulation->summary().penetrations, 0U);
}

TEST_F(SymmetryPlane, NothingCrossesIt) {
  run_until(*half_, 0.2);
  const auto snapshot = half_->snapshot();
  for (const Vec3f& position : snapshot->position) EXPECT_LE(position.y(), kHalfWidth + 1e-6);
  EXPECT_EQ(half_->summary().penetrations, 0U);
}

}  // namespace
}  // namespace eisph
