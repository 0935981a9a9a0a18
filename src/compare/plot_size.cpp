#include "compare/plot_size.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

PictureSize fitting_size(const PlotRange& x, const PlotRange& y, int width, const AxesRoom& room) {
  constexpr double kHighest = 600.0;
  constexpr double kLowest = 100.0;
  constexpr double kNarrowest = 240.0;
  const double ratio = (y.most - y.least) / (x.most - x.least);
  double axes_width = width - room.left - room.right;
  double axes_height = std::max(ratio * axes_width, kLowest);
  if (axes_height > kHighest) {
    axes_height = kHighest;
    axes_width = std::clamp(axes_height / ratio, std::min(kNarrowest, axes_width), axes_width);
  }
  return {static_cast<int>(std::lround(axes_width)) + room.left + room.right,
          static_cast<int>(std::lround(axes_height)) + room.above + room.below};
}

double mark_step(const PlotRange& range, double pixels) {
  constexpr double kPixelsPerMark = 62.0;
  const double least = (range.most - range.least) * kPixelsPerMark / pixels;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= least) return digit * power;
  }
  return 10.0 * power;
}

}  // namespace eisph
