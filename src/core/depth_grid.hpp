#pragma once

#include <cstddef>
#include <vector>

namespace eisph {

/// Water depth on a horizontal grid of square cells. Row-major: depth[j * columns + i] is the cell centred at
/// (origin_x + (i + 1/2) cell_size, origin_y + (j + 1/2) cell_size). Zero where there is no water.
/// A two-dimensional scene has one row.
struct DepthGrid {
  double time = 0.0;       ///< s
  double origin_x = 0.0;   ///< m
  double origin_y = 0.0;   ///< m
  double cell_size = 0.0;  ///< m
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<float> depth;  ///< m

  [[nodiscard]] float at(std::size_t i, std::size_t j) const { return depth[j * columns + i]; }
};

}  // namespace eisph
