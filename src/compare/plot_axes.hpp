#pragma once

#include "compare/plot.hpp"

#include <string>

namespace eisph {

struct PlotAxes {
  PlotRange x;
  PlotRange y;
};

/// Ranges of both axes: those asked for, otherwise what the series need, with some room above and below.
/// Throws std::invalid_argument if no series has a value within them.
[[nodiscard]] PlotAxes plot_axes(const Plot& plot);

/// Lines of a script that set both axes: ranges, logarithms, marks, labels.
[[nodiscard]] std::string axes_script(const Plot& plot, const PlotAxes& axes);

/// The place that was asked for; for LegendPosition::Automatic a corner without data, otherwise below the
/// plot.
[[nodiscard]] LegendPosition legend_position(const Plot& plot, const PlotAxes& axes, PictureSize size);

/// The line of a script that places the legend.
[[nodiscard]] std::string legend_script(LegendPosition position);

}  // namespace eisph
