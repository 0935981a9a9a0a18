#pragma once

#include <cstddef>
#include <vector>

namespace eisph {

/// Values at the points of a rectangular grid. Row-major: values[j * columns + i] belongs to the point
/// (origin_x + i * spacing, origin_y + j * spacing). Not-a-number: nothing there.
struct GridValues {
  double origin_x = 0.0;
  double origin_y = 0.0;
  double spacing = 1.0;
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> values = {};

  [[nodiscard]] double at(std::size_t i, std::size_t j) const { return values[j * columns + i]; }
};

/// Corners of a line in the plane; closed lines end where they begin.
struct Polyline {
  std::vector<double> x = {};
  std::vector<double> y = {};
};

/// Lines on which the values, linear along the edges of the grid, equal `level` (marching squares). Squares
/// with a corner that has no value have none.
[[nodiscard]] std::vector<Polyline> contour_lines(const GridValues& grid, double level);

}  // namespace eisph
