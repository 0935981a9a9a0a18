#include "compare/photograph_depth.hpp"

#include "compare/deviation_statistics.hpp"
#include "compare/photographed_tank.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using testing::HasSubstr;

/// Photographs the stepped water and measures it.
PhotographDepth measured(const SyntheticSettings& settings, bool per_pixel, const RimSettings& rims = {},
                         double (*water)(double, double) = stepped_water) {
  const FloorMap floor = block_floor();
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  const auto steps = calibration_steps(settings, camera, floor);
  const auto mask = floor_mask(floor, camera, settings.camera.width, settings.camera.height);
  const DepthCalibration calibration =
      per_pixel ? DepthCalibration::per_pixel(steps, mask) : DepthCalibration::whole_picture(steps, mask);
  const GreyPicture photograph = synthetic_photograph(settings, camera, floor, water, 1);
  return depth_on_cells(depth_picture(photograph, calibration), camera, floor, rims, tank_cells());
}

/// RMS (m) of the measured cells against the mean depth of the water in them.
double rms_error(const PhotographDepth& found) {
  double squares = 0.0;
  double cells = 0.0;
  constexpr int kPoints = 6;
  for (std::size_t j = 0; j < found.grid.rows; ++j) {
    for (std::size_t i = 0; i < found.grid.columns; ++i) {
      if (found.state[j * found.grid.columns + i] != CellState::Measured) continue;
      double mean = 0.0;
      for (int v = 0; v < kPoints; ++v) {
        for (int u = 0; u < kPoints; ++u) {
          mean += stepped_water(0.015 * (static_cast<double>(i) + (u + 0.5) / kPoints),
                                0.015 * (static_cast<double>(j) + (v + 0.5) / kPoints));
        }
      }
      squares += std::pow(found.grid.at(i, j) - mean / (kPoints * kPoints), 2);
      cells += 1.0;
    }
  }
  return std::sqrt(squares / cells);
}

TEST(PhotographDepth, RoundTripWithoutNoiseIsBelowAMillimetre) {
  const PhotographDepth found = measured(clean_settings(), true, {.detection = RimDetection::None});
  EXPECT_LT(rms_error(found), 0.001);
  // 119 x 80 cells of the area, without 10 x 10 of the block.
  EXPECT_EQ(found.cells[static_cast<std::size_t>(CellState::Measured)], 120U * 80U - 100U);
  EXPECT_EQ(found.bright_share + found.dark_share, 0.0);
}

TEST(PhotographDepth, RoundTripWithNoiseAndEightBitsIsBelowTwoMillimetres) {
  SyntheticSettings settings = clean_settings();
  settings.camera.bit_depth = 8;
  settings.light.noise = 1.5;
  const double noisy = rms_error(measured(settings, true, {.detection = RimDetection::None}));
  EXPECT_LT(noisy, 0.002);
  EXPECT_GT(noisy, rms_error(measured(clean_settings(), true, {.detection = RimDetection::None})));
}

TEST(PhotographDepth, CurvesOfPixelsTakeOutAnUnevenBacklight) {
  SyntheticSettings settings = clean_settings();
  settings.light.falloff = 0.3;
  settings.light.gradient = 0.1;
  const RimSettings none{.detection = RimDetection::None};
  EXPECT_GT(rms_error(measured(settings, false, none)), 0.003);
  EXPECT_LT(rms_error(measured(settings, true, none)), 0.001);
}

TEST(PhotographDepth, RimsAreFoundAndFilledWithTheNearestDepth) {
  SyntheticSettings settings = clean_settings();
  settings.rims.width = 0.012;
  settings.rims.darkness = 0.5;
  const auto flat = [](double, double) { return 0.06; };
  const RimSettings rims{.band = 0.03};
  const PhotographDepth found = measured(settings, true, rims, flat);
  EXPECT_GT(found.cells[static_cast<std::size_t>(CellState::Rim)], 100U);
  double deepest = 0.0;
  const ComparableDepth kept = filled(found, RimFill::Keep);
  const ComparableDepth fill = filled(found, RimFill::NearestPlus10);
  const ComparableDepth without = filled(found, RimFill::LeaveOut);
  for (std::size_t k = 0; k < found.state.size(); ++k) {
    if (found.state[k] == CellState::Measured) {
      EXPECT_NEAR(found.grid.depth[k], 0.06, 0.15 * 0.06 + 0.0035);
      EXPECT_EQ(without.valid[k], 1);
    }
    if (found.state[k] != CellState::Rim) continue;
    EXPECT_NEAR(fill.grid.depth[k], 1.1 * 0.06, 0.0138);
    EXPECT_EQ(fill.valid[k], 1);
    EXPECT_EQ(without.valid[k], 0);
    deepest = std::max(deepest, static_cast<double>(kept.grid.depth[k]));
  }
  EXPECT_GT(deepest, 0.075);
}

/// 5 x 3 cells with given states.
PhotographDepth hand_made() {
  PhotographDepth photograph;
  photograph.grid.cell_size = 1.0;
  photograph.grid.columns = 5;
  photograph.grid.rows = 3;
  photograph.grid.depth = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 9.0F, 9.0F,
                           7.0F, 8.0F, 0.5F, 0.4F, 0.3F, 0.2F, 0.1F};
  photograph.state.assign(15, CellState::Measured);
  photograph.state[6] = CellState::Rim;
  photograph.state[7] = CellState::Rim;
  photograph.state[1] = CellState::Outside;
  photograph.state[5] = CellState::Unreadable;
  photograph.grid.depth[5] = std::nanf("");
  return photograph;
}

TEST(PhotographDepth, FillIsTheNearestMeasuredDepthAndTenPercent) {
  const ComparableDepth filled_cells = filled(hand_made(), RimFill::NearestPlus10);
  EXPECT_FLOAT_EQ(filled_cells.grid.depth[6], 1.1F * 0.4F);  // below; left is unreadable, above outside
  EXPECT_FLOAT_EQ(filled_cells.grid.depth[7], 1.1F * 3.0F);  // above, the first of three as near
  EXPECT_EQ(filled_cells.valid[6], 1);
  EXPECT_EQ(filled_cells.valid[5], 0);
  EXPECT_EQ(filled_cells.valid[1], 0);
  EXPECT_EQ(filled(hand_made(), RimFill::Keep).grid.depth[6], 9.0F);
  EXPECT_EQ(filled(hand_made(), RimFill::LeaveOut).valid[6], 0);
}

TEST(PhotographDepth, PolygonsAreRims) {
  RimSettings rims{.detection = RimDetection::None};
  rims.polygons = {{{1.0, 0.3}, {1.3, 0.3}, {1.3, 0.6}, {1.0, 0.6}}};
  const PhotographDepth found = measured(clean_settings(), true, rims);
  for (std::size_t j = 0; j < found.grid.rows; ++j) {
    for (std::size_t i = 0; i < found.grid.columns; ++i) {
      const double x = 0.015 * (static_cast<double>(i) + 0.5);
      const double y = 0.015 * (static_cast<double>(j) + 0.5);
      const bool inside = x > 1.0 && x < 1.3 && y > 0.3 && y < 0.6;
      EXPECT_EQ(found.state[j * found.grid.columns + i] == CellState::Rim, inside);
    }
  }
}

TEST(PhotographDepth, LevelsBeyondTheCalibrationAreUnreadable) {
  SyntheticSettings settings = clean_settings();
  settings.calibration_depths = {0.02, 0.04, 0.06};
  const PhotographDepth found = measured(settings, true, {.detection = RimDetection::None});
  EXPECT_GT(found.cells[static_cast<std::size_t>(CellState::Unreadable)], 1000U);
  EXPECT_GT(found.dark_share, 0.1);
  for (std::size_t k = 0; k < found.state.size(); ++k) {
    if (found.state[k] != CellState::Measured) continue;
    EXPECT_LT(found.grid.depth[k], 0.0601F);
    EXPECT_GT(found.grid.depth[k], 0.0199F);
  }
}

/// A wave that spreads from a breach in the middle of the left edge.
double spreading_water(double x, double y) {
  return 0.12 * std::pow(std::max(0.0, 1.0 - std::hypot(x - 0.8, y - 0.6) / 1.2), 2);
}

TEST(PhotographDepth, PickingErrorsOfAPixelHardlyMoveTheStatistics) {
  SyntheticSettings settings = clean_settings();
  settings.camera.width = 1000;
  settings.camera.height = 800;
  settings.camera.bit_depth = 8;
  settings.light.noise = 1.0;
  const FloorMap floor = block_floor();
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  const auto mask = floor_mask(floor, camera, settings.camera.width, settings.camera.height);
  const DepthPicture picture =
      depth_picture(synthetic_photograph(settings, camera, floor, spreading_water, 1),
                    DepthCalibration::per_pixel(calibration_steps(settings, camera, floor), mask));
  std::vector<ReferencePoint> corners;
  for (const Eigen::Vector2d& plane : {Eigen::Vector2d(0.8, 0.0), {2.6, 0.0}, {2.6, 1.2}, {0.8, 1.2}})
    corners.push_back({"corner", plane, camera.pixel_of(plane)});
  // Another model's water: a little deeper and shifted, so that the deviations have a distribution.
  DepthGrid other = tank_cells();
  for (std::size_t j = 0; j < other.rows; ++j) {
    for (std::size_t i = 0; i < other.columns; ++i) {
      other.depth[j * other.columns + i] = static_cast<float>(
          1.1 * spreading_water(0.015 * static_cast<double>(i), 0.015 * (static_cast<double>(j) + 1.0)));
    }
  }
  std::vector<DeviationStatistics> all;
  for (const Registration& registration : perturbed_registrations(corners, 1000, 800, false, 1.0, 20, 5)) {
    const ComparableDepth found = filled(
        depth_on_cells(picture, registration.camera, floor, RimSettings{}, other), RimFill::NearestPlus10);
    DeviationSamples samples;
    add_samples(samples, other, found.grid, found.valid, 0.005, false);
    all.push_back(deviation_statistics(samples, 0.005));
  }
  const auto scatter = [&](double DeviationStatistics::*figure) {
    double sum = 0.0;
    double squares = 0.0;
    for (const DeviationStatistics& one : all) {
      sum += one.*figure / 20.0;
      squares += one.*figure * one.*figure / 20.0;
    }
    return std::sqrt(std::max(0.0, squares - sum * sum));
  };
  // A pixel is 2 mm wide and the wave is steep where it enters.
  EXPECT_LT(scatter(&DeviationStatistics::mean), 0.1e-3);
  EXPECT_LT(scatter(&DeviationStatistics::percentile_15), 0.01e-3);
  EXPECT_LT(scatter(&DeviationStatistics::percentile_85), 0.2e-3);
  EXPECT_GT(scatter(&DeviationStatistics::mean), 1e-6);
}

TEST(PhotographDepth, CellsSmallerThanPixelsAreRefused) {
  const FloorMap floor = block_floor();
  const SyntheticSettings settings = clean_settings();
  const PlaneCamera camera = synthetic_camera(settings.camera, floor.area);
  DepthPicture picture{.width = 700, .height = 560, .depth = {}, .range = {}};
  picture.depth.resize(700 * 560);
  picture.range.resize(700 * 560);
  DepthGrid grid = tank_cells();
  grid.cell_size = 0.001;
  EXPECT_THAT(error_of<InputError>([&] { (void)depth_on_cells(picture, camera, floor, {}, grid); }),
              HasSubstr("smaller than the pixels"));
}

}  // namespace
}  // namespace eisph
