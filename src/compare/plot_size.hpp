#pragma once

#include "compare/plot.hpp"

namespace eisph {

/// Pixels around the axes: for marks, labels, title and colour bar.
struct AxesRoom {
  int left = 0;
  int right = 0;
  int above = 0;
  int below = 0;
};

/// The picture that axes to equal scale fill. It is `width` wide, or narrower if it would be too high for a
/// screen.
[[nodiscard]] PictureSize fitting_size(const PlotRange& x, const PlotRange& y, int width,
                                       const AxesRoom& room);

/// Distance of the marks on an axis of so many pixels that leaves room for the numbers: 1, 2 or 5 times a
/// power of ten.
[[nodiscard]] double mark_step(const PlotRange& range, double pixels);

}  // namespace eisph
