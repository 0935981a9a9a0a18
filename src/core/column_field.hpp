#pragma once

#include <cstddef>
#include <vector>

namespace eisph {

/// State of a depth-averaged model: columns of water over a horizontal grid of square cells. Row-major: entry
/// j * columns + i is the cell centred at (origin_x + (i + 1/2) cell_size, origin_y + (j + 1/2) cell_size). A
/// two-dimensional scene has one row, centred on its plane y = 0.
struct ColumnField {
  double origin_x = 0.0;   ///< m
  double origin_y = 0.0;   ///< m
  double cell_size = 0.0;  ///< m
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<float> bed;         ///< m above the floor of the domain (domain_min.z)
  std::vector<float> depth;       ///< m of water above the bed; zero where dry
  std::vector<float> velocity_x;  ///< m/s, mean over the depth; zero where dry
  std::vector<float> velocity_y;  ///< m/s, likewise

  [[nodiscard]] std::size_t index(std::size_t i, std::size_t j) const { return j * columns + i; }
  [[nodiscard]] std::size_t size() const { return depth.size(); }
};

}  // namespace eisph
