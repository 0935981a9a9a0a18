#include "core/kernel.hpp"

#include <cmath>
#include <numbers>

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
template <int Dim>
double integral() {
  constexpr int kSteps = 20000;
  constexpr double kStep = kKernelSupport / kSteps;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double q = (k + 0.5) * kStep;
    const double shell = Dim == 2 ? 2.0 * std::numbers::pi * q : 4.0 * std::numbers::pi * q * q;
    sum += CubicSpline::value(q) * shell * kStep;
  }
  return CubicSpline::normalisation<Dim>() * sum;
}

TEST(CubicSpline, IntegratesToOneInTwoAndThreeDimensions) {
  EXPECT_NEAR(integral<2>(), 1.0, 1e-7);
  EXPECT_NEAR(integral<3>(), 1.0, 1e-7);
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

TEST(CubicSpline, VanishesBeyondTheSupport) {
  for (const double q : {2.0, 2.0001, 3.0, 1e6}) {
    EXPECT_EQ(CubicSpline::value(q), 0.0) << "q = " << q;
    EXPECT_EQ(CubicSpline::derivative(q), 0.0) << "q = " << q;
  }
}

TEST(CubicSpline, DerivativeEqualsCentralDifferences) {
  // The third derivative is at most 4.5 and jumps by 6 at q = 1: the difference quotient over 2e-5 is off by
  // less than 1e-9 and cancellation adds 1e-11.
  constexpr double kStep = 1e-5;
  for (int k = 1; k <= 220; ++k) {
    const double q = 0.01 * k;
    const double difference = (CubicSpline::value(q + kStep) - CubicSpline::value(q - kStep)) / (2.0 * kStep);
    EXPECT_NEAR(CubicSpline::derivative(q), difference, 1e-9) << "q = " << q;
  }
}

TEST(CubicSpline, FallsMonotonically) {
  for (int k = 1; k < 200; ++k) EXPECT_LT(CubicSpline::derivative(0.01 * k), 0.0) << "q = " << 0.01 * k;
}

}  // namespace
}  // namespace eisph
