#include "compare/curve.hpp"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::DoubleEq;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsNan;

const double kNone = std::nan("");

TEST(Curve, IsJoinedByStraightLines) {
  const Curve curve{{1.0, 2.0, 4.0}, {10.0, 20.0, 0.0}};
  EXPECT_DOUBLE_EQ(value_at(curve, 1.0), 10.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 1.25), 12.5);
  EXPECT_DOUBLE_EQ(value_at(curve, 3.0), 10.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 4.0), 0.0);
}

TEST(Curve, HasNoValueOutsideItsRangeAndInGaps) {
  const Curve curve{{1.0, 2.0, 3.0, 4.0}, {10.0, kNone, 30.0, 40.0}};
  EXPECT_THAT(value_at(curve, 0.99), IsNan());
  EXPECT_THAT(value_at(curve, 4.01), IsNan());
  EXPECT_THAT(value_at(curve, kNone), IsNan());
  EXPECT_THAT(value_at(curve, 1.5), IsNan());
  EXPECT_THAT(value_at(curve, 2.5), IsNan());
  EXPECT_DOUBLE_EQ(value_at(curve, 3.0), 30.0);
  EXPECT_THAT(value_at(Curve{}, 1.0), IsNan());
}

TEST(Curve, IsMadeFromPointsInAnyOrder) {
  const Curve curve = make_curve({3.0, 1.0, 2.0, 1.0}, {30.0, 8.0, 20.0, 12.0});
  EXPECT_THAT(curve.x, ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(curve.y, ElementsAre(10.0, 20.0, 30.0));
  EXPECT_THROW((void)make_curve({1.0}, {}), std::invalid_argument);
}

TEST(Curve, IsScaledAndShifted) {
  const Curve curve = shifted(scaled({{1.0, 2.0}, {3.0, 4.0}}, 10.0, -2.0), 0.5, 1.0);
  EXPECT_THAT(curve.x, ElementsAre(10.5, 20.5));
  EXPECT_THAT(curve.y, ElementsAre(-5.0, -7.0));
  EXPECT_THROW((void)scaled(curve, -1.0, 1.0), std::invalid_argument);
}

TEST(Curve, IsRestrictedWithInterpolatedEnds) {
  const Curve curve{{0.0, 1.0, 2.0, 3.0}, {0.0, 10.0, 20.0, 30.0}};
  const Curve middle = restricted(curve, 0.5, 2.0);
  EXPECT_THAT(middle.x, ElementsAre(0.5, 1.0, 2.0));
  EXPECT_THAT(middle.y, ElementsAre(5.0, 10.0, 20.0));
  const Curve wide = restricted(curve, -1.0, 9.0);
  EXPECT_EQ(wide.x, curve.x);
  EXPECT_TRUE(restricted(curve, 4.0, 5.0).empty());
  EXPECT_THAT(restricted(curve, 1.2, 1.4).x, ElementsAre(1.2, 1.4));
}

TEST(Curve, LastPointAboveALevelIsBehindAllPocketsAndGaps) {
  const double gap = std::nan("");
  EXPECT_EQ(last_above(Curve{{0.0, 1.0, 2.0, 3.0, 4.0}, {5.0, 1.0, 3.0, gap, 2.0}}, 2.0), 2.0);
  EXPECT_TRUE(std::isnan(last_above(Curve{{0.0, 1.0}, {1.0, 2.0}}, 2.0)));
}

TEST(Curve, IsExtendedByItsEndValues) {
  const Curve curve = extended({{1.0, 2.0}, {5.0, 6.0}}, -1.0, 3.0);
  EXPECT_THAT(curve.x, ElementsAre(-1.0, 1.0, 2.0, 3.0));
  EXPECT_THAT(curve.y, ElementsAre(5.0, 5.0, 6.0, 6.0));
  EXPECT_EQ(extended(curve, 0.0, 1.0).x, curve.x);
}

TEST(MovingAverage, KeepsAStraightLine) {
  Curve line;
  for (int k = 0; k <= 20; ++k) line.add(0.1 * k * k, 3.0 * 0.1 * k * k - 1.0);
  const Curve average = moving_average(line, 1.5);
  for (std::size_t k = 0; k < line.size(); ++k) EXPECT_NEAR(average.y[k], line.y[k], 1e-12) << k;
  EXPECT_NEAR(noise(line, 1.5), 0.0, 1e-12);
}

TEST(MovingAverage, IsTheMeanOfTheStraightLines) {
  // A triangle of height 1 over [-1, 1]: its mean over [-1, 1] is 1/2, over [-1/2, 1/2] 3/4.
  const Curve triangle{{-2.0, -1.0, 0.0, 1.0, 2.0}, {0.0, 0.0, 1.0, 0.0, 0.0}};
  EXPECT_DOUBLE_EQ(moving_average(triangle, 2.0).y[2], 0.5);
  EXPECT_DOUBLE_EQ(moving_average(triangle, 1.0).y[2], 0.75);
  EXPECT_DOUBLE_EQ(moving_average(triangle, 2.0).y[1], 0.25);
  EXPECT_DOUBLE_EQ(moving_average(triangle, 2.0).y[0], 0.0);
}

TEST(MovingAverage, LeavesGapsOut) {
  const Curve curve{{0.0, 1.0, 2.0, 3.0, 4.0}, {2.0, 2.0, kNone, 8.0, 8.0}};
  EXPECT_THAT(moving_average(curve, 4.0).y,
              ElementsAre(DoubleEq(2.0), DoubleEq(2.0), IsNan(), DoubleEq(8.0), DoubleEq(8.0)));
}

TEST(Noise, IsTheRootMeanSquareOfWhatAnAverageTakesAway) {
  Curve zigzag;
  for (int k = 0; k <= 1000; ++k) zigzag.add(0.001 * k, k % 2 == 0 ? 1.0 : -1.0);
  // The straight lines between +1 and -1 have a mean of zero over whole periods of 2 ms.
  EXPECT_NEAR(noise(zigzag, 0.004), 1.0, 0.01);
}

TEST(Extremes, AreTheFirstOfTheHighestAndLowestPoints) {
  const Curve curve{{0.0, 1.0, 2.0, 3.0, 4.0}, {1.0, kNone, 5.0, 5.0, -2.0}};
  EXPECT_EQ(highest_point(curve).x, 2.0);
  EXPECT_EQ(highest_point(curve).y, 5.0);
  EXPECT_EQ(lowest_point(curve).x, 4.0);
  EXPECT_EQ(lowest_point(curve).y, -2.0);
  EXPECT_THAT(highest_point(Curve{{1.0}, {kNone}}).y, IsNan());
}

TEST(Crossing, IsInterpolated) {
  const Curve curve{{0.0, 1.0, 2.0, 3.0}, {0.0, 4.0, 1.0, 9.0}};
  EXPECT_DOUBLE_EQ(first_rise_to(curve, 3.0), 0.75);
  EXPECT_DOUBLE_EQ(first_rise_to(curve, 4.0), 1.0);
  EXPECT_DOUBLE_EQ(first_rise_to(curve, 5.0), 2.5);
  EXPECT_DOUBLE_EQ(first_fall_to(Curve{{0.0, 1.0, 2.0}, {5.0, 4.0, 0.0}}, 2.0), 1.5);
  EXPECT_THAT(first_rise_to(curve, 9.1), IsNan());
  EXPECT_DOUBLE_EQ(first_rise_to(curve, -1.0), 0.0);
}

TEST(Crossing, AfterAGapIsTheFirstPointBehindIt) {
  EXPECT_DOUBLE_EQ(first_rise_to(Curve{{0.0, 1.0, 2.0}, {kNone, kNone, 3.0}}, 2.0), 2.0);
}

TEST(MeanSlope, IsThatOfTheLeastSquares) {
  const Curve curve{{0.0, 1.0, 2.0, 3.0, 4.0}, {9.0, 1.0, kNone, 5.0, 7.5}};
  EXPECT_DOUBLE_EQ(mean_slope(curve, 1.0, 3.0), 2.0);
  // Points (1, 1), (3, 5), (4, 7.5): mean (8/3, 4.5), slope 10.0 / (14/3).
  EXPECT_NEAR(mean_slope(curve, 1.0, 4.0), 10.0 / (14.0 / 3.0), 1e-12);
  EXPECT_THAT(mean_slope(curve, 1.5, 3.5), IsNan());
}

TEST(MeanValue, IsTakenOverTheRange) {
  const Curve curve{{0.0, 2.0, 4.0}, {0.0, 2.0, 2.0}};
  EXPECT_DOUBLE_EQ(mean_value(curve, 0.0, 4.0), 1.5);
  EXPECT_DOUBLE_EQ(mean_value(curve, 1.0, 2.0), 1.5);
  EXPECT_DOUBLE_EQ(mean_value(curve, 3.0, 3.0), 2.0);
  EXPECT_THAT(mean_value(curve, 5.0, 6.0), IsNan());
}

}  // namespace
}  // namespace eisph
