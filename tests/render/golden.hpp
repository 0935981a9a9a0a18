#pragma once

#include "render/image.hpp"
#include "render/png_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace eisph {

// Pictures against those in golden/. A pixel counts as different when one of its channels differs by more
// than 8 of 255; 0.5 % of the pixels may, since the software renderer need not give the same bits on every
// processor; twice as many where EISPH_TEST_CONTEXTS chooses the contexts, since a graphics card samples the
// edges of points in its own way (an NVIDIA H100: up to 0.6 %). After a wanted change, look at the pictures
// that the failing tests name, then run the tests with EISPH_UPDATE_GOLDEN=1 in the environment, which writes
// the present pictures to golden/. Sources that include this need EISPH_SOURCE_DIR.

inline constexpr int kLargestDifference = 8;
inline constexpr double kDifferentPixels = 0.005;

inline double allowed_different_pixels() {
  const bool chosen = std::getenv("EISPH_TEST_CONTEXTS") != nullptr;  // NOLINT(concurrency-mt-unsafe)
  return chosen ? 2.0 * kDifferentPixels : kDifferentPixels;
}

inline double different_pixels(const Image& first, const Image& second) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < first.rgb.size(); k += 3) {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(first.rgb[k + c] - second.rgb[k + c]));
    if (largest > kLargestDifference) ++count;
  }
  return static_cast<double>(count) / (static_cast<double>(first.rgb.size()) / 3.0);
}

inline void expect_golden(const std::string& name, const Image& frame) {
  const auto golden =
      std::filesystem::path(EISPH_SOURCE_DIR) / "tests" / "render" / "golden" / (name + ".png");
  if (std::getenv("EISPH_UPDATE_GOLDEN") != nullptr) {  // NOLINT(concurrency-mt-unsafe)
    write_png(golden, frame, {});
    return;
  }
  const Image expected = read_png(golden).image;
  ASSERT_EQ(expected.width, frame.width);
  ASSERT_EQ(expected.height, frame.height);
  const double different = different_pixels(expected, frame);
  if (different > allowed_different_pixels()) {
    const auto actual = std::filesystem::temp_directory_path() / ("eisph_" + name + ".png");
    write_png(actual, frame, {});
    ADD_FAILURE() << 100.0 * different << " % of the pixels differ from " << golden << "; the frame is "
                  << actual;
  }
}

}  // namespace eisph
