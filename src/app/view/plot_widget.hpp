#pragma once

#include "app/view/probe_plots.hpp"

namespace eisph {

/// Draws a plot over the width that is left in the present window, `height` pixels high, with a cursor at
/// `time` (s). As long as there is but one time, the axis goes to `end_time` (s).
void draw_plot(const ProbePlot& plot, double time, double end_time, float height);

}  // namespace eisph
