#pragma once

#include "compare/synthetic_photograph.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace eisph {

/// A floor of 1.8 x 1.2 m with a block of 0.15 m on it.
inline FloorMap block_floor() {
  FloorMap floor;
  floor.area = {0.8, 0.0, 2.6, 1.2};
  floor.solid_distance = [](double x, double y) {
    return std::max(std::abs(x - 1.5) - 0.075, std::abs(y - 0.6) - 0.075);
  };
  floor.wall_distance = [solid = floor.solid_distance](double x, double y) {
    return std::min({2.6 - x, y, 1.2 - y, solid(x, y)});
  };
  return floor;
}

inline double no_water(double /*x*/, double /*y*/) { return 0.0; }

/// Smooth water with a step: 0 to 0.13 m deep.
inline double stepped_water(double x, double y) {
  const double smooth = 0.05 + 0.03 * std::sin(4.0 * x) * std::cos(5.0 * y);
  return x < 1.1 + 0.1 * y ? smooth + 0.05 : smooth;
}

/// Photographs without rims, unless asked for.
inline SyntheticSettings clean_settings() {
  SyntheticSettings settings;
  settings.camera.width = 700;
  settings.camera.height = 560;
  settings.camera.bit_depth = 16;
  settings.light.noise = 0.0;
  settings.rims.width = 0.0;
  return settings;
}

/// Photographs of still water, which holds no bubbles, at the settings' depths.
inline std::vector<CalibrationStep> calibration_steps(SyntheticSettings settings, const PlaneCamera& camera,
                                                      const FloorMap& floor) {
  settings.rims.width = 0.0;
  std::vector<CalibrationStep> steps;
  unsigned number = 100;
  for (const double depth : settings.calibration_depths) {
    steps.push_back({std::to_string(depth), depth,
                     synthetic_photograph(
                         settings, camera, floor, [depth](double, double) { return depth; }, number++)});
  }
  return steps;
}

/// Cells of 15 mm over the tank, of which the photograph shows a part.
inline DepthGrid tank_cells() {
  DepthGrid grid;
  grid.cell_size = 0.015;
  grid.columns = 174;
  grid.rows = 80;
  grid.depth.assign(grid.columns * grid.rows, 0.0F);
  return grid;
}

}  // namespace eisph
