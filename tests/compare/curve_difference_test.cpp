#include "compare/curve_difference.hpp"

#include "compare/convergence.hpp"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsNan;

const double kNone = std::nan("");

TEST(CurveDifference, HasTheNormsAtTheReferencesPoints) {
  const Curve model{{0.0, 10.0}, {0.0, 10.0}};
  const Curve reference{{1.0, 2.0, 4.0}, {2.0, 2.0, 1.0}};  // differences -1, 0, 3
  const CurveDifference difference = curve_difference(model, reference);
  EXPECT_EQ(difference.points, 3U);
  EXPECT_DOUBLE_EQ(difference.relative_l2, std::sqrt(10.0 / 9.0));
  EXPECT_DOUBLE_EQ(difference.rms, std::sqrt(10.0 / 3.0));
  EXPECT_DOUBLE_EQ(difference.bias, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(difference.max_abs, 3.0);
}

TEST(CurveDifference, LeavesOutWhatIsOutsideOrDry) {
  const Curve model{{0.0, 1.0, 2.0, 3.0}, {1.0, 1.0, kNone, 1.0}};
  const Curve reference{{-1.0, 0.5, 1.5, 3.0, 3.5}, {9.0, 2.0, 9.0, kNone, 9.0}};
  const CurveDifference difference = curve_difference(model, reference);
  EXPECT_EQ(difference.points, 1U);
  EXPECT_DOUBLE_EQ(difference.rms, 1.0);
}

TEST(CurveDifference, IsNotANumberWithoutCommonPoints) {
  const CurveDifference difference = curve_difference(Curve{{0.0, 1.0}, {0.0, 1.0}}, Curve{{2.0}, {1.0}});
  EXPECT_EQ(difference.points, 0U);
  EXPECT_THAT(difference.rms, IsNan());
  EXPECT_THAT(difference.relative_l2, IsNan());
}

TEST(BandShare, CountsThePointsInsideAndOnEitherSide) {
  const Curve model{{0.0, 4.0}, {0.0, 4.0}};
  const Curve lower{{0.0, 1.0, 2.0, 3.0, 5.0}, {0.0, 2.0, 1.0, 1.0, 0.0}};
  const Curve upper{{0.0, 1.0, 2.0, 3.0, 5.0}, {1.0, 3.0, 3.0, 2.0, 9.0}};
  const BandShare share = band_share(model, lower, upper);
  EXPECT_EQ(share.points, 4U);
  EXPECT_DOUBLE_EQ(share.inside, 0.5);
  EXPECT_DOUBLE_EQ(share.below, 0.25);
  EXPECT_DOUBLE_EQ(share.above, 0.25);
  EXPECT_THROW((void)band_share(model, lower, Curve{{0.0}, {1.0}}), std::invalid_argument);
  EXPECT_THAT(band_share(Curve{}, lower, upper).inside, IsNan());
}

Curve wave(double delay) {
  Curve curve;
  for (int k = -400; k <= 1400; ++k) {
    const double x = 0.005 * k;
    curve.add(x + delay, 2.0 + std::sin(3.0 * x) + x * x);
  }
  return curve;
}

TEST(BestShift, FindsADelay) {
  Curve reference;
  const Curve truth = wave(0.0);
  for (const double x : {0.0, 0.4, 1.1, 1.7, 2.3, 3.0}) reference.add(x, value_at(truth, x));
  const ShiftedDifference best = best_shift(wave(0.123), reference, -0.3, 0.3);
  EXPECT_NEAR(best.shift, -0.123, 1e-4);
  EXPECT_NEAR(best.difference.relative_l2, 0.0, 1e-4);
  EXPECT_EQ(best.difference.points, 6U);
}

TEST(BestShift, StaysInTheRangeAllowed) {
  const ShiftedDifference best = best_shift(wave(0.5), restricted(wave(0.0), 0.0, 3.0), -0.2, 0.1);
  EXPECT_NEAR(best.shift, -0.2, 1e-9);
}

TEST(BestShift, JudgesAllShiftsByTheSamePoints) {
  // Without a shift all four points are in range, shifted by -1 only three: the first, which is far off, is
  // lost.
  const Curve model{{0.0, 1.0, 2.0, 3.0}, {5.0, 1.0, 1.0, 1.0}};
  const Curve reference{{0.0, 1.0, 2.0, 3.0}, {1.0, 1.0, 1.0, 1.0}};
  const ShiftedDifference best = best_shift(model, reference, -1.0, 1.0);
  EXPECT_EQ(best.difference.points, 2U);  // 1 and 2 are in range at every shift
  EXPECT_LE(best.shift, 0.0);             // as well met at 0 as at -1
  EXPECT_DOUBLE_EQ(best.difference.rms, 0.0);
}

TEST(BestShift, IsNotANumberWithoutCommonPoints) {
  EXPECT_THAT(best_shift(Curve{{0.0, 1.0}, {0.0, 1.0}}, Curve{{5.0}, {1.0}}, -0.1, 0.1).shift, IsNan());
  EXPECT_THAT(best_shift(Curve{}, Curve{{5.0}, {1.0}}, -0.1, 0.1).shift, IsNan());
}

TEST(ProfileDifference, IsVerticalAndToTheNearestPoint) {
  const Curve surface{{0.0, 1.0, 2.0}, {1.0, 1.0, 2.0}};
  const std::vector<PlanePoint> points{{0.0, 1.0}, {1.0, 1.0}, {2.0, 2.0}, {1.0, 0.5}};
  // Vertical: 0.5 at (0.5, 0.5), -0.4 at (1, 1.4); (3, 2) is outside. Nearest: (1, 0.5), (1, 1), (2, 2).
  const ProfileDifference difference =
      profile_difference({{0.5, 0.5}, {1.0, 1.4}, {3.0, 2.0}}, surface, points);
  EXPECT_EQ(difference.points, 2U);
  EXPECT_NEAR(difference.vertical_rms, std::sqrt((0.25 + 0.16) / 2.0), 1e-12);
  EXPECT_NEAR(difference.vertical_bias, 0.05, 1e-12);
  EXPECT_NEAR(difference.nearest_rms, std::sqrt((0.25 + 0.16 + 1.0) / 3.0), 1e-12);
}

TEST(ProfileDifference, TakesTheCornersOfTheSurfaceWithoutPoints) {
  const ProfileDifference difference =
      profile_difference({{0.0, 0.0}}, Curve{{0.0, 1.0, 3.0}, {kNone, 1.0, 4.0}});
  EXPECT_EQ(difference.points, 0U);
  EXPECT_THAT(difference.vertical_rms, IsNan());
  EXPECT_NEAR(difference.nearest_rms, std::sqrt(2.0), 1e-12);
}

TEST(ObservedOrder, IsExactForAPowerLaw) {
  const ConvergenceOrder order = observed_order({0.01, 0.04, 0.02}, {3e-4, 48e-4, 12e-4});
  EXPECT_NEAR(order.least_squares, 2.0, 1e-12);
  EXPECT_THAT(order.pairwise, ElementsAre(DoubleNear(2.0, 1e-12), DoubleNear(2.0, 1e-12)));
}

TEST(ObservedOrder, ListsThePairsFromCoarseToFine) {
  const ConvergenceOrder order = observed_order({4.0, 2.0, 1.0}, {8.0, 4.0, 1.0});
  EXPECT_THAT(order.pairwise, ElementsAre(DoubleNear(1.0, 1e-12), DoubleNear(2.0, 1e-12)));
  EXPECT_NEAR(order.least_squares, 1.5, 1e-12);
}

TEST(ObservedOrder, RefusesWhatHasNone) {
  EXPECT_THROW((void)observed_order({1.0}, {1.0}), std::invalid_argument);
  EXPECT_THROW((void)observed_order({1.0, 2.0}, {1.0}), std::invalid_argument);
  EXPECT_THROW((void)observed_order({1.0, 2.0}, {1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW((void)observed_order({1.0, 1.0}, {1.0, 2.0}), std::invalid_argument);
}

}  // namespace
}  // namespace eisph
