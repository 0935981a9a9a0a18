#include "sph/pair_operators.hpp"

#include "sph/lattice_cloud.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace eisph {
namespace {

// The operators at one node of the undisturbed lattice, where the kernel's sums differ from its integrals by
// the error of the lattice as a quadrature. Lengths are in smoothing lengths, so h = 1.

template <int Dim>
double alpha() {
  return CubicSpline::normalisation<Dim>();
}

/// sum V_j (s_j - s_i) . grad W_ij
template <int Dim, class Field>
double divergence(const LatticeCloud<Dim>& cloud, const Field& field) {
  DivergenceSum<double> sum;
  const Vector<Dim, double> origin{};
  cloud.for_pairs([&](const PairGeometry<Dim, double, CubicSpline>& pair, const Vector<Dim, double>& node) {
    sum.add(pair, cloud.volume, field(origin), field(node));
  });
  return alpha<Dim>() * sum.value;
}

/// sum V_j (P_i + P_j) grad W_ij
template <int Dim, class Field>
Vector<Dim, double> pressure_gradient(const LatticeCloud<Dim>& cloud, const Field& field) {
  PressureGradientSum<Dim, double> sum;
  const Vector<Dim, double> origin{};
  cloud.for_pairs([&](const PairGeometry<Dim, double, CubicSpline>& pair, const Vector<Dim, double>& node) {
    sum.add(pair, cloud.volume, field(origin), field(node));
  });
  for (int d = 0; d < Dim; ++d) sum.value.x[d] *= alpha<Dim>();
  return sum.value;
}

/// sum A_ij (P_i - P_j) for a density of one
template <int Dim, class Field>
double pressure_laplacian(const LatticeCloud<Dim>& cloud, const Field& field) {
  LaplacianSums<double> sums;
  cloud.for_pairs([&](const PairGeometry<Dim, double, CubicSpline>& pair, const Vector<Dim, double>& node) {
    sums.add(pair, cloud.volume, field(node));
  });
  return 2.0 * alpha<Dim>() * (sums.coefficient * field(Vector<Dim, double>{}) - sums.pressure);
}

/// The viscous term for a kinematic viscosity of one.
template <int Dim, class Field>
Vector<Dim, double> viscous_term(const LatticeCloud<Dim>& cloud, const Field& field) {
  ViscousSum<Dim, double> sum;
  const Vector<Dim, double> origin{};
  cloud.for_pairs([&](const PairGeometry<Dim, double, CubicSpline>& pair, const Vector<Dim, double>& node) {
    sum.add(pair, cloud.volume, field(origin), field(node));
  });
  for (int d = 0; d < Dim; ++d) sum.value.x[d] *= 2.0 * (Dim + 2) * alpha<Dim>();
  return sum.value;
}

/// Linear in position, with the trace 0.3 + 1.1 (+ 0.7).
template <int Dim>
Vector<Dim, double> linear_vector(const Vector<Dim, double>& at) {
  constexpr std::array<std::array<double, 3>, 3> kMatrix = {
      {{0.3, -2.0, 0.5}, {4.0, 1.1, -0.4}, {0.9, 1.5, 0.7}}};
  Vector<Dim, double> value{};
  for (std::size_t r = 0; r < Dim; ++r) {
    value.x[r] = 5.0;
    for (std::size_t c = 0; c < Dim; ++c) value.x[r] += kMatrix[r][c] * at.x[c];
  }
  return value;
}

template <int Dim>
double sum_of_squares(const Vector<Dim, double>& at) {
  double sum = 7.0;
  for (int d = 0; d < Dim; ++d) sum += at.x[d] * at.x[d];
  return sum;
}

template <int Dim>
void expect_first_derivatives(double tolerance) {
  const LatticeCloud<Dim> cloud;
  const double trace = Dim == 2 ? 1.4 : 2.1;
  EXPECT_NEAR(divergence(cloud, linear_vector<Dim>), trace, tolerance * trace);
  const std::array<double, 3> slope = {1.5, -0.8, 2.2};
  const auto gradient = pressure_gradient(cloud, [&](const Vector<Dim, double>& at) {
    double value = 40.0;
    for (int d = 0; d < Dim; ++d) value += slope[static_cast<std::size_t>(d)] * at.x[d];
    return value;
  });
  for (int d = 0; d < Dim; ++d) {
    const double expected = slope[static_cast<std::size_t>(d)];
    EXPECT_NEAR(gradient.x[d], expected, tolerance * std::abs(expected)) << "component " << d;
  }
}

TEST(PairOperators, FirstDerivativesOfLinearFieldsAreWithinTheErrorOfTheLattice) {
  expect_first_derivatives<2>(0.02);
  expect_first_derivatives<3>(0.02);
}

TEST(PairOperators, FirstDerivativesOfConstantFieldsVanish) {
  const LatticeCloud<3> cloud;
  const auto gradient = pressure_gradient(cloud, [](const Vector<3, double>&) { return 1000.0; });
  for (const double component : gradient.x) EXPECT_NEAR(component, 0.0, 1e-9);
  const Vector<3, double> uniform{{3.0, -2.0, 1.0}};
  EXPECT_EQ(divergence(cloud, [&](const Vector<3, double>&) { return uniform; }), 0.0);
}

template <int Dim>
void expect_laplacian(double tolerance) {
  const LatticeCloud<Dim> cloud;
  EXPECT_NEAR(pressure_laplacian(cloud, sum_of_squares<Dim>), 2.0 * Dim, tolerance * 2.0 * Dim);
  // Symmetry makes it vanish on linear fields; only round-off of the differences of 100 is left.
  EXPECT_NEAR(pressure_laplacian(cloud, [](const Vector<Dim, double>& at) { return 100.0 + at.x[0]; }), 0.0,
              1e-10);
}

TEST(PairOperators, PressureLaplacianOfAQuadraticIsWithinTheErrorOfTheLattice) {
  expect_laplacian<2>(0.02);
  expect_laplacian<3>(0.02);
}

/// The viscous term over nu of the plane shear u = z^2 e_x, whose Laplacian is 2 e_x.
template <int Dim>
double aligned_shear(const LatticeCloud<Dim>& cloud) {
  const auto term = viscous_term(cloud, [](const Vector<Dim, double>& at) {
    Vector<Dim, double> u{};
    u.x[0] = at.x[Dim - 1] * at.x[Dim - 1];
    return u;
  });
  for (int d = 1; d < Dim; ++d) EXPECT_NEAR(term.x[d], 0.0, 1e-12) << "across the flow";
  return term.x[0];
}

/// Of the same flow turned by 45 degrees in the plane of x and z: its component along the flow.
template <int Dim>
double turned_shear(const LatticeCloud<Dim>& cloud) {
  const auto term = viscous_term(cloud, [](const Vector<Dim, double>& at) {
    const double across = (at.x[Dim - 1] - at.x[0]) * std::sqrt(0.5);
    Vector<Dim, double> u{};
    u.x[0] = u.x[Dim - 1] = across * across * std::sqrt(0.5);
    return u;
  });
  EXPECT_NEAR(term.x[0], term.x[Dim - 1], 1e-12);
  return (term.x[0] + term.x[Dim - 1]) * std::sqrt(0.5);
}

/// Mean over all orientations of the flow to the lattice. The sums form a tensor of fourth order with the
/// symmetry of the lattice, whose mean shear modulus follows from two of its components (Voigt).
template <int Dim>
double mean_shear(const LatticeCloud<Dim>& cloud) {
  const double aligned = aligned_shear(cloud);
  const double turned = turned_shear(cloud);
  return Dim == 2 ? 0.5 * (aligned + turned) : 0.6 * aligned + 0.4 * turned;
}

TEST(PairOperators, ViscousTermOfAShearProfileIsTheLaplacianOverAllOrientations) {
  // The factor 2 (D + 2). What is left is the error of the lattice as a quadrature: 1.3 % and 0.1 %.
  EXPECT_NEAR(mean_shear(LatticeCloud<2>()), 2.0, 0.02 * 2.0);
  EXPECT_NEAR(mean_shear(LatticeCloud<3>()), 2.0, 0.005 * 2.0);
}

TEST(PairOperators, ViscousTermDependsOnTheOrientationOfTheLatticeByLessThanASixth) {
  // With about one shell and a half of neighbours the lattice is not isotropic to fourth order: the term is
  // 12 % (2D) and 9 % (3D) too small for shear along its axes, 14 % and 13 % too large for shear across them.
  for (const double shear : {aligned_shear(LatticeCloud<2>()), turned_shear(LatticeCloud<2>()),
                             aligned_shear(LatticeCloud<3>()), turned_shear(LatticeCloud<3>())}) {
    EXPECT_NEAR(shear, 2.0, 2.0 / 6.0);
  }
  // More neighbours make it so.
  for (const double shear : {aligned_shear(LatticeCloud<2>(4.0)), turned_shear(LatticeCloud<2>(4.0)),
                             aligned_shear(LatticeCloud<3>(4.0)), turned_shear(LatticeCloud<3>(4.0))}) {
    EXPECT_NEAR(shear, 2.0, 0.01 * 2.0);
  }
}

TEST(PairOperators, ViscousTermVanishesForUniformAndRigidlyTurningFlow) {
  const LatticeCloud<2> cloud;
  const auto turning = viscous_term(cloud, [](const Vector<2, double>& at) {
    return Vector<2, double>{{3.0 - 2.0 * at.x[1], 2.0 * at.x[0]}};
  });
  EXPECT_NEAR(turning.x[0], 0.0, 1e-12);
  EXPECT_NEAR(turning.x[1], 0.0, 1e-12);
}

TEST(PairOperators, OfParticlesAtTheSamePlaceAreZeroOrFinite) {
  const Vector<3, double> here{{0.3, 0.2, -0.1}};
  const auto pair = pair_geometry<3, double, CubicSpline>(here, here);
  PressureGradientSum<3, double> gradient;
  gradient.add(pair, 1.0, 1e5, 1e5);
  DivergenceSum<double> divergence_sum;
  divergence_sum.add(pair, 1.0, Vector<3, double>{{1.0, 2.0, 3.0}}, Vector<3, double>{{1.0, 2.0, 3.0}});
  ViscousSum<3, double> viscous;
  viscous.add(pair, 1.0, Vector<3, double>{{1.0, 2.0, 3.0}}, Vector<3, double>{{-1.0, 0.0, 5.0}});
  LaplacianSums<double> laplacian;
  laplacian.add(pair, 1.0, 1e5);
  for (const double component : gradient.value.x) EXPECT_EQ(component, 0.0);
  EXPECT_EQ(divergence_sum.value, 0.0);
  for (const double component : viscous.value.x) EXPECT_EQ(component, 0.0);
  EXPECT_NEAR(laplacian.coefficient, -3.0, 1e-4) << "the limit of (dW/dq)/q / alpha";
}

}  // namespace
}  // namespace eisph
