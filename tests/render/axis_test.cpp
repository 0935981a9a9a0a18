#include "render/axis.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> labels(double lower, double upper, int count) {
  std::vector<std::string> result;
  for (const Tick& tick : ticks(lower, upper, count)) result.push_back(tick.label);
  return result;
}

TEST(Axis, ValuesAreRoundedUpToShortOnes) {
  EXPECT_NEAR(round_up_nicely(2.426), 2.5, 1e-12);
  EXPECT_NEAR(round_up_nicely(0.15), 0.15, 1e-12);
  EXPECT_NEAR(round_up_nicely(1471.5), 1500.0, 1e-9);
  EXPECT_NEAR(round_up_nicely(8.1), 10.0, 1e-12);
  EXPECT_NEAR(round_up_nicely(1.0), 1.0, 1e-12);
  EXPECT_NEAR(round_up_nicely(0.001), 0.001, 1e-15);
}

TEST(Axis, LengthsAreRoundedDownToOneTwoOrFive) {
  EXPECT_NEAR(round_down_nicely(0.9), 0.5, 1e-12);
  EXPECT_NEAR(round_down_nicely(1.9), 1.0, 1e-12);
  EXPECT_NEAR(round_down_nicely(0.2), 0.2, 1e-12);
  EXPECT_NEAR(round_down_nicely(49.0), 20.0, 1e-9);
}

TEST(Axis, TicksAreMultiplesOfARoundStepWithTheDecimalsItNeeds) {
  EXPECT_THAT(labels(0.0, 2.5, 6), ElementsAre("0.0", "0.5", "1.0", "1.5", "2.0", "2.5"));
  EXPECT_THAT(labels(0.0, 0.15, 4), ElementsAre("0.00", "0.05", "0.10", "0.15"));
  EXPECT_THAT(labels(0.0, 1.0, 5), ElementsAre("0.00", "0.25", "0.50", "0.75", "1.00"));
  EXPECT_THAT(labels(0.0, 1500.0, 4), ElementsAre("0", "500", "1000", "1500"));
  EXPECT_THAT(labels(-2.5, 2.5, 5), ElementsAre("\u22122", "\u22121", "0", "1", "2"));
  EXPECT_THAT(labels(0.013, 0.047, 4), ElementsAre("0.02", "0.03", "0.04"));
}

TEST(Axis, TicksLieInTheRangeAndAreNotTooMany) {
  for (int power = 0; power < 60; ++power) {
    const double upper = 0.003 * std::pow(1.37, power);
    for (const int count : {2, 3, 5, 9}) {
      const auto marks = ticks(0.0, upper, count);
      EXPECT_GE(marks.size(), 2U) << upper;
      EXPECT_LE(marks.size(), static_cast<std::size_t>(count)) << upper;
      EXPECT_LE(marks.back().value, upper * (1.0 + 1e-5));
    }
  }
}

TEST(Axis, LengthsCarryTheirUnit) {
  EXPECT_EQ(length_text(0.5), "0.5 m");
  EXPECT_EQ(length_text(0.005), "5 mm");
  EXPECT_EQ(length_text(0.01), "0.01 m");
  EXPECT_EQ(length_text(2000.0), "2 km");
}

}  // namespace
}  // namespace eisph
