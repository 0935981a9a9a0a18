#include "boundary/mirror_planes.hpp"
#include "boundary/tank_scene.hpp"
#include "sph/pair_operators.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace eisph {
namespace {

/// A channel between two walls at z = 0 and z = layers dx, on the lattice, far from its ends: nu lap u_x of a
/// profile u_x(z) as a matrix, per layer of particles, for nu = 1. Lengths in smoothing lengths.
template <int Dim>
Eigen::MatrixXd channel_operator(int layers, double slip_factor) {
  Scene scene = tank_scene(Dim);
  scene.smoothing_ratio = 1.32;
  const double spacing = 1.0 / scene.smoothing_ratio;
  set_all_faces(scene, {FaceKind::Wall, slip_factor});
  scene.domain_max.z() = scene.domain_min.z() + layers * scene.particle_spacing;
  const MirrorPlanes<Dim> planes(scene);
  const double factor = 2.0 * (Dim + 2) * CubicSpline::normalisation<Dim>();
  const int vertical = Dim - 1;
  constexpr int kReach = 3;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(layers, layers);
  for (int i = 0; i < layers; ++i) {
    Vector<Dim, double> here{};
    here.x[vertical] = (i + 0.5) * spacing;
    // Adds the drag that unit velocity `u_j` of a particle at `there` exerts, `u_i` being that of particle i.
    const auto drag = [&](const Vector<Dim, double>& there, double u_i, double u_j) {
      const auto pair = pair_geometry<Dim, double, CubicSpline>(here, there);
      ViscousSum<Dim, double> sum;
      Vector<Dim, double> velocity_i{};
      Vector<Dim, double> velocity_j{};
      velocity_i.x[0] = u_i;
      velocity_j.x[0] = u_j;
      sum.add(pair, std::pow(spacing, Dim), velocity_i, velocity_j);
      return factor * sum.value.x[0];
    };
    for (int j = 0; j < layers; ++j) {
      for (int a = -kReach; a <= kReach; ++a) {
        for (int b = Dim == 3 ? -kReach : 0; b <= (Dim == 3 ? kReach : 0); ++b) {
          Vector<Dim, double> there{};
          there.x[0] = a * spacing;
          if constexpr (Dim == 3) there.x[1] = b * spacing;
          there.x[vertical] = (j + 0.5) * spacing;
          matrix(i, i) += drag(there, 1.0, 0.0);
          matrix(i, j) += drag(there, 0.0, 1.0);
          // Far from the side walls, which do not matter here; only the height makes images.
          Float4 at{10.0F, 10.0F, 10.0F, 0.0F};
          (&at.x)[vertical] = static_cast<float>(there.x[vertical]);
          planes.for_images(at, [&](std::uint8_t code) {
            const auto& image = planes.image(code);
            Vector<Dim, double> mirrored = there;
            mirrored.x[vertical] = image.scale[vertical] * there.x[vertical] + image.shift[vertical];
            matrix(i, i) += drag(mirrored, 1.0, 0.0);
            matrix(i, j) += drag(mirrored, 0.0, image.velocity[0]);
          });
        }
      }
    }
  }
  return matrix;
}

/// Largest difference between the steady profile under a body force 1 and z (H - z) / 2, over H^2 / 8.
template <int Dim>
double poiseuille_error(int layers) {
  const double spacing = 1.0 / 1.32;
  const double height = layers * spacing;
  const Eigen::VectorXd force = Eigen::VectorXd::Constant(layers, -1.0);
  const Eigen::VectorXd profile = channel_operator<Dim>(layers, 0.0).fullPivLu().solve(force);
  double worst = 0.0;
  for (int k = 0; k < layers; ++k) {
    const double z = (k + 0.5) * spacing;
    worst = std::max(worst, std::abs(profile[k] - 0.5 * z * (height - z)));
  }
  return worst / (height * height / 8.0);
}

TEST(Poiseuille, TheSteadyProfileBetweenNoSlipWallsIsTheParabola) {
  // The term is 12 % (2D) or 9 % (3D) too small for shear along the lattice, so the speed is that much too
  // large; what the walls add is of first order in dx/H.
  EXPECT_LT(poiseuille_error<2>(20), 0.16);
  EXPECT_LT(poiseuille_error<3>(20), 0.13);
}

TEST(Poiseuille, TheTermIsEvenAcrossTheChannelAwayFromTheWalls) {
  // The analytical profile gives -nu lap u = const; within a support radius of the walls the odd
  // continuation of the images bends the other way.
  const int layers = 20;
  const double spacing = 1.0 / 1.32;
  Eigen::VectorXd profile(layers);
  for (int k = 0; k < layers; ++k) {
    const double z = (k + 0.5) * spacing;
    profile[k] = 0.5 * z * (layers * spacing - z);
  }
  const Eigen::VectorXd flat = channel_operator<2>(layers, 0.0) * profile;
  const Eigen::VectorXd deep = channel_operator<3>(layers, 0.0) * profile;
  for (int k = 3; k < layers - 3; ++k) {
    EXPECT_NEAR(flat[k], flat[layers / 2], 1e-9);
    EXPECT_NEAR(deep[k], deep[layers / 2], 1e-9);
  }
  EXPECT_NEAR(flat[layers / 2], -1.0, 0.13);
  EXPECT_NEAR(deep[layers / 2], -1.0, 0.10);
}

TEST(Poiseuille, FreeSlipWallsExertNoDrag) {
  const Eigen::VectorXd drag = channel_operator<3>(8, 1.0) * Eigen::VectorXd::Ones(8);
  EXPECT_LT(drag.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Poiseuille, DragGrowsFromFreeSlipToNoSlip) {
  const Eigen::VectorXd uniform = Eigen::VectorXd::Ones(8);
  double before = 0.0;
  for (const double slip_factor : {0.75, 0.5, 0.25, 0.0}) {
    const double drag = -(channel_operator<3>(8, slip_factor) * uniform).sum();
    EXPECT_GT(drag, before) << "slip factor " << slip_factor;
    before = drag;
  }
}

}  // namespace
}  // namespace eisph
