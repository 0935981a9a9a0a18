#include "scheme/hllc_flux.hpp"
#include "scheme/manning_friction.hpp"
#include "scheme/shallow_water_exact.hpp"
#include "scheme/slope_limiter.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(HllcFlux, OfEqualStatesIsTheFluxOfTheState) {
  for (const double u : {-3.0, -0.4, 0.0, 0.4, 3.0}) {
    const double h = 0.2;
    const ShallowWaterFlux flux = hllc_flux(kGravity, h, u, 0.7, h, u, 0.7);
    EXPECT_NEAR(flux.mass, h * u, 1e-15);
    EXPECT_NEAR(flux.momentum, h * u * u + 0.5 * kGravity * h * h, 1e-14);
    EXPECT_NEAR(flux.tangential, h * u * 0.7, 1e-15);
  }
}

TEST(HllcFlux, OfStillWaterIsPressureAlone) {
  const ShallowWaterFlux flux = hllc_flux(kGravity, 0.3, 0.0, 0.0, 0.3, 0.0, 0.0);
  EXPECT_EQ(flux.mass, 0.0);
  EXPECT_NEAR(flux.momentum, 0.5 * kGravity * 0.09, 1e-15);
  EXPECT_EQ(flux.tangential, 0.0);
}

TEST(HllcFlux, MirroredIsMirrored) {
  const ShallowWaterFlux one = hllc_flux(kGravity, 0.3, 0.5, 0.2, 0.1, -0.8, -0.4);
  const ShallowWaterFlux other = hllc_flux(kGravity, 0.1, 0.8, -0.4, 0.3, -0.5, 0.2);
  EXPECT_NEAR(one.mass, -other.mass, 1e-15);
  EXPECT_NEAR(one.momentum, other.momentum, 1e-15);
  EXPECT_NEAR(one.tangential, -other.tangential, 1e-15);
}

TEST(HllcFlux, HoldsAStandingBoreExactly) {
  // u_L = sqrt(g h_R (h_L + h_R) / (2 h_L)) from the momentum balance, u_R from that of mass.
  const double left = 0.1;
  const double right = 0.25;
  const double u_left = std::sqrt(0.5 * kGravity * right * (left + right) / left);
  const double u_right = left * u_left / right;
  const ShallowWaterFlux flux = hllc_flux(kGravity, left, u_left, 0.3, right, u_right, 0.3);
  EXPECT_NEAR(flux.mass, left * u_left, 1e-14);
  EXPECT_NEAR(flux.momentum, left * u_left * u_left + 0.5 * kGravity * left * left, 1e-14);
  EXPECT_NEAR(flux.momentum, right * u_right * u_right + 0.5 * kGravity * right * right, 1e-14);
}

TEST(HllcFlux, HoldsAShearAtRestExactly) {
  const ShallowWaterFlux flux = hllc_flux(kGravity, 0.2, 0.0, 1.0, 0.2, 0.0, -1.0);
  EXPECT_EQ(flux.mass, 0.0);
  EXPECT_EQ(flux.tangential, 0.0);
}

TEST(HllcFlux, BetweenDrySidesIsNothing) {
  const ShallowWaterFlux flux = hllc_flux(kGravity, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  EXPECT_EQ(flux.mass, 0.0);
  EXPECT_EQ(flux.momentum, 0.0);
  EXPECT_EQ(flux.tangential, 0.0);
}

TEST(HllcFlux, OntoADrySideGoesOutAndNeverIn) {
  const double c = std::sqrt(kGravity * 0.2);
  // Waves from u - c to u + 2 c: F = (s_R F_L - s_L s_R h) / (s_R - s_L) by hand for u = 0.
  const ShallowWaterFlux still = hllc_flux(kGravity, 0.2, 0.0, 0.5, 0.0, 0.0, 0.0);
  EXPECT_NEAR(still.mass, 2.0 * c * c * 0.2 / (3.0 * c), 1e-15);
  EXPECT_NEAR(still.tangential, 0.5 * still.mass, 1e-15);
  const ShallowWaterFlux right = hllc_flux(kGravity, 0.0, 0.0, 0.0, 0.2, 0.0, 0.5);
  EXPECT_NEAR(right.mass, -still.mass, 1e-15);
  EXPECT_NEAR(right.momentum, still.momentum, 1e-15);
  // Water that runs away faster than its front leaves nothing at the face.
  const ShallowWaterFlux away = hllc_flux(kGravity, 0.2, -2.5 * c, 0.0, 0.0, 0.0, 0.0);
  EXPECT_EQ(away.mass, 0.0);
  EXPECT_EQ(away.momentum, 0.0);
}

TEST(WallFlux, IsThatOfTheMirrorImage) {
  for (const double u : {-0.5, 0.0, 0.3, 2.0}) {
    const ShallowWaterFlux flux = hllc_flux(kGravity, 0.2, u, 0.4, 0.2, -u, 0.4);
    EXPECT_NEAR(flux.mass, 0.0, 1e-16);
    EXPECT_NEAR(wall_momentum_flux(kGravity, 0.2, u), flux.momentum, 1e-14) << u;
  }
  EXPECT_EQ(wall_momentum_flux(kGravity, 0.2, -5.0), 0.0) << "no suction";
}

TEST(FaceFlux, OfStillWaterOverAStepIsThePressureOfEachSide) {
  const FaceFlux flux = face_flux(kGravity, 1.0, 0.3, 0.0, 0.0, 0.05, 0.15, 0.0, 0.0, 0.2);
  EXPECT_NEAR(flux.mass, 0.0, 1e-16);
  EXPECT_NEAR(flux.momentum_left, 0.5 * kGravity * 0.09, 1e-15);
  EXPECT_NEAR(flux.momentum_right, 0.5 * kGravity * 0.0225, 1e-15);
}

TEST(FaceFlux, DoesNotPassAStepHigherThanTheWater) {
  const FaceFlux flux = face_flux(kGravity, 1.0, 0.1, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2);
  EXPECT_EQ(flux.mass, 0.0);
  EXPECT_EQ(flux.momentum_right, 0.0);
}

TEST(FaceFlux, AtAWallHoldsBothSides) {
  const FaceFlux flux = face_flux(kGravity, 0.0, 0.1, 0.5, 0.7, 0.0, 0.3, 0.2, 0.1, 0.0);
  EXPECT_EQ(flux.mass, 0.0);
  EXPECT_EQ(flux.tangential, 0.0);
  EXPECT_EQ(flux.momentum_left, wall_momentum_flux(kGravity, 0.1, 0.5));
  EXPECT_EQ(flux.momentum_right, wall_momentum_flux(kGravity, 0.3, -0.2));
}

template <SlopeLimiter Limiter>
void expect_limits() {
  EXPECT_EQ(limited_difference<Limiter>(1.0, -2.0), 0.0);
  EXPECT_EQ(limited_difference<Limiter>(0.0, 3.0), 0.0);
  EXPECT_EQ(limited_difference<Limiter>(2.0, 2.0), 2.0) << "linear";
  EXPECT_EQ(limited_difference<Limiter>(1.0, 3.0), limited_difference<Limiter>(3.0, 1.0));
  EXPECT_EQ(limited_difference<Limiter>(-1.0, -3.0), -limited_difference<Limiter>(1.0, 3.0));
}

TEST(SlopeLimiter, IsZeroAtExtremaAndExactForLines) {
  expect_limits<SlopeLimiter::Minmod>();
  expect_limits<SlopeLimiter::MonotonisedCentral>();
  EXPECT_EQ(limited_difference<SlopeLimiter::Minmod>(1.0, 3.0), 1.0);
  EXPECT_EQ(limited_difference<SlopeLimiter::MonotonisedCentral>(1.0, 2.0), 1.5);
  EXPECT_EQ(limited_difference<SlopeLimiter::MonotonisedCentral>(1.0, 9.0), 2.0);
}

TEST(ManningFriction, InverseCubeRootIsExactToRoundOff) {
  for (double h = 1e-7; h < 1e4; h *= 1.37) {
    EXPECT_NEAR(inverse_cube_root(h) * std::cbrt(h), 1.0, 4e-15) << h;
  }
}

TEST(ManningFriction, OfAStepIsTheExactDecayOfAUniformFlow) {
  const double n = 0.02;
  const double h = 0.1;
  const double k = kGravity * n * n / std::pow(h, 4.0 / 3.0);
  double u = 2.0;
  for (int step = 0; step < 10; ++step) u /= manning_divisor(kGravity, n, 0.05, h, u);
  EXPECT_NEAR(u, 2.0 / (1.0 + k * 2.0 * 0.5), 1e-14);
}

}  // namespace
}  // namespace eisph
