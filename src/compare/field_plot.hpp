#pragma once

#include "compare/contour.hpp"
#include "compare/plot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// A field as a map of colours with labelled contour lines, axes to equal scale: for example isobars.
struct FieldPlot {
  std::string title = {};
  std::string x_label = {};
  std::string y_label = {};
  std::string value_label = {};  ///< beside the colour bar, with its unit
  GridValues grid = {};
  std::vector<double> levels = {};                  ///< of contour lines
  std::vector<Polyline> outlines = {};              ///< walls and obstacles
  std::optional<PlotRange> x_range = std::nullopt;  ///< default: the grid
  std::optional<PlotRange> y_range = std::nullopt;
  std::optional<PlotRange> value_range = std::nullopt;  ///< of the colours; default: least to largest value
};
/// Draws a PNG; errors as write_plot(). With a height of 0 the picture is as high as equal scales make it,
/// and narrower than asked for where that would be very high.
void write_field_plot(const std::filesystem::path& path, const FieldPlot& plot, PictureSize size = {900, 0});

/// Points coloured by a value, axes to equal scale: for example particles by their pressure.
struct ScatterPlot {
  std::string title = {};
  std::string x_label = {};
  std::string y_label = {};
  std::string value_label = {};
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::vector<double> value = {};
  double point_size = 0.0;  ///< diameter in units of x; 0: chosen by gnuplot
  std::vector<Polyline> outlines = {};
  std::optional<PlotRange> x_range = std::nullopt;
  std::optional<PlotRange> y_range = std::nullopt;
  std::optional<PlotRange> value_range = std::nullopt;
};
/// Draws a PNG; errors and height as write_field_plot().
void write_scatter_plot(const std::filesystem::path& path, const ScatterPlot& plot,
                        PictureSize size = {900, 0});

}  // namespace eisph
