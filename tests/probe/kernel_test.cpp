#include "probe/kernel.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(AxisSpline, AddsUpToTheNumberOfSamplesPerUnit) {
  for (const int samples : {1, 2, 3}) {
    for (const double start : {0.0, 0.1, 0.37, 0.5}) {
      double sum = 0.0;
      for (int k = -10; k <= 10; ++k) sum += axis_spline(start + static_cast<double>(k) / samples);
      EXPECT_NEAR(sum, samples, 1e-14) << start;
    }
  }
}

TEST(AxisSpline, HasItsIntegralBeyondAPlace) {
  for (const double from : {-2.5, -1.5, -0.3, 0.0, 0.4, 1.0, 1.7, 2.0}) {
    constexpr int kSteps = 20000;
    double sum = 0.0;
    for (int k = 0; k < kSteps; ++k) sum += axis_spline(from + (k + 0.5) * 5.0 / kSteps) * 5.0 / kSteps;
    EXPECT_NEAR(axis_spline_beyond(from), sum, 1e-7) << from;
  }
}

}  // namespace
}  // namespace eisph
