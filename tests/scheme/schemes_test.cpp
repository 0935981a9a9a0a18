// What every particle scheme must do, whatever its pressure and its stepping.

#include "scheme/scheme_scenes.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

class Schemes : public testing::TestWithParam<Method> {};
class SlowSchemes : public testing::TestWithParam<Method> {};

std::string case_name(const testing::TestParamInfo<Method>& info) { return method_name(info.param); }
INSTANTIATE_TEST_SUITE_P(All, Schemes, testing::ValuesIn(kMethods), case_name);
INSTANTIATE_TEST_SUITE_P(All, SlowSchemes, testing::ValuesIn(kMethods), case_name);

TEST_P(Schemes, KeepWaterAtRest) {
  const Scene scene = with_method(still_water_2d(), GetParam());
  const auto simulation = start(scene);
  EXPECT_LT(hydrostatic_error(*simulation->snapshot(), 0.15), 0.03) << "at the start, with 15 layers";
  run_until(*simulation, 0.5);
  const auto snapshot = simulation->snapshot();
  ASSERT_TRUE(is_finite(*snapshot));
  EXPECT_LT(hydrostatic_error(*snapshot, 0.15), 0.06);
  EXPECT_LT(largest_speed(*snapshot), 0.1) << "the waves run at 1.2 m/s";
  const RunSummary summary = simulation->summary();
  EXPECT_EQ(summary.penetrations, 0U);
  EXPECT_EQ(summary.scheme, GetParam().scheme);
}

TEST_P(Schemes, CarryTheFrontOfACollapsingColumnAsFar) {
  // EISPH with the stepping of the thesis and steps of phi = 0.01: 0.3881 m.
  const auto simulation = start(with_method(dam_break_2d(), GetParam()));
  run_until(*simulation, 0.18);
  const auto snapshot = simulation->snapshot();
  ASSERT_TRUE(is_finite(*snapshot));
  double front = 0.0;
  for (const Vec3f& position : snapshot->position) front = std::max<double>(front, position.x());
  EXPECT_NEAR(front, 0.3881, 0.005);
  // A density carried by particles must stay with its particle: where it does not, they crowd at the floor.
  std::vector<float> densities = snapshot->number_density;
  std::sort(densities.begin(), densities.end());
  EXPECT_LT(densities[densities.size() * 95 / 100], 1.02F);
  const RunSummary summary = simulation->summary();
  EXPECT_EQ(summary.penetrations, 0U);
  EXPECT_LT(summary.energy_gain_max, 0.002 * summary.energy_initial);
}

TEST(Schemes, DiffusionLeavesTheDensityAtTheFloorAlone) {
  // Images below the floor have the pressure of the water above it. Were they to diffuse it, the lowest
  // particles would lose density by the fold and crowd: to 1.018 here.
  const auto simulation = start(with_method(still_water_2d(0.3), {"delta_sph", Stepping::Symplectic}), 2);
  run_until(*simulation, 1.0);
  const auto snapshot = simulation->snapshot();
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < snapshot->size(); ++k) {
    if (snapshot->position[k].z() > 0.01F) continue;
    sum += snapshot->number_density[k];
    ++count;
  }
  ASSERT_GT(count, 20);
  EXPECT_LT(sum / count, 1.006);
}

TEST_P(Schemes, GiveTheSameBitsWithAnyNumberOfThreads) {
  Scene scene = dam_break_3d(box(Vec3d(0.22, 0.1, 0.0), Vec3d(0.3, 0.2, 0.2)), 0.025);
  scene.scheme.shifting = 0.5;
  scene = with_method(scene, GetParam());
  std::shared_ptr<const Snapshot> first;
  for (const int threads : {1, 2, 3}) {
    const auto simulation = start(scene, threads);
    take_steps(*simulation, 25);
    const auto snapshot = simulation->snapshot();
    ASSERT_TRUE(is_finite(*snapshot));
    if (!first) first = snapshot;
    EXPECT_TRUE(snapshot->position == first->position) << threads << " threads";
    EXPECT_TRUE(snapshot->velocity == first->velocity) << threads << " threads";
    EXPECT_TRUE(snapshot->pressure == first->pressure) << threads << " threads";
    EXPECT_TRUE(snapshot->objects->pressure == first->objects->pressure) << threads << " threads";
  }
}

TEST_P(Schemes, TakeNewParametersAsIfTheSceneHadThem) {
  Scene other = with_method(dam_break_2d(0.02), GetParam());
  other.kinematic_viscosity = 1e-4;
  other.artificial_viscosity = 0.1;
  (other.scheme.weakly_compressible() ? other.scheme.courant : other.scheme.phi) *= 0.5;
  if (other.scheme.name == "eisph") other.scheme.pressure_sweeps = 2;
  const auto expected = start(other);
  const auto changed = Simulation::create(with_method(dam_break_2d(0.02), GetParam()), 1);
  changed->set_parameters(running_parameters(other));
  changed->initialise();
  take_steps(*expected, 30);
  take_steps(*changed, 30);
  EXPECT_EQ(changed->time(), expected->time());
  EXPECT_TRUE(changed->snapshot()->position == expected->snapshot()->position);
  EXPECT_TRUE(changed->snapshot()->pressure == expected->snapshot()->pressure);
}

TEST_P(SlowSchemes, StopAWaveAtAnObstacle) {
  const Scene scene =
      with_method(dam_break_3d(box(Vec3d(0.3, 0.1, 0.0), Vec3d(0.35, 0.2, 0.2)), 0.0125), GetParam());
  const auto simulation = start(scene, 2);
  float highest = 0.0F;
  for (int k = 0; k <= 20; ++k) {
    run_until(*simulation, 0.15 + 0.005 * k);
    const auto snapshot = simulation->snapshot();
    ASSERT_TRUE(is_finite(*snapshot));
    EXPECT_TRUE(is_inside(*snapshot, scene));
    for (const float pressure : snapshot->objects->pressure) highest = std::max(highest, pressure);
  }
  EXPECT_GT(highest, 0.2 * kDensity * kGravity * 0.15) << "the wave presses on the obstacle";
  const RunSummary summary = simulation->summary();
  EXPECT_EQ(summary.penetrations, 0U);
  EXPECT_EQ(summary.lost_particles, 0U);
  EXPECT_LT(summary.energy_gain_max, 0.01 * summary.energy_initial);
}

/// Mean velocity along x of the lowest layer, in the middle of a slab of fluid that slides along.
double sliding_speed(const Method& method, double slip_factor) {
  Scene scene = tank(2, Vec3d(0.8, 0.0, 0.2), 0.01, box(Vec3d::Zero(), Vec3d(0.8, 0.0, 0.2)));
  scene.gravity.setZero();
  scene.fluid[0].velocity = Vec3d(1.0, 0.0, 0.0);
  scene.faces[kXMin] = {FaceKind::Open, 1.0};
  scene.faces[kXMax] = {FaceKind::Open, 1.0};
  scene.faces[kZMin].slip_factor = slip_factor;
  scene.faces[kZMax].slip_factor = slip_factor;
  scene.kinematic_viscosity = 4e-3;
  scene.artificial_viscosity = 0.0;
  const auto simulation = start(with_method(scene, method));
  run_until(*simulation, 0.05);
  double sum = 0.0;
  int count = 0;
  const auto snapshot = simulation->snapshot();
  for (std::size_t k = 0; k < snapshot->size(); ++k) {
    const Vec3f& at = snapshot->position[k];
    if (at.z() > 0.01F || std::abs(at.x() - 0.4F) > 0.15F) continue;
    sum += snapshot->velocity[k].x();
    ++count;
  }
  return sum / count;
}

TEST_P(Schemes, HoldTheFluidOnNoSlipWallsOnly) {
  EXPECT_NEAR(sliding_speed(GetParam(), 1.0), 1.0, 0.01);
  // Stokes's first problem: u = erf(z / sqrt(4 nu t)) is 0.198 at z = 0.005 m.
  EXPECT_NEAR(sliding_speed(GetParam(), 0.0), 0.198, 0.05);
}

/// Decay rate of the kinetic energy of Taylor-Green vortices at Re = 100 over 1 s, over 16 pi^2 nu.
TEST_P(SlowSchemes, SlowTaylorGreenVorticesAtTheRateOfViscosity) {
  constexpr double kViscosity = 0.01;
  Scene scene = taylor_green(0.01, kViscosity);
  // Without diffusion of the density its noise takes energy from the vortices, unless shifting is stronger.
  if (std::string(GetParam().scheme) == "wcsph") scene.scheme.shifting = 4.0;
  const auto simulation = start(with_method(scene, GetParam()), 2);
  const double before = kinetic_energy(*simulation->snapshot());
  EXPECT_NEAR(before, 250.0, 1.0);
  run_until(*simulation, 1.0);
  const double rate = std::log(before / kinetic_energy(*simulation->snapshot()));
  EXPECT_NEAR(rate / (16.0 * std::numbers::pi * std::numbers::pi * kViscosity), 1.0, 0.02);
}

/// Rotating square patch (Colagrossi 2005): the series of the Poisson equation gives -0.14734 rho w^2 L^2.
TEST(Schemes, FindTheNegativePressureInARotatingPatch) {
  Scene scene = tank(2, Vec3d(2.0, 0.0, 2.0), 0.01, box(Vec3d(0.5, 0.0, 0.5), Vec3d(1.5, 0.0, 1.5)));
  scene.gravity.setZero();
  scene.faces.fill({FaceKind::Open, 1.0});
  scene.fluid[0].angular_velocity = 2.0;
  scene.smoothing_ratio = 1.6;
  scene.scheme.clamp_pressure = false;
  for (const Method& method : kMethods) {
    const auto snapshot = start(with_method(scene, method))->snapshot();
    double nearest = 1.0;
    double centre = 0.0;
    for (std::size_t k = 0; k < snapshot->size(); ++k) {
      const double distance = (snapshot->position[k] - Vec3f(1.0F, 0.0F, 1.0F)).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      centre = snapshot->pressure[k];
    }
    EXPECT_NEAR(centre / (kDensity * 4.0), -0.14734, 0.02 * 0.14734) << method_name(method);
  }
}

/// Root mean square distance of the particles of EISPH and ISPH after 0.12 s of a collapse.
double distance_of_schemes(double phi) {
  Scene scene = dam_break_2d(0.02);
  scene.artificial_viscosity = 0.05;
  scene.scheme.phi = phi;
  const auto state = [&](const char* name) {
    Scene with = with_method(scene, {name, Stepping::Symplectic});
    with.scheme.source_factor = 1.0;
    with.scheme.volume_correction = 0.0;
    const auto simulation = start(with);
    run_until(*simulation, 0.12);
    return simulation->snapshot();
  };
  const auto one = state("eisph");
  const auto other = state("isph");
  double sum = 0.0;
  for (std::size_t k = 0; k < one->size(); ++k) sum += (one->position[k] - other->position[k]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(one->size()));
}

TEST(Schemes, EisphTendsToIsphAsTheStepShrinks) {
  const double coarse = distance_of_schemes(0.16);
  const double middle = distance_of_schemes(0.04);
  const double fine = distance_of_schemes(0.01);
  EXPECT_LT(middle, 0.6 * coarse);
  EXPECT_LT(fine, 0.6 * middle);
}

TEST(Schemes, IsphReportsItsIterationsAndObeysItsTolerance) {
  Scene scene = with_method(dam_break_2d(), {"isph", Stepping::Symplectic});
  const auto iterations = [&](double tolerance) {
    scene.scheme.pressure_tolerance = tolerance;
    const auto simulation = start(scene);
    take_steps(*simulation, 20);
    return simulation->summary().pressure_iterations_mean;
  };
  const double loose = iterations(1e-2);
  const double tight = iterations(1e-5);
  EXPECT_GT(loose, 1.0);
  EXPECT_GT(tight, 1.5 * loose);
  EXPECT_EQ(start(dam_break_2d())->summary().pressure_iterations_mean, 0.0);
}

TEST(Schemes, ViscosityIsTheSameInTheSourceAndBesideThePressureGradient) {
  Scene scene = dam_break_2d(0.02);
  // A film of two layers is all free surface: no pressure, viscosity alone.
  scene.fluid[0].shape = box(Vec3d(0.1, 0.0, 0.1), Vec3d(0.4, 0.0, 0.14));
  // Rotates and stretches nowhere fast enough to be pressed together by the dead zone of 3 % a step.
  scene.fluid[0].vortex_speed = 0.2;
  scene.kinematic_viscosity = 1e-3;
  scene.scheme.free_surface_threshold = 1.0;
  scene.scheme.volume_correction = 0.0;
  const auto state = [&](bool in_source) {
    scene.scheme.viscous_source = in_source;
    const auto simulation = start(scene);
    take_steps(*simulation, 5);
    return simulation->snapshot();
  };
  const auto apart = state(true);
  const auto together = state(false);
  scene.kinematic_viscosity = 0.0;
  scene.artificial_viscosity = 0.0;
  const auto inviscid = state(false);
  float effect = 0.0F;
  for (std::size_t k = 0; k < apart->size(); ++k) {
    EXPECT_NEAR((apart->velocity[k] - together->velocity[k]).norm(), 0.0, 1e-5) << k;
    effect = std::max(effect, (apart->velocity[k] - inviscid->velocity[k]).norm());
  }
  EXPECT_GT(effect, 1e-3F);
}

TEST(Schemes, KeptNeighbourListsDoNotChangeTheFlow) {
  const auto state = [](double reach) {
    Scene scene = dam_break_2d();
    scene.scheme.list_reach = reach;
    const auto simulation = start(scene);
    run_until(*simulation, 0.15);
    return std::pair(simulation->snapshot(), simulation->summary());
  };
  const auto [fresh, fresh_summary] = state(0.0);
  const auto [kept, kept_summary] = state(0.5);
  double squared = 0.0;
  for (std::size_t k = 0; k < fresh->size(); ++k) {
    squared += (fresh->position[k] - kept->position[k]).squaredNorm();
  }
  EXPECT_GT(squared, 0.0) << "lists were kept";
  EXPECT_LT(std::sqrt(squared / static_cast<double>(fresh->size())), 0.02 * 0.01) << "2 % of the spacing";
  EXPECT_NEAR(kept_summary.compression_max, fresh_summary.compression_max, 0.005);
}

/// Without the volume correction the top layer of still water sinks until its density is no longer that of a
/// free surface: nothing then holds the level of the pressure, and the linear equations are singular.
TEST(Schemes, IsphBearsTheLossOfTheFreeSurface) {
  Scene scene = with_method(tank(2, Vec3d(1.0, 0.0, 0.5), 0.02, box(Vec3d::Zero(), Vec3d(1.0, 0.0, 0.3))),
                            {"isph", Stepping::Symplectic});
  scene.scheme.volume_correction = 0.0;
  const auto simulation = start(scene);
  run_until(*simulation, 0.3);
  const auto snapshot = simulation->snapshot();
  ASSERT_TRUE(is_finite(*snapshot));
  EXPECT_LT(largest_speed(*snapshot), 2.0);
}

TEST(Schemes, CountThePairsTheyEvaluate) {
  const auto pairs = [](const Method& method, bool viscous_source = true) {
    Scene scene = with_method(still_water_2d(), method);
    scene.scheme.viscous_source = viscous_source;
    const auto simulation = start(scene);
    const double before = simulation->summary().pair_evaluations;
    take_steps(*simulation, 10);
    return simulation->summary().pair_evaluations - before;
  };
  const double eisph = pairs({"eisph", Stepping::Symplectic});
  // Three passes against two, and against two for each of two stages; the lists are nearly the same.
  EXPECT_NEAR(pairs({"eisph", Stepping::Symplectic}, false) / eisph, 2.0 / 3.0, 0.01);
  EXPECT_NEAR(pairs({"wcsph", Stepping::Symplectic}) / eisph, 2.0 / 3.0, 0.02);
  EXPECT_NEAR(pairs({"wcsph", Stepping::PredictorCorrector}) / eisph, 4.0 / 3.0, 0.04);
  EXPECT_GT(eisph, 10.0 * 3.0 * 450.0 * 20.0) << "450 particles with some 21 neighbours";
}

}  // namespace
}  // namespace eisph
