#pragma once

#include "core/grey_picture.hpp"

#include <array>

#include <Eigen/Core>

namespace eisph {

/// Corners of the bright floor in a photograph of a tank, in pixels.
struct TankOutline {
  /// Lower left, lower right, upper right, upper left as seen in the picture.
  std::array<Eigen::Vector2d, 4> corners;
  /// Largest distance of the edge's points from its straight line, pixels: a measure of the lens's
  /// distortion.
  double bow = 0.0;
};

/// Finds the floor, which is brighter than its surroundings and has straight edges that are steeper or
/// flatter than 45 degrees: the largest bright region (threshold of Otsu 1979), four lines fitted to its
/// edges, which may be interrupted, and their intersections. Throws InputError if there is no such region.
[[nodiscard]] TankOutline find_tank_outline(const GreyPicture& photograph);

}  // namespace eisph
