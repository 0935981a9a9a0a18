#include "compare/field_plot.hpp"

#include "compare/gnuplot.hpp"
#include "compare/plot_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

// Viridis (van der Walt & Smith 2015), at equal steps.
constexpr const char* kPalette =
    "set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', "
    "6 '#5ec962', 7 '#addc30', 8 '#fde725')\n";

constexpr AxesRoom kRoom{.left = 100, .right = 160, .above = 44, .below = 68};

struct FieldAxes {
  PlotRange x;
  PlotRange y;
  PlotRange value;
};

PlotRange range_of(const std::vector<double>& values, const std::string& title) {
  PlotRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
  }
  if (range.least > range.most) {
    throw std::invalid_argument(fmt::format("The plot '{}' has no value to draw", title));
  }
  if (range.least == range.most) range.most += std::max(1e-12, 0.1 * std::abs(range.most));
  return range;
}

/// The size that was asked for, or without a height the one that axes to equal scale fill.
PictureSize picture_size(const FieldAxes& axes, PictureSize size) {
  return size.height > 0 ? size : fitting_size(axes.x, axes.y, size.width, kRoom);
}

std::string frame_script(const FieldAxes& axes, PictureSize asked, const std::string& title,
                         const std::string& x_label, const std::string& y_label,
                         const std::string& value_label) {
  const PictureSize size = picture_size(axes, asked);
  std::string script = gnuplot_preamble(size.width, size.height) + kPalette + "unset key\nunset grid\n";
  script += fmt::format(
      "set title {}\nset xlabel {}\nset ylabel {} offset 0.3,0\nset cblabel {} offset 0.6,0\n",
      gnuplot_quoted(title), gnuplot_quoted(x_label), gnuplot_quoted(y_label), gnuplot_quoted(value_label));
  const auto range = [&](const char* axis, const PlotRange& limits) {
    script +=
        fmt::format("set {}range [{}:{}]\n", axis, gnuplot_number(limits.least), gnuplot_number(limits.most));
  };
  range("x", axes.x);
  range("y", axes.y);
  range("cb", axes.value);
  const double width = size.width;
  const double height = size.height;
  const double axes_width = width - kRoom.left - kRoom.right;
  const double axes_height = height - kRoom.above - kRoom.below;
  const double scale =
      std::min(axes_width / (axes.x.most - axes.x.least), axes_height / (axes.y.most - axes.y.least));
  script += fmt::format("set size ratio -1\nset tics out nomirror\nset xtics {}\nset ytics {}\n",
                        gnuplot_number(mark_step(axes.x, scale * (axes.x.most - axes.x.least))),
                        gnuplot_number(mark_step(axes.y, 1.4 * scale * (axes.y.most - axes.y.least))));
  script += fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\n",
      kRoom.left / width, 1.0 - kRoom.right / width, kRoom.below / height, 1.0 - kRoom.above / height);
  return script;
}

/// Lines of a data block, apart from each other by an empty one; an empty string without lines.
std::string line_block(const std::string& name, const std::vector<Polyline>& lines) {
  std::string data;
  for (const Polyline& line : lines) {
    for (std::size_t k = 0; k < line.x.size(); ++k) {
      data += gnuplot_number(line.x[k]) + ' ' + gnuplot_number(line.y[k]) + '\n';
    }
    data += '\n';
  }
  return data.empty() ? data : "$" + name + " << END_OF_DATA\n" + data + "END_OF_DATA\n";
}

double squared_distance(const CurvePoint& a, const CurvePoint& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Where to write the value of a contour line: on its longest part, away from the ends and the labels so far.
std::optional<CurvePoint> label_place(const std::vector<Polyline>& lines,
                                      const std::vector<CurvePoint>& taken) {
  const auto longest = std::max_element(lines.begin(), lines.end(), [](const Polyline& a, const Polyline& b) {
    return a.x.size() < b.x.size();
  });
  if (longest == lines.end() || longest->x.size() < 5) return std::nullopt;
  const std::size_t count = longest->x.size();
  std::optional<CurvePoint> best;
  double best_distance = -1.0;
  for (std::size_t k = count / 4; k <= 3 * count / 4; ++k) {
    const CurvePoint place{longest->x[k], longest->y[k]};
    double distance = std::numeric_limits<double>::max();
    for (const CurvePoint& other : taken) distance = std::min(distance, squared_distance(place, other));
    if (taken.empty() && k != count / 2) continue;
    if (distance <= best_distance) continue;
    best_distance = distance;
    best = place;
  }
  return best;
}

/// Contour lines with their values, as lines of the script before the plot command, and of that command.
struct ContourScript {
  std::string before;
  std::string drawing;
};

ContourScript contour_script(const FieldPlot& plot) {
  ContourScript script;
  script.before = "set style textbox opaque margins 0.6,0.4 fillcolor rgb '#ffffff' noborder\n";
  std::vector<CurvePoint> taken;
  for (std::size_t k = 0; k < plot.levels.size(); ++k) {
    const std::vector<Polyline> lines = contour_lines(plot.grid, plot.levels[k]);
    const std::string name = fmt::format("contour_{}", k);
    const std::string block = line_block(name, lines);
    if (block.empty()) continue;
    script.before += block;
    script.drawing += fmt::format(", \\\n     ${} with lines linewidth 1.6 linecolor rgb '#000000'", name);
    const std::optional<CurvePoint> place = label_place(lines, taken);
    if (!place) continue;
    taken.push_back(*place);
    script.before += fmt::format("set label {} at {},{} center front boxed font 'DejaVu Sans,10'\n",
                                 gnuplot_quoted(fmt::format("{:.4g}", plot.levels[k])),
                                 gnuplot_number(place->x), gnuplot_number(place->y));
  }
  return script;
}

std::string outline_drawing(const std::string& block) {
  return block.empty() ? "" : ", \\\n     $outlines with lines linewidth 2.5 linecolor rgb '#404040'";
}

}  // namespace

void write_field_plot(const std::filesystem::path& path, const FieldPlot& plot, PictureSize size) {
  const GridValues& grid = plot.grid;
  if (grid.values.size() != grid.columns * grid.rows || !(grid.spacing > 0.0)) {
    throw std::invalid_argument(
        fmt::format("The plot '{}' has a grid of another size than its values", plot.title));
  }
  const double half = 0.5 * grid.spacing;
  const auto extent = [&](double origin, std::size_t points) {
    return PlotRange{origin - half, origin + grid.spacing * static_cast<double>(points) - half};
  };
  const PlotRange all_values = range_of(grid.values, plot.title);
  const FieldAxes axes{plot.x_range.value_or(extent(grid.origin_x, grid.columns)),
                       plot.y_range.value_or(extent(grid.origin_y, grid.rows)),
                       plot.value_range.value_or(all_values)};
  std::string field = "$field << END_OF_DATA\n";
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      field +=
          fmt::format("{} {} {}\n", gnuplot_number(grid.origin_x + grid.spacing * static_cast<double>(i)),
                      gnuplot_number(grid.origin_y + grid.spacing * static_cast<double>(j)),
                      gnuplot_number(grid.at(i, j)));
    }
  }
  field += "END_OF_DATA\n";
  const ContourScript contours = contour_script(plot);
  const std::string outlines = line_block("outlines", plot.outlines);
  run_gnuplot(path, frame_script(axes, size, plot.title, plot.x_label, plot.y_label, plot.value_label) +
                        field + contours.before + outlines + "plot $field using 1:2:3 with image" +
                        contours.drawing + outline_drawing(outlines) + "\n");
}

void write_scatter_plot(const std::filesystem::path& path, const ScatterPlot& plot, PictureSize size) {
  if (plot.x.size() != plot.y.size() || plot.x.size() != plot.value.size()) {
    throw std::invalid_argument(fmt::format("The plot '{}' needs as many x as y and values", plot.title));
  }
  const FieldAxes axes{plot.x_range.value_or(range_of(plot.x, plot.title)),
                       plot.y_range.value_or(range_of(plot.y, plot.title)),
                       plot.value_range.value_or(range_of(plot.value, plot.title))};
  std::string points = "$points << END_OF_DATA\n";
  for (std::size_t k = 0; k < plot.x.size(); ++k) {
    points += fmt::format("{} {} {} {}\n", gnuplot_number(plot.x[k]), gnuplot_number(plot.y[k]),
                          gnuplot_number(0.5 * plot.point_size), gnuplot_number(plot.value[k]));
  }
  points += "END_OF_DATA\n";
  const std::string outlines = line_block("outlines", plot.outlines);
  const char* drawing =
      plot.point_size > 0.0
          ? "plot $points using 1:2:3:4 with circles linecolor palette fillstyle solid noborder"
          : "plot $points using 1:2:4 with points pointtype 7 pointsize 0.5 palette";
  run_gnuplot(path, frame_script(axes, size, plot.title, plot.x_label, plot.y_label, plot.value_label) +
                        points + outlines + drawing + outline_drawing(outlines) + "\n");
}

}  // namespace eisph
