#pragma once

#include "compare/curve.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

enum class SeriesStyle { Line, Dashed, Dotted, Points, LinePoints, Band };
enum class LegendPosition { Automatic, TopLeft, TopRight, BottomLeft, BottomRight, Right, Below, None };

/// One curve of a plot. Lines are for models and theory, points for measurements, bands for percentiles.
struct PlotSeries {
  std::string label = {};  ///< in the legend; no entry if empty
  Curve curve = {};        ///< of a band: its lower edge
  SeriesStyle style = SeriesStyle::Line;
  Curve upper = {};  ///< of a band: its upper edge, at the same x
  int colour = -1;   ///< number of a colour (0 is black); -1: the next one that the plot has not used
};

struct PlotRange {
  double least = 0.0;
  double most = 1.0;
};

/// Curves over common axes. Text is plain (no markup), units belong into the labels: "time t [s]".
struct Plot {
  std::string title = {};
  std::string x_label = {};
  std::string y_label = {};
  std::vector<PlotSeries> series = {};
  std::optional<PlotRange> x_range = std::nullopt;  ///< default: what the series need
  std::optional<PlotRange> y_range = std::nullopt;
  bool x_log = false;  ///< only positive values are then drawn
  bool y_log = false;
  bool equal_aspect = false;  ///< one unit has the same length along both axes
  LegendPosition legend = LegendPosition::Automatic;
};

struct PictureSize {
  int width = 900;  ///< pixels
  int height = 600;
};

/// Whether the program gnuplot, which draws the pictures, is on the PATH; require_gnuplot() throws
/// std::runtime_error naming the package if not.
[[nodiscard]] bool has_gnuplot();
void require_gnuplot();

/// Draws a PNG, in place of an older file. Throws std::runtime_error if gnuplot is missing or fails or the
/// file cannot be written; std::invalid_argument for a plot without any value to draw. With a height of 0 a
/// plot of equal aspect is as high as its ranges make it.
void write_plot(const std::filesystem::path& path, const Plot& plot, PictureSize size = {});

/// Several plots as one PNG, row by row, with `columns` in each row: for example profiles at several times.
/// Series with the same label look the same in all of them and have one entry in a legend below all; labels
/// of the axes that all have in common stand at the edges only.
void write_plots(const std::filesystem::path& path, const std::string& title, const std::vector<Plot>& plots,
                 std::size_t columns, PictureSize size = {900, 1100});

}  // namespace eisph
