#include "scheme/equation_of_state.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(EquationOfState, IsTaitsOrLinear) {
  const EquationOfState tait{1000.0, 20.0, 7.0, true};
  EXPECT_NEAR(tait.pressure(0.01), 1000.0 * 400.0 / 7.0 * (std::pow(1.01, 7.0) - 1.0), 1e-6);
  const EquationOfState linear{1000.0, 20.0, 1.0, true};
  EXPECT_DOUBLE_EQ(linear.pressure(0.01), 1000.0 * 400.0 * 0.01);
}

TEST(EquationOfState, GivesTheCompressionBack) {
  for (const double gamma : {1.0, 7.0}) {
    const EquationOfState state{1000.0, 20.0, gamma, false};
    for (const double compression : {-0.05, 0.0, 1e-7, 0.03}) {
      EXPECT_NEAR(state.compression(state.pressure(compression)), compression, 1e-15);
    }
  }
}

TEST(EquationOfState, CutsNegativePressureOffOnlyIfAsked) {
  EXPECT_EQ((EquationOfState{1000.0, 20.0, 7.0, true}.pressure(-0.01)), 0.0);
  EXPECT_LT((EquationOfState{1000.0, 20.0, 7.0, false}.pressure(-0.01)), 0.0);
}

}  // namespace
}  // namespace eisph
