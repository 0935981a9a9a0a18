#include "scheme/neighbour_sums.hpp"
#include "scheme/pressure_equation.hpp"
#include "scheme/scenes.hpp"

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

/// nu lap u = -2 nu in the middle of the channel, up to the error of the lattice for shear along its axes:
/// 12 % too small in 2D, 9 % in 3D. The sources are single-precision numbers near 0.1: 1e-8 of 2e-3.
template <int Dim>
void expect_even_drag(double lattice_factor) {
  const auto drag = relative_drag<Dim>(channel<Dim>(0.0));
  for (std::size_t layer = 3; layer < 17; ++layer) {
    EXPECT_NEAR(drag[layer], lattice_factor, 1e-3) << "layer " << layer;
  }
}

TEST(Viscosity, OfAPoiseuilleProfileIsEvenAcrossTheChannel) {
  expect_even_drag<2>(0.882);
  expect_even_drag<3>(0.911);
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
