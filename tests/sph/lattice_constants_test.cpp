#include "sph/lattice_constants.hpp"

#include "sph/lattice_cloud.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(LatticeConstants, HaveTheKnownSumsAtASmoothingRatioOf132) {
  // The figures of the effective speed of sound, given to three digits.
  EXPECT_NEAR(lattice_constants<2>(KernelKind::CubicSpline, kSmoothingRatio).laplacian, 4.38, 0.005);
  EXPECT_NEAR(lattice_constants<3>(KernelKind::CubicSpline, kSmoothingRatio).laplacian, 5.28, 0.005);
}

TEST(LatticeConstants, CountTheNodesWithinTheSupport) {
  // Nodes of the unit lattice closer than 2.64: 8 + 12 in the plane without the centre, 80 in space (norms
  // squared 1, 2, 3, 4, 5, 6: 6 + 12 + 8 + 6 + 24 + 24).
  EXPECT_EQ(lattice_constants<2>(KernelKind::CubicSpline, kSmoothingRatio).neighbours, 20);
  EXPECT_EQ(lattice_constants<3>(KernelKind::CubicSpline, kSmoothingRatio).neighbours, 80);
}

TEST(LatticeConstants, NumberDensityIsNearOne) {
  // The sum over the lattice is a quadrature of the kernel's integral: off by 0.2 % in 2D, 0.3 % in 3D.
  EXPECT_NEAR(lattice_constants<2>(KernelKind::CubicSpline, kSmoothingRatio).number_density, 1.0, 0.004);
  EXPECT_NEAR(lattice_constants<3>(KernelKind::CubicSpline, kSmoothingRatio).number_density, 1.0, 0.004);
}

template <int Dim>
void expect_plain_sums() {
  const LatticeCloud<Dim> cloud;
  double density = 0.0;
  double laplacian = 0.0;
  cloud.for_pairs([&](const PairGeometry<Dim, double, CubicSpline>&, const Vector<Dim, double>& node) {
    double squared = 0.0;
    for (int d = 0; d < Dim; ++d) squared += node.x[d] * node.x[d];
    const double q = std::sqrt(squared);
    density += std::pow(cloud.spacing, Dim) * CubicSpline::value(q);
    // -2 V_j x_ij . grad W_ij / r^2
    if (q > 0.0) laplacian -= 2.0 * std::pow(cloud.spacing, Dim) * CubicSpline::derivative(q) / q;
  });
  // r = 1e-6 h, which stands for zero, is felt in the eighth digit.
  const LatticeConstants constants = lattice_constants<Dim>(KernelKind::CubicSpline, kSmoothingRatio);
  EXPECT_NEAR(constants.number_density, CubicSpline::normalisation<Dim>() * density, 1e-7);
  EXPECT_NEAR(constants.laplacian, CubicSpline::normalisation<Dim>() * laplacian, 1e-7);
}

TEST(LatticeConstants, EqualPlainSumsOverTheLattice) {
  expect_plain_sums<2>();
  expect_plain_sums<3>();
}

}  // namespace
}  // namespace eisph
