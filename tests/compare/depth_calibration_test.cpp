#include "compare/depth_calibration.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::vector<CalibrationPoint> kPoints = {{0.9, 0.0}, {0.6, 0.03}, {0.3, 0.08}, {0.1, 0.15}};

/// A picture of 8 x 6 pixels of one level.
CalibrationStep flat_step(const std::string& name, double depth, float level) {
  CalibrationStep step{name, depth, GreyPicture(8, 6)};
  std::fill(step.picture.level.begin(), step.picture.level.end(), level);
  return step;
}

const std::vector<std::uint8_t> kAll(48, 1);

TEST(DepthCalibration, GoesThroughItsPointsAndIsMonotoneBetween) {
  const DepthCalibration calibration = DepthCalibration::from_points(kPoints);
  for (const CalibrationPoint& point : kPoints) {
    const CalibratedDepth found = calibration.depth_of(0, static_cast<float>(point.level));
    EXPECT_NEAR(found.depth, point.depth, 1e-7);
  }
  float before = -1.0F;
  for (int k = 0; k <= 800; ++k) {
    const CalibratedDepth found = calibration.depth_of(0, 0.9F - 0.001F * static_cast<float>(k));
    EXPECT_GE(found.depth, before);
    before = found.depth;
  }
}

TEST(DepthCalibration, OfAStraightLineIsTheLine) {
  const DepthCalibration calibration =
      DepthCalibration::from_points({{0.8, 0.0}, {0.6, 0.02}, {0.3, 0.05}, {0.2, 0.06}});
  for (const float level : {0.75F, 0.5F, 0.44F, 0.25F})
    EXPECT_NEAR(calibration.depth_of(0, level).depth, 0.1 * (0.8 - level), 1e-7);
}

TEST(DepthCalibration, HasNoDepthBeyondItsEnds) {
  const DepthCalibration calibration = DepthCalibration::from_points(kPoints, 0.02);
  EXPECT_EQ(calibration.depth_of(0, 0.91F).range, LevelRange::Clamped);
  EXPECT_EQ(calibration.depth_of(0, 0.91F).depth, 0.0F);
  EXPECT_EQ(calibration.depth_of(0, 0.93F).range, LevelRange::TooBright);
  EXPECT_TRUE(std::isnan(calibration.depth_of(0, 0.93F).depth));
  EXPECT_EQ(calibration.depth_of(0, 0.085F).range, LevelRange::Clamped);
  EXPECT_FLOAT_EQ(calibration.depth_of(0, 0.085F).depth, 0.15F);
  EXPECT_EQ(calibration.depth_of(0, 0.07F).range, LevelRange::TooDark);
  EXPECT_EQ(calibration.depth_of(0, 0.5F).range, LevelRange::Inside);
}

TEST(DepthCalibration, RefusesLevelsThatDoNotFall) {
  const std::string message = error_of<InputError>([] {
    (void)DepthCalibration::from_points({{0.9, 0.0}, {0.4, 0.05}, {0.5, 0.1}});
  });
  EXPECT_THAT(message, AllOf(HasSubstr("not monotone"), HasSubstr("point 2"), HasSubstr("point 3")));
  EXPECT_THAT(error_of<InputError>([] {
                (void)DepthCalibration::from_points({{0.9, 0.0}});
              }),
              HasSubstr("at least 2"));
  const std::string pictures = error_of<InputError>([] {
    (void)DepthCalibration::whole_picture({flat_step("dry.png", 0.0, 0.5F), flat_step("wet.png", 0.1, 0.6F)},
                                          kAll);
  });
  EXPECT_THAT(pictures, AllOf(HasSubstr("dry.png"), HasSubstr("wet.png")));
}

TEST(DepthCalibration, PixelsHaveCurvesOfTheirOwn) {
  CalibrationStep dry = flat_step("dry", 0.0, 0.9F);
  CalibrationStep wet = flat_step("wet", 0.1, 0.3F);
  for (int j = 0; j < 6; ++j) {
    for (int i = 4; i < 8; ++i) {
      dry.picture.at(i, j) = 0.7F;  // less light on the right
      wet.picture.at(i, j) = 0.1F;
    }
  }
  const DepthCalibration calibration = DepthCalibration::per_pixel({dry, wet}, kAll);
  EXPECT_NEAR(calibration.depth_of(0, 0.6F).depth, 0.05, 1e-6);
  EXPECT_NEAR(calibration.depth_of(7, 0.4F).depth, 0.05, 1e-6);
  EXPECT_EQ(calibration.depth_of(7, 0.8F).range, LevelRange::TooBright);
  EXPECT_EQ(calibration.unusable(), 0U);
}

TEST(DepthCalibration, FewPixelsMayFailManyMayNot) {
  std::vector<std::uint8_t> mask(200 * 100, 1);
  CalibrationStep dry{"dry", 0.0, GreyPicture(200, 100)};
  CalibrationStep wet{"wet", 0.1, GreyPicture(200, 100)};
  std::fill(dry.picture.level.begin(), dry.picture.level.end(), 0.9F);
  std::fill(wet.picture.level.begin(), wet.picture.level.end(), 0.3F);
  for (int i = 10; i < 20; ++i) wet.picture.at(i, 50) = dry.picture.at(i, 50) = 0.05F;
  const DepthCalibration calibration = DepthCalibration::per_pixel({wet, dry}, mask);
  EXPECT_EQ(calibration.unusable(), 10U);
  EXPECT_EQ(calibration.depth_of(dry.picture.index(15, 50), 0.05F).range, LevelRange::Unusable);
  for (int i = 0; i < 200; ++i) {
    for (int j = 0; j < 5; ++j) wet.picture.at(i, j) = dry.picture.at(i, j) = 0.05F;
  }
  EXPECT_THAT(error_of<InputError>([&] {
                (void)DepthCalibration::per_pixel({dry, wet}, mask);
              }),
              HasSubstr("5.0 %"));
}

TEST(DepthCalibration, ToleranceFollowsTheNoise) {
  std::vector<std::uint8_t> mask(100 * 100, 1);
  CalibrationStep dry{"dry", 0.0, GreyPicture(100, 100)};
  CalibrationStep wet{"wet", 0.1, GreyPicture(100, 100)};
  for (std::size_t k = 0; k < mask.size(); ++k) {
    const double noise = std::sin(1.7 * static_cast<double>(k)) + std::sin(2.9 * static_cast<double>(k));
    dry.picture.level[k] = static_cast<float>(0.8 + 0.01 * noise);
    wet.picture.level[k] = static_cast<float>(0.3 + 0.01 * noise);
  }
  const DepthCalibration calibration = DepthCalibration::whole_picture({dry, wet}, mask);
  EXPECT_NEAR(calibration.noise(), 0.01, 0.003);
  EXPECT_NEAR(calibration.tolerance(), 3.0 * calibration.noise(), 1e-12);
  EXPECT_EQ(DepthCalibration::whole_picture({dry, wet}, mask, 0.5).tolerance(), 0.5);
}

}  // namespace
}  // namespace eisph
