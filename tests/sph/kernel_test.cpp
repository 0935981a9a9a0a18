#include "core/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// The two branches as they stand in the literature.
double branch_value(double q) {
  if (q < 1.0) return 1.0 - 1.5 * q * q + 0.75 * q * q * q;
  if (q < 2.0) return 0.25 * std::pow(2.0 - q, 3);
  return 0.0;
}

/// Integral of W over all space by the midpoint rule in q, whose error is of the order of the step squared.
template <class Kernel, int Dim>
double integral() {
  constexpr int kSteps = 20000;
  constexpr double kStep = kKernelSupport / kSteps;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double q = (k + 0.5) * kStep;
    const double shell = Dim == 2 ? 2.0 * std::numbers::pi * q : 4.0 * std::numbers::pi * q * q;
    sum += Kernel::value(q) * shell * kStep;
  }
  return Kernel::template normalisation<Dim>() * sum;
}

template <class Kernel>
class KernelTest : public testing::Test {};
using Kernels = testing::Types<QuinticSpline, WendlandC2, CubicSpline>;
TYPED_TEST_SUITE(KernelTest, Kernels);

TYPED_TEST(KernelTest, IntegratesToOneInTwoAndThreeDimensions) {
  EXPECT_NEAR((integral<TypeParam, 2>()), 1.0, 1e-7);
  EXPECT_NEAR((integral<TypeParam, 3>()), 1.0, 1e-7);
}

TYPED_TEST(KernelTest, VanishesBeyondItsReach) {
  EXPECT_LE(TypeParam::kReach, kKernelSupport);
  for (const double q : {TypeParam::kReach, 2.0, 2.0001, 3.0, 1e6}) {
    EXPECT_EQ(TypeParam::value(q), 0.0) << "q = " << q;
    EXPECT_EQ(TypeParam::derivative(q), 0.0) << "q = " << q;
  }
}

TYPED_TEST(KernelTest, DerivativeEqualsCentralDifferences) {
  // Third derivatives are at most 15 and jump by 6 at most, those of the quintic spline (in units of its 66
  // at q = 0) likewise: the difference quotient over 2e-5 is off by less than 1e-9 of that, cancellation adds
  // 1e-11.
  constexpr double kStep = 1e-5;
  for (int k = 1; k <= 220; ++k) {
    const double q = 0.01 * k + 0.003;  // not at knots
    const double difference = (TypeParam::value(q + kStep) - TypeParam::value(q - kStep)) / (2.0 * kStep);
    EXPECT_NEAR(TypeParam::derivative(q), difference, 2e-9 * TypeParam::value(0.0)) << "q = " << q;
    EXPECT_NEAR(TypeParam::gradient(q, 1.0 / q) * q, difference, 2e-9 * TypeParam::value(0.0)) << "q = " << q;
  }
}

TYPED_TEST(KernelTest, FallsMonotonically) {
  for (double q = 0.01; q < TypeParam::kReach - 0.005; q += 0.01) {
    EXPECT_LT(TypeParam::derivative(q), 0.0) << "q = " << q;
  }
}

TYPED_TEST(KernelTest, IsFoundByItsChoiceAtRunTime) {
  const KernelKind kind = std::is_same_v<TypeParam, WendlandC2>    ? KernelKind::WendlandC2
                          : std::is_same_v<TypeParam, CubicSpline> ? KernelKind::CubicSpline
                                                                   : KernelKind::QuinticSpline;
  EXPECT_TRUE(with_kernel(kind, [](auto kernel) { return std::is_same_v<decltype(kernel), TypeParam>; }));
  EXPECT_EQ(kernel_normalisation<2>(kind), TypeParam::template normalisation<2>());
  EXPECT_EQ(kernel_normalisation<3>(kind), TypeParam::template normalisation<3>());
}

/// Hankel transforms of kernels of positive type are positive: particles do not gain by pairing (Dehnen & Aly
/// 2012, section 2.3). In three dimensions W^(k) = 4 pi / k * integral of W(q) sin(k q) q dq.
template <class Kernel>
double smallest_transform() {
  constexpr int kSteps = 4000;
  constexpr double kStep = kKernelSupport / kSteps;
  double smallest = 1.0;
  for (int n = 1; n <= 200; ++n) {
    const double wave_number = 0.1 * n;
    double sum = 0.0;
    for (int k = 0; k < kSteps; ++k) {
      const double q = (k + 0.5) * kStep;
      sum += Kernel::value(q) * std::sin(wave_number * q) * q * kStep;
    }
    const double factor = 4.0 * std::numbers::pi * Kernel::template normalisation<3>() / wave_number;
    smallest = std::min(smallest, factor * sum);
  }
  return smallest;
}

TEST(Kernels, ThatOfWendlandHasNoNegativeFourierComponents) {
  EXPECT_GT(smallest_transform<WendlandC2>(), 0.0);
  EXPECT_LT(smallest_transform<CubicSpline>(), 0.0);
}

/// By how much the number density of the square lattice changes when it is stretched by a tenth at constant
/// area.
template <class Kernel>
double lattice_stiffness(double smoothing_ratio) {
  const double stretch = 1.1;
  double change = 0.0;
  for (int i = -5; i <= 5; ++i) {
    for (int j = -5; j <= 5; ++j) {
      const double at_rest = std::hypot(i, j) / smoothing_ratio;
      const double stretched = std::hypot(stretch * i, j / stretch) / smoothing_ratio;
      change += Kernel::value(stretched) - Kernel::value(at_rest);
    }
  }
  return Kernel::template normalisation<2>() * change / (smoothing_ratio * smoothing_ratio);
}

TEST(Kernels, TheQuinticSplineFeelsTheShapeOfTheLatticeLeast) {
  EXPECT_LT(std::abs(lattice_stiffness<QuinticSpline>(1.4)), 2e-4);
  EXPECT_GT(std::abs(lattice_stiffness<WendlandC2>(1.4)), 1e-3);
  EXPECT_GT(std::abs(lattice_stiffness<CubicSpline>(1.4)), 5e-4);
}

TEST(WendlandC2, HasTheKnownValues) {
  EXPECT_DOUBLE_EQ(WendlandC2::value(0.0), 1.0);
  EXPECT_DOUBLE_EQ(WendlandC2::value(1.0), 3.0 / 16.0);
  EXPECT_DOUBLE_EQ(WendlandC2::derivative(1.0), -5.0 / 8.0);
}

TEST(QuinticSpline, HasTheKnownValues) {
  // 3^5 - 6 x 2^5 + 15, and 2^5 - 6 at s = 1 (Morris, Fox & Zhu 1997), and the term that ends it at 1.8.
  const auto term = [](double q) { return 0.06075 * (q * q - 3.24) / 3.6 - 0.00243; };
  EXPECT_NEAR(QuinticSpline::value(0.0), 66.0 + term(0.0), 1e-12);
  EXPECT_NEAR(QuinticSpline::value(2.0 / 3.0), 26.0 + term(2.0 / 3.0), 1e-12);
  EXPECT_NEAR(QuinticSpline::value(4.0 / 3.0), 1.0 + term(4.0 / 3.0), 1e-12);
  EXPECT_NEAR(QuinticSpline::derivative(2.0 / 3.0), 1.5 * -50.0 + 0.06075 * 2.0 / 3.0 / 1.8, 1e-12);
}

TEST(CubicSpline, EqualsTheTwoBranchForm) {
  for (int k = 0; k <= 250; ++k) {
    const double q = 0.01 * k;
    EXPECT_NEAR(CubicSpline::value(q), branch_value(q), 1e-15) << "q = " << q;
  }
}

TEST(CubicSpline, HasTheKnownValuesAtTheKnots) {
  EXPECT_DOUBLE_EQ(CubicSpline::value(0.0), 1.0);
  EXPECT_DOUBLE_EQ(CubicSpline::value(1.0), 0.25);
  EXPECT_DOUBLE_EQ(CubicSpline::value(2.0), 0.0);
  EXPECT_DOUBLE_EQ(CubicSpline::derivative(0.0), 0.0);
  EXPECT_DOUBLE_EQ(CubicSpline::derivative(1.0), -0.75);
  EXPECT_DOUBLE_EQ(CubicSpline::derivative(2.0), 0.0);
}

}  // namespace
}  // namespace eisph
