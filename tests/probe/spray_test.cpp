#include "probe/spray.hpp"

#include "core/kernel.hpp"
#include "probe/hand_made.hpp"

#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Sum of W over offsets (dx), not normalised; `ratio` is h / dx.
double kernel_sum(KernelKind kind, double ratio, const std::vector<Vec3d>& offsets) {
  return with_kernel(kind, [&](auto kernel) {
    double sum = 0.0;
    for (const Vec3d& offset : offsets) sum += kernel.value(offset.norm() / ratio);
    return sum;
  });
}

/// Kernel and h / dx.
using Smoothing = std::pair<KernelKind, double>;

/// Offsets from a particle of shapes of water, particle spacings.
class SprayOfSmoothing : public testing::TestWithParam<std::tuple<Smoothing, int>> {
 protected:
  [[nodiscard]] int dimension() const { return std::get<1>(GetParam()); }

  /// Points i, j, k times `apart` with -5 <= i <= last_i, likewise j (3D), and k from -below to 0.
  [[nodiscard]] std::vector<Vec3d> layers(double apart, int last_i, int below) const {
    std::vector<Vec3d> offsets;
    const int last_j = dimension() == 2 ? 0 : 5;
    for (int k = -below; k <= 0; ++k) {
      for (int j = -last_j; j <= last_j; ++j) {
        for (int i = -5; i <= last_i; ++i) offsets.emplace_back(apart * i, apart * j, k);
      }
    }
    return offsets;
  }
  /// With the mirror images at a floor half a spacing below.
  [[nodiscard]] static std::vector<Vec3d> on_floor(std::vector<Vec3d> offsets) {
    const std::size_t count = offsets.size();
    for (std::size_t k = 0; k < count; ++k)
      offsets.emplace_back(offsets[k].x(), offsets[k].y(), -1.0 - offsets[k].z());
    return offsets;
  }
  /// Number density normalised by that of the lattice.
  [[nodiscard]] double density(const std::vector<Vec3d>& offsets) const {
    const auto& [kernel, ratio] = std::get<0>(GetParam());
    std::vector<Vec3d> lattice = layers(1.0, 5, 10);
    for (Vec3d& offset : lattice) offset.z() += 5.0;
    return kernel_sum(kernel, ratio, offsets) / kernel_sum(kernel, ratio, lattice);
  }
  /// Whether a particle of that density is spray at a height (m) above the floor of the tank.
  [[nodiscard]] bool is_spray(double density, double height) const {
    Scene scene = hand_made_scene(dimension());
    std::tie(scene.kernel, scene.smoothing_ratio) = std::get<0>(GetParam());
    Snapshot snapshot =
        hand_made_snapshot(scene, {Vec3f(0.5F, 0.0F, static_cast<float>(scene.domain_min.z() + height))});
    snapshot.number_density[0] = static_cast<float>(density);
    return SprayRule(scene, 0.0).is_spray(snapshot, 0);
  }
};

constexpr double kHalfSpacing = 0.01;  ///< m, of hand_made_scene
constexpr double kInTheAir = 0.3;      ///< m

TEST_P(SprayOfSmoothing, IsALoneDropInTheAirAndNotOnTheFloor) {
  EXPECT_TRUE(is_spray(density({Vec3d::Zero()}), kInTheAir));
  EXPECT_TRUE(is_spray(density({Vec3d::Zero(), Vec3d(0.8, 0.0, 0.0)}), kInTheAir)) << "nor do two make water";
  EXPECT_FALSE(is_spray(density(on_floor({Vec3d::Zero()})), kHalfSpacing));
}

TEST_P(SprayOfSmoothing, IsNoLayerOfOneParticleOnTheFloorNorItsTip) {
  const double inner = density(on_floor(layers(1.0, 5, 0)));
  const double tip = density(on_floor(layers(1.0, 0, 0)));
  EXPECT_GT(inner, 0.72);
  EXPECT_GT(tip, 0.53);
  // Not even where the wall is not below but beside it.
  EXPECT_FALSE(is_spray(inner, kInTheAir));
  EXPECT_FALSE(is_spray(tip, kInTheAir));
}

TEST_P(SprayOfSmoothing, IsNoFilmOnTheFloorThatHasThinnedToLessThanALayer) {
  const double film = density(on_floor(layers(1.5, 5, 0)));
  EXPECT_FALSE(is_spray(film, kHalfSpacing));
  if (dimension() == 3) {
    EXPECT_TRUE(is_spray(film, kInTheAir)) << "the number density alone does not tell";
  }
}

TEST_P(SprayOfSmoothing, IsNoSheetOfOneLayerInTheAir) {
  EXPECT_FALSE(is_spray(density(layers(1.0, 5, 0)), kInTheAir));
}

TEST_P(SprayOfSmoothing, IsNoSheetOfTwoLayersInTheAirNorItsEdgeNorTheSurfaceOfDeepWater) {
  EXPECT_FALSE(is_spray(density(layers(1.0, 5, 1)), kInTheAir));
  EXPECT_FALSE(is_spray(density(layers(1.0, 0, 1)), kInTheAir));
  EXPECT_FALSE(is_spray(density(layers(1.0, 5, 5)), kInTheAir));
  EXPECT_FALSE(is_spray(density(layers(1.0, 0, 5)), kInTheAir));
}

TEST_P(SprayOfSmoothing, EndsAtAPartOfTheDensityOfAnEdge) {
  const auto& [kernel, ratio] = std::get<0>(GetParam());
  const double edge = density(layers(1.0, 0, 5));
  EXPECT_NEAR(spray_number_density(kernel, ratio, dimension()), 0.87 * edge, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Kernels, SprayOfSmoothing,
                         testing::Values(std::tuple(Smoothing(KernelKind::CubicSpline, 1.1), 2),
                                         std::tuple(Smoothing(KernelKind::CubicSpline, 1.1), 3),
                                         std::tuple(Smoothing(KernelKind::CubicSpline, 1.32), 2),
                                         std::tuple(Smoothing(KernelKind::CubicSpline, 1.32), 3),
                                         std::tuple(Smoothing(KernelKind::WendlandC2, 1.2), 3),
                                         std::tuple(Smoothing(KernelKind::WendlandC2, 1.32), 2),
                                         std::tuple(Smoothing(KernelKind::WendlandC2, 1.5), 2),
                                         std::tuple(Smoothing(KernelKind::WendlandC2, 1.5), 3),
                                         std::tuple(Smoothing(KernelKind::QuinticSpline, 1.2), 3),
                                         std::tuple(Smoothing(KernelKind::QuinticSpline, 1.4), 2),
                                         std::tuple(Smoothing(KernelKind::QuinticSpline, 1.4), 3)));

TEST(SprayNumberDensity, IsAHalfWithTheKernelOfTheThesis) {
  EXPECT_NEAR(spray_number_density(KernelKind::CubicSpline, 1.32, 2), 0.50, 0.005);
  EXPECT_NEAR(spray_number_density(KernelKind::CubicSpline, 1.32, 3), 0.51, 0.005);
}

/// Whether a particle without neighbours at a place is spray.
bool lone_is_spray(const Scene& scene, const Vec3d& place, double time = 0.0) {
  Snapshot snapshot = hand_made_snapshot(scene, {place.cast<float>()}, time);
  snapshot.number_density[0] = 0.14F;
  return SprayRule(scene, time).is_spray(snapshot, 0);
}

class SprayTest : public testing::TestWithParam<int> {
 protected:
  Scene scene_ = hand_made_scene(GetParam());
};

TEST_P(SprayTest, BeginsOneSpacingAboveTheFloor) {
  EXPECT_FALSE(lone_is_spray(scene_, Vec3d(0.5, 0.25, 0.119)));
  EXPECT_TRUE(lone_is_spray(scene_, Vec3d(0.5, 0.25, 0.121)));
}

TEST_P(SprayTest, BeginsOneSpacingAboveTheTopOfASolidAndRightBesideIt) {
  scene_.obstacles.push_back({"block", box(Vec3d(0.4, 0.1, 0.1), Vec3d(0.6, 0.4, 0.3))});
  EXPECT_FALSE(lone_is_spray(scene_, Vec3d(0.5, 0.25, 0.319)));
  EXPECT_TRUE(lone_is_spray(scene_, Vec3d(0.5, 0.25, 0.321)));
  EXPECT_TRUE(lone_is_spray(scene_, Vec3d(0.399, 0.25, 0.25)));
}

TEST_P(SprayTest, FollowsAGate) {
  Gate gate;
  gate.name = "gate";
  gate.shape = box(Vec3d(0.4, 0.0, 0.1), Vec3d(0.6, 0.5, 0.3));
  gate.motion = GateMotion::Lift;
  gate.start_time = 1.0;
  gate.speed = 0.1;
  gate.stroke = 0.1;
  scene_.gates.push_back(gate);
  const Vec3d above(0.5, 0.25, 0.31);
  const Vec3d above_lifted(0.5, 0.25, 0.36);
  EXPECT_FALSE(lone_is_spray(scene_, above, 0.0));
  EXPECT_TRUE(lone_is_spray(scene_, above_lifted, 0.0));
  EXPECT_FALSE(lone_is_spray(scene_, above_lifted, 1.5));
  EXPECT_TRUE(lone_is_spray(scene_, above, 3.0)) << "the gate is gone";
}

INSTANTIATE_TEST_SUITE_P(Dimension, SprayTest, testing::Values(2, 3));

}  // namespace
}  // namespace eisph
