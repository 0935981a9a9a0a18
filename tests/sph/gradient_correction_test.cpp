#include "sph/gradient_correction.hpp"

#include "sph/lattice_cloud.hpp"

#include <random>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// A disordered neighbourhood, cut off on one side if asked.
template <int Dim>
LatticeCloud<Dim> disordered(bool half) {
  LatticeCloud<Dim> cloud;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  std::vector<Vector<Dim, double>> nodes;
  for (Vector<Dim, double> node : cloud.nodes) {
    bool centre = true;
    for (int d = 0; d < Dim; ++d) centre = centre && node.x[d] == 0.0;
    for (int d = 0; d < Dim && !centre; ++d) node.x[d] += cloud.spacing * shift(generator);
    if (!half || node.x[Dim - 1] <= 0.0) nodes.push_back(node);
  }
  cloud.nodes = nodes;
  return cloud;
}

template <int Dim>
double linear_field(const Vector<Dim, double>& at) {
  constexpr double kSlopes[] = {0.7, -1.3, 2.1};
  double value = 4.0;
  for (int d = 0; d < Dim; ++d) value += kSlopes[d] * at.x[d];
  return value;
}

template <int Dim>
void expect_exact_gradient(const LatticeCloud<Dim>& cloud) {
  MomentSum<Dim, double> moments;
  ScalarGradientSum<Dim, double> sum;
  const double origin = linear_field(Vector<Dim, double>{});
  cloud.for_pairs([&](const PairGeometry<Dim, double, CubicSpline>& pair, const Vector<Dim, double>& node) {
    moments.add(pair, cloud.volume);
    sum.add(pair, cloud.volume, linear_field(node) - origin);
  });
  const GradientCorrection<Dim> correction(moments, CubicSpline::normalisation<Dim>());
  ASSERT_TRUE(correction.regular());
  const auto gradient = correction.gradient(sum);
  constexpr double kSlopes[] = {0.7, -1.3, 2.1};
  for (int d = 0; d < Dim; ++d) EXPECT_NEAR(gradient[d], kSlopes[d], 1e-9);

  // What the gradients at both ends explain does not diffuse.
  DiffusionSum<double> diffusion;
  DiffusionSum<double> plain;
  Vector<Dim, double> gradients{};
  for (int d = 0; d < Dim; ++d) gradients.x[d] = 2.0 * gradient[d];
  cloud.for_pairs([&](const PairGeometry<Dim, double, CubicSpline>& pair, const Vector<Dim, double>& node) {
    diffusion.add(pair, cloud.volume, linear_field(node) - origin, gradients);
    plain.add(pair, cloud.volume, linear_field(node) - origin);
  });
  EXPECT_NEAR(diffusion.value, 0.0, 1e-9);
  EXPECT_GT(std::abs(plain.value), 1e-3);
}

TEST(GradientCorrection, MakesGradientsOfLinearFieldsExact) {
  expect_exact_gradient(disordered<2>(false));
  expect_exact_gradient(disordered<3>(false));
  expect_exact_gradient(disordered<2>(true));
  expect_exact_gradient(disordered<3>(true));
}

TEST(GradientCorrection, IsTheUnitMatrixWithoutNeighbours) {
  MomentSum<3, double> moments;
  ScalarGradientSum<3, double> sum;
  sum.value.x[0] = 2.0;
  const GradientCorrection<3> correction(moments, 1.0);
  EXPECT_FALSE(correction.regular());
  EXPECT_EQ(correction.gradient(sum)[0], 2.0);
}

TEST(DiffusionSum, OfASquareIsItsLaplacian) {
  // lap (x^2 + y^2) = 4, up to the error of the lattice as a quadrature: 7 per cent at h = 1.32 dx.
  const LatticeCloud<2> cloud(2.0);
  DiffusionSum<double> sum;
  cloud.for_pairs([&](const PairGeometry<2, double, CubicSpline>& pair, const Vector<2, double>& node) {
    sum.add(pair, cloud.volume, node.x[0] * node.x[0] + node.x[1] * node.x[1]);
  });
  EXPECT_NEAR(-2.0 * CubicSpline::normalisation<2>() * sum.value, 4.0, 0.1);
}

TEST(ConcentrationGradientSum, VanishesOnTheLatticeAndPointsIntoTheWaterAtItsSurface) {
  const auto gradient = [](const LatticeCloud<2>& cloud) {
    ConcentrationGradientSum<2, double> sum;
    cloud.for_pairs([&](const PairGeometry<2, double, CubicSpline>& pair, const Vector<2, double>&) {
      sum.add(pair, cloud.volume);
    });
    return sum.value;
  };
  LatticeCloud<2> cloud;
  EXPECT_NEAR(gradient(cloud).x[0], 0.0, 1e-12);
  EXPECT_NEAR(gradient(cloud).x[1], 0.0, 1e-12);
  std::erase_if(cloud.nodes, [](const Vector<2, double>& node) { return node.x[1] > 0.01; });
  EXPECT_LT(gradient(cloud).x[1], -0.1);
}

}  // namespace
}  // namespace eisph
