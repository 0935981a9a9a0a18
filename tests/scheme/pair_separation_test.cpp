// Pairs of particles that stretched flow drives together are moved apart.

#include "scheme/scheme_scenes.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Part of the particles with another one within 0.6 spacings, by a search through all.
double paired_fraction(const Snapshot& snapshot) {
  const float limit = 0.6F * static_cast<float>(snapshot.particle_spacing);
  std::size_t paired = 0;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t j = 0; j < snapshot.size(); ++j) {
      if (i != j) nearest = std::min(nearest, (snapshot.position[i] - snapshot.position[j]).squaredNorm());
    }
    paired += nearest <= limit * limit ? 1 : 0;
  }
  return static_cast<double>(paired) / static_cast<double>(snapshot.size());
}

/// Of Taylor-Green vortices that turn once, without shifting.
double paired_in_vortices(const Method& method, double pair_separation) {
  Scene scene = taylor_green(0.025, 0.0);
  scene.kernel = KernelKind::QuinticSpline;
  scene.smoothing_ratio = 1.4;
  scene.artificial_viscosity = 0.02;
  scene.scheme.shifting = 0.0;
  scene.scheme.clamp_pressure = true;
  scene.scheme.pair_separation = pair_separation;
  const auto simulation = start(with_method(scene, method), 2);
  run_until(*simulation, 1.0);
  return paired_fraction(*simulation->snapshot());
}

TEST(PairSeparation, PartsPairsInStretchedFlowWithAllSchemes) {
  for (const Method& method : kMethods) {
    if (method.stepping == Stepping::Thesis) continue;
    EXPECT_LT(paired_in_vortices(method, 0.5), 0.02) << method_name(method);
  }
  EXPECT_GT(paired_in_vortices({"wcsph", Stepping::PredictorCorrector}, 0.0), 0.1);
}

TEST(PairSeparation, LeavesWaterAtRestAlone) {
  const auto positions = [](double speed, double pair_separation) {
    Scene scene = still_water_2d();
    scene.jitter = 0.4;
    scene.fluid[0].velocity = Vec3d(speed, 0.0, 0.0);
    scene.scheme.pair_separation = pair_separation;
    const auto simulation = start(scene);
    EXPECT_GT(paired_fraction(*simulation->snapshot()), 0.0);
    take_steps(*simulation, 1);
    return simulation->snapshot()->position;
  };
  EXPECT_TRUE(positions(0.0, 0.5) == positions(0.0, 0.0));
  EXPECT_FALSE(positions(1.0, 0.5) == positions(1.0, 0.0));
}

}  // namespace
}  // namespace eisph
