#include "compare/stoker.hpp"

#include "compare/ritter.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Roots found with 40 digits from the equation in the bore speed instead of the middle depth.
struct KnownState {
  double reservoir_depth;
  double downstream_depth;
  double middle_depth;
  double middle_velocity;
  double bore_speed;
};

class StokerMiddleState : public ::testing::TestWithParam<KnownState> {};

TEST_P(StokerMiddleState, AgreesWithTheRootOfAnotherForm) {
  const KnownState& known = GetParam();
  const StokerSolution stoker(known.reservoir_depth, known.downstream_depth);
  EXPECT_NEAR(stoker.middle_depth(), known.middle_depth, 1e-12 * known.middle_depth);
  // A weak bore's velocity is a small difference of large celerities.
  EXPECT_NEAR(stoker.middle_velocity(), known.middle_velocity, 1e-14 * stoker.celerity() * 4.0);
  EXPECT_NEAR(stoker.bore_speed(), known.bore_speed, 1e-12 * known.bore_speed);
}

INSTANTIATE_TEST_SUITE_P(
    DepthRatios, StokerMiddleState,
    ::testing::Values(KnownState{1.0, 0.1, 0.3961748167994429, 2.321354995640744, 3.1051336506682135},
                      KnownState{0.15, 0.038, 0.08317586236196614, 0.6195032120943584, 1.1406027734257},
                      KnownState{1.0, 1e-6, 0.002682436763786133, 5.939747750439131, 5.941962886679023},
                      KnownState{1.0, 0.999, 0.9994999374628637, 0.0015664377020885077, 3.131700465711318},
                      KnownState{10.0, 5.0, 7.269204461872864, 2.9199330394280247, 9.353758392076259}));

TEST(StokerSolution, MeetsTheJumpConditionsForAllDepthRatios) {
  for (double ratio = 1e-6; ratio < 0.9991; ratio = ratio < 0.4 ? ratio * 1.5 : ratio + 0.037) {
    const StokerSolution stoker(2.0, 2.0 * ratio);
    const double h1 = 2.0 * ratio;
    const double hm = stoker.middle_depth();
    const double um = stoker.middle_velocity();
    const double speed = stoker.bore_speed();
    EXPECT_GT(hm, h1);
    EXPECT_LT(hm, 2.0);
    EXPECT_NEAR(speed * (hm - h1), hm * um, 1e-12 * stoker.celerity()) << ratio;
    EXPECT_NEAR(speed * hm * um, hm * um * um + 0.5 * 9.81 * (hm * hm - h1 * h1), 1e-11) << ratio;
    EXPECT_NEAR(um + 2.0 * std::sqrt(9.81 * hm), 2.0 * stoker.celerity(), 1e-12) << ratio;
  }
}

TEST(StokerSolution, ConservesMassAndMomentum) {
  const StokerSolution stoker(0.15, 0.038);
  constexpr double kTime = 0.5;
  constexpr int kCells = 200000;
  constexpr double kEnd = 1.0;
  constexpr double kWidth = 2.0 * kEnd / kCells;
  double volume = 0.0;
  double momentum = 0.0;
  for (int k = 0; k < kCells; ++k) {
    const double x = -kEnd + (k + 0.5) * kWidth;
    volume += kWidth * stoker.depth(x, kTime);
    momentum += kWidth * stoker.depth(x, kTime) * stoker.velocity(x, kTime);
  }
  EXPECT_NEAR(volume, 0.15 + 0.038, 1e-6);
  EXPECT_NEAR(momentum, 0.5 * 9.81 * (0.15 * 0.15 - 0.038 * 0.038) * kTime, 1e-5);
}

TEST(StokerSolution, IsMadeOfFourParts) {
  const StokerSolution stoker(1.0, 0.1);
  constexpr double kTime = 2.0;
  EXPECT_EQ(stoker.depth(stoker.rarefaction_end(kTime) - 0.01, kTime), 1.0);
  EXPECT_EQ(stoker.velocity(stoker.rarefaction_end(kTime) - 0.01, kTime), 0.0);
  EXPECT_EQ(stoker.depth(stoker.bore(kTime) - 0.01, kTime), stoker.middle_depth());
  EXPECT_EQ(stoker.velocity(stoker.bore(kTime) - 0.01, kTime), stoker.middle_velocity());
  EXPECT_EQ(stoker.depth(stoker.bore(kTime) + 0.01, kTime), 0.1);
  EXPECT_EQ(stoker.velocity(stoker.bore(kTime) + 0.01, kTime), 0.0);
  // Both expressions agree where the rarefaction meets the middle state.
  const double joint = stoker.middle_begin(kTime);
  EXPECT_NEAR(stoker.depth(joint - 1e-9, kTime), stoker.middle_depth(), 1e-8);
  EXPECT_NEAR(stoker.velocity(joint - 1e-9, kTime), stoker.middle_velocity(), 1e-8);
  EXPECT_EQ(stoker.depth(-0.1, 0.0), 1.0);
  EXPECT_EQ(stoker.depth(0.1, 0.0), 0.1);
}

TEST(StokerSolution, TendsToRittersForAThinLayer) {
  const StokerSolution stoker(1.0, 1e-9);
  const RitterSolution ritter(1.0);
  for (const double x : {-0.9, -0.3, 0.0, 0.5, 1.5, 2.5}) {
    EXPECT_NEAR(stoker.depth(x, 0.5), ritter.depth(x, 0.5), 1e-4) << x;
  }
  EXPECT_NEAR(stoker.bore_speed(), ritter.front_speed(), 0.03 * ritter.front_speed());
}

TEST(StokerSolution, RefusesDepthsThatAreNoDamBreak) {
  EXPECT_THROW(StokerSolution(1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(StokerSolution(1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(StokerSolution(1.0, 2.0), std::invalid_argument);
}

}  // namespace
}  // namespace eisph
