#include "scheme/neighbour_sums.hpp"
#include "scheme/pressure_equation.hpp"
#include "scheme/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// A channel full of water with the profile u_x = z (H - z) of plane Poiseuille flow, layer by layer.
template <int Dim>
Scene channel(double slip_factor) {
  constexpr double kHeight = 0.4;
  constexpr double kSpacing = 0.02;
  const double width = Dim == 2 ? 0.0 : 0.2;
  Scene scene = tank(Dim, Vec3d(0.4, width, kHeight), kSpacing, Shape());
  scene.fluid.clear();
  for (int layer = 0; layer < 20; ++layer) {
    FluidRegion region;
    region.shape = box(Vec3d(0.0, 0.0, layer * kSpacing), Vec3d(0.4, width, (layer + 1) * kSpacing));
    const double z = (layer + 0.5) * kSpacing;
    region.velocity = Vec3d(z * (kHeight - z), 0.0, 0.0);
    scene.fluid.push_back(region);
  }
  scene.gravity.setZero();
  scene.smoothing_ratio = 1.4;
  scene.kinematic_viscosity = 1e-3;
  scene.faces[kZMin].slip_factor = slip_factor;
  scene.faces[kZMax].slip_factor = slip_factor;
  return scene;
}

/// Viscous acceleration over -2 nu of the particles halfway along the channel, by layer.
template <int Dim>
std::vector<double> relative_drag(const Scene& scene) {
  ParticleSystem<Dim> particles(scene, 2);
  particles.sort_fluid();
  particles.place_boundaries(0.0);
  particles.find_neighbours();
  const SourceTable& table = particles.table;
  std::vector<double> sum(20, 0.0);
  std::vector<double> count(20, 0.0);
  for (std::uint32_t row = table.first_fluid; row < table.first_image; ++row) {
    const double x = table.position[row].x * scene.smoothing_length();
    const double z = (&table.position[row].x)[Dim - 1] * scene.smoothing_length();
    if (std::abs(x - 0.2) > 0.1) continue;
    const double acceleration = viscous_acceleration(particles, row).x[0];
    const auto layer = static_cast<std::size_t>(z / 0.02);
    sum[layer] += acceleration / (-2.0 * scene.kinematic_viscosity);
    count[layer] += 1.0;
  }
  for (std::size_t layer = 0; layer < 20; ++layer) sum[layer] /= count[layer];
  return sum;
}

/// nu lap u = -2 nu in the middle of the channel: nine tenths of it by the form of Morris, which is exact
/// here, one by that of Monaghan, which finds 0.778 (2D) and 0.832 (3D) of a shear along the axes of the
/// lattice at h = 1.4 dx. The artificial viscosity is off.
template <int Dim>
void expect_even_drag(double lattice_factor) {
  Scene scene = channel<Dim>(0.0);
  scene.artificial_viscosity = 0.0;
  const auto drag = relative_drag<Dim>(scene);
  for (std::size_t layer = 3; layer < 17; ++layer) {
    EXPECT_NEAR(drag[layer], lattice_factor, 1.5e-3) << "layer " << layer;
  }
}

TEST(Viscosity, OfAPoiseuilleProfileIsEvenAcrossTheChannel) {
  expect_even_drag<2>(0.9 + 0.1 * 0.778);
  expect_even_drag<3>(0.9 + 0.1 * 0.832);
}

/// Flux of a film of depth H on a no-slip floor that gravity along it sets going at t = 0, over nu / g:
/// int (H z - z^2/2) dz - sum 2 / (H k^4) exp(-nu k^2 t), k = (n + 1/2) pi / H.
double film_flux(double depth, double viscosity, double time) {
  double flux = depth * depth * depth / 3.0;
  for (int n = 0; n < 60; ++n) {
    const double k = (n + 0.5) * std::numbers::pi / depth;
    flux -= 2.0 / (depth * std::pow(k, 4)) * std::exp(-viscosity * k * k * time);
  }
  return flux;
}

/// That of the particles in the middle of a tank so long that its ends are not felt, over the exact one.
double relative_flux(double viscosity, double time) {
  constexpr double kDepth = 0.1;
  constexpr double kSpacing = 0.01;
  Scene scene = tank(2, Vec3d(2.4, 0.0, 0.3), kSpacing, box(Vec3d::Zero(), Vec3d(2.4, 0.0, kDepth)));
  scene.gravity = Vec3d(0.5, 0.0, -9.81);
  scene.kinematic_viscosity = viscosity;
  scene.artificial_viscosity = 0.0;
  scene.faces[kZMin].slip_factor = 0.0;
  const auto simulation = start(scene);
  run_until(*simulation, time);
  const auto snapshot = simulation->snapshot();
  double flux = 0.0;
  for (std::size_t k = 0; k < snapshot->size(); ++k) {
    if (std::abs(snapshot->position[k].x() - 1.2F) < 0.2F) flux += snapshot->velocity[k].x();
  }
  flux *= kSpacing * kSpacing / 0.4;
  return flux / (0.5 / viscosity * film_flux(kDepth, viscosity, time));
}

TEST(Viscosity, FilmsFlowAsFastAsTheyShouldOverFourDecades) {
  // The times are those in which momentum spreads over the film, H^2 / nu, where that is short.
  EXPECT_NEAR(relative_flux(1e-4, 0.5), 1.0, 0.03);
  EXPECT_NEAR(relative_flux(1e-3, 0.5), 1.0, 0.03);
  EXPECT_NEAR(relative_flux(0.02, 0.5), 1.0, 0.03);
  EXPECT_NEAR(relative_flux(1.0, 0.02), 1.0, 0.03);
}

TEST(Viscosity, AThickerFluidNeverRunsFaster) {
  const auto front = [](double viscosity) {
    Scene scene = tank(2, Vec3d(1.2, 0.0, 0.6), 0.01, box(Vec3d::Zero(), Vec3d(0.2, 0.0, 0.4)));
    scene.kinematic_viscosity = viscosity;
    scene.faces[kZMin].slip_factor = 0.0;
    const auto simulation = start(scene);
    run_until(*simulation, 0.4);
    float farthest = 0.0F;
    const auto snapshot = simulation->snapshot();
    for (const Vec3f& position : snapshot->position) {
      farthest = std::max(farthest, position.x());
    }
    return farthest;
  };
  float before = front(1e-3);
  for (const double viscosity : {0.01, 0.05, 0.2}) {
    const float here = front(viscosity);
    EXPECT_LT(here, before) << viscosity << " m^2/s";
    before = here;
  }
}

TEST(Viscosity, NoSlipWallsHoldTheirLayerBackAndFreeSlipWallsDragItAlong) {
  const auto held = relative_drag<2>(channel<2>(0.0));
  const auto free = relative_drag<2>(channel<2>(1.0));
  EXPECT_GT(held[0], 0.0);
  EXPECT_LT(free[0], 0.0) << "only the faster layer above acts";
  EXPECT_NEAR(held[0], held[19], 1e-3);
  EXPECT_NEAR(free[0], free[19], 1e-3);
}

TEST(Viscosity, AtZeroNothingActs) {
  Scene scene = channel<3>(0.0);
  scene.artificial_viscosity = 0.0;
  scene.kinematic_viscosity = 0.0;
  ParticleSystem<3> particles(scene, 1);
  particles.sort_fluid();
  particles.place_boundaries(0.0);
  particles.find_neighbours();
  PressureEquation<3>(particles, false).set_source(1.0);
  const SourceTable& table = particles.table;
  const auto omega = static_cast<float>(scene.scheme.source_factor);
  for (std::uint32_t row = table.first_fluid; row < table.first_image; ++row) {
    ASSERT_FLOAT_EQ(table.source[row].x, omega * table.velocity[row].x);
  }
}

}  // namespace
}  // namespace eisph
