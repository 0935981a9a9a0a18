#include "compare/ritter.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(RitterSolution, HasFourNinthsOfTheDepthAtTheDam) {
  const RitterSolution ritter(0.9, 10.0);  // c0 = 3 m/s
  EXPECT_DOUBLE_EQ(ritter.celerity(), 3.0);
  EXPECT_DOUBLE_EQ(ritter.depth(0.0, 0.7), 0.4);
  EXPECT_DOUBLE_EQ(ritter.depth_at_dam(), 0.4);
  EXPECT_DOUBLE_EQ(ritter.velocity(0.0, 0.7), 2.0);
}

TEST(RitterSolution, IsExactAtAPointBetween) {
  const RitterSolution ritter(0.9, 10.0);
  // x/t = 3: (6 - 3)^2 / 90 and 2/3 (3 + 3).
  EXPECT_DOUBLE_EQ(ritter.depth(1.5, 0.5), 0.1);
  EXPECT_DOUBLE_EQ(ritter.velocity(1.5, 0.5), 4.0);
}

TEST(RitterSolution, EndsAtTheFrontAndAtTheRarefaction) {
  const RitterSolution ritter(0.9, 10.0);
  EXPECT_DOUBLE_EQ(ritter.front_speed(), 6.0);
  EXPECT_DOUBLE_EQ(ritter.front(0.5), 3.0);
  EXPECT_DOUBLE_EQ(ritter.rarefaction_end(0.5), -1.5);
  EXPECT_EQ(ritter.depth(3.0, 0.5), 0.0);
  EXPECT_GT(ritter.depth(2.99, 0.5), 0.0);
  EXPECT_EQ(ritter.velocity(3.01, 0.5), 0.0);
  EXPECT_EQ(ritter.depth(-1.51, 0.5), 0.9);
  EXPECT_EQ(ritter.velocity(-1.51, 0.5), 0.0);
  EXPECT_NEAR(ritter.depth(-1.4999, 0.5), 0.9, 1e-4);
  EXPECT_NEAR(ritter.velocity(-1.4999, 0.5), 0.0, 1e-3);
}

TEST(RitterSolution, StartsFromTheReservoirAtRest) {
  const RitterSolution ritter(0.9, 10.0);
  EXPECT_EQ(ritter.depth(-0.1, 0.0), 0.9);
  EXPECT_EQ(ritter.depth(0.0, 0.0), 0.0);
  EXPECT_EQ(ritter.depth(0.1, 0.0), 0.0);
  EXPECT_EQ(ritter.velocity(-0.1, 0.0), 0.0);
}

TEST(RitterSolution, ConservesMass) {
  const RitterSolution ritter(0.15);
  constexpr double kTime = 0.4;
  constexpr int kCells = 20000;
  const double first = ritter.rarefaction_end(kTime);
  const double width = (ritter.front(kTime) - first) / kCells;
  double volume = 0.0;
  double momentum = 0.0;
  for (int k = 0; k < kCells; ++k) {
    const double x = first + (k + 0.5) * width;
    volume += width * ritter.depth(x, kTime);
    momentum += width * ritter.depth(x, kTime) * ritter.velocity(x, kTime);
  }
  EXPECT_NEAR(volume, -first * 0.15, 1e-8 * volume);
  // The push of the undisturbed reservoir, g h0^2 / 2, is all that acts.
  EXPECT_NEAR(momentum, 0.5 * 9.81 * 0.15 * 0.15 * kTime, 1e-7 * momentum);
}

TEST(RitterSolution, HoldsUntilTheRarefactionMeetsTheEndWall) {
  EXPECT_DOUBLE_EQ(RitterSolution(0.9, 10.0).valid_until(6.0), 2.0);
}

TEST(RitterSolution, RefusesADepthThatIsNotPositive) {
  EXPECT_THROW(RitterSolution(0.0), std::invalid_argument);
  EXPECT_THROW(RitterSolution(-1.0), std::invalid_argument);
  EXPECT_THROW(RitterSolution(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace eisph
