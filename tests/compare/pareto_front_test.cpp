#include "compare/pareto_front.hpp"

#include <limits>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const double kNothing = std::numeric_limits<double>::quiet_NaN();

TEST(ParetoFront, HoldsWhatNothingBeatsByRisingCost) {
  EXPECT_THAT(pareto_front({{4.0, 1.0}, {1.0, 5.0}, {2.0, 6.0}, {3.0, 3.0}, {5.0, 1.0}}),
              ElementsAre(1, 3, 0));
}

TEST(ParetoFront, TakesTheFirstOfEqualPointsAndNoneThatIsNotFinite) {
  EXPECT_THAT(pareto_front({{1.0, kNothing}, {2.0, 3.0}, {2.0, 3.0}, {2.0, 4.0}, {kNothing, 0.0}}),
              ElementsAre(1));
  EXPECT_THAT(pareto_front({}), IsEmpty());
}

TEST(ParetoFront, FindsTheCheapestSettingForAnError) {
  const std::vector<CostAndError> points = {{9.0, 0.5}, {4.0, 2.0}, {3.0, 3.0}, {1.0, 20.0}, {0.5, kNothing}};
  EXPECT_EQ(cheapest_within(points, 1.0), 0U);
  EXPECT_EQ(cheapest_within(points, 3.0), 2U) << "a level that is just met counts";
  EXPECT_EQ(cheapest_within(points, 30.0), 3U);
  EXPECT_EQ(cheapest_within(points, 0.1), std::nullopt);
}

}  // namespace
}  // namespace eisph
