#include "compare/plot.hpp"

#include "compare/gnuplot.hpp"
#include "compare/plot_axes.hpp"
#include "compare/plot_size.hpp"
#include "compare/plot_style.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

/// Data of one series as a block of a script. Values that a logarithmic axis cannot show count as none.
std::string data_block(const std::string& name, const Plot& plot, const PlotSeries& series) {
  const bool is_band = series.style == SeriesStyle::Band;
  if (is_band && series.curve.x != series.upper.x) {
    throw std::invalid_argument(
        fmt::format("The edges of the band '{}' do not have the same x", series.label));
  }
  std::string block = "$" + name + " << END_OF_DATA\n";
  const auto drawn = [](double value, bool is_log) {
    return gnuplot_number(is_log && !(value > 0.0) ? std::nan("") : value);
  };
  for (std::size_t k = 0; k < series.curve.size(); ++k) {
    if (is_band && (std::isnan(series.curve.y[k]) || std::isnan(series.upper.y[k]))) continue;
    block += drawn(series.curve.x[k], plot.x_log) + ' ' + drawn(series.curve.y[k], plot.y_log);
    if (is_band) block += ' ' + drawn(series.upper.y[k], plot.y_log);
    block += '\n';
  }
  return block + "END_OF_DATA\n";
}

bool has_data(const PlotSeries& series) { return !series.curve.empty(); }

/// Bands first: lines and points lie on top of them.
std::vector<const PlotSeries*> drawing_order(const Plot& plot) {
  std::vector<const PlotSeries*> order;
  for (const PlotSeries& series : plot.series) {
    if (has_data(series)) order.push_back(&series);
  }
  std::stable_partition(order.begin(), order.end(),
                        [](const PlotSeries* series) { return series->style == SeriesStyle::Band; });
  return order;
}

/// Data blocks and the plot command. Without a legend the series have no titles.
std::string drawing_script(const Plot& plot, const std::string& prefix, SeriesLooks& looks) {
  std::string blocks;
  std::string command = "plot ";
  std::size_t number = 0;
  for (const PlotSeries* series : drawing_order(plot)) {
    const std::string name = fmt::format("{}_{}", prefix, number);
    blocks += data_block(name, plot, *series);
    const char* columns = series->style == SeriesStyle::Band ? "1:2:3" : "1:2";
    command += fmt::format("{}${} using {} {}", number > 0 ? ", \\\n     " : "", name, columns,
                           series_drawing(*series, looks.look_of(*series)));
    ++number;
  }
  return blocks + command + "\n";
}

/// One panel of several, in a cell of the picture given by the edges of its axes (0 to 1).
struct PanelPlace {
  double left;
  double right;
  double bottom;
  double top;
};

std::string margins(const PanelPlace& place) {
  return fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\n",
      place.left, place.right, place.bottom, place.top);
}

/// A legend of every label in the plots, in the order in which they come, in a row at the bottom.
std::string common_legend(const std::vector<Plot>& plots, double height, SeriesLooks& looks) {
  std::string command;
  std::set<std::string> labels;
  for (const Plot& plot : plots) {
    for (const PlotSeries& series : plot.series) {
      if (series.label.empty() || !labels.insert(series.label).second) continue;
      const char* columns = series.style == SeriesStyle::Band ? "1:2:3" : "1:2";
      command += fmt::format("{}$nothing using {} {}", command.empty() ? "plot " : ", \\\n     ", columns,
                             series_drawing(series, looks.look_of(series)));
    }
  }
  if (command.empty()) return {};
  return "$nothing << END_OF_DATA\n-1 -1 -1\nEND_OF_DATA\n" + margins({0.02, 0.98, 0.0, height}) +
         "unset title\nunset border\nunset tics\nunset xlabel\nunset ylabel\nunset grid\n"
         "unset logscale\nset size noratio\nset xrange [0:1]\nset yrange [0:1]\n"
         "set key inside center center horizontal Left reverse samplen 2.2 spacing 1.25 width 1 nobox\n" +
         command + "\n";
}

/// Whether all plots have the same label along an axis.
bool share_label(const std::vector<Plot>& plots, std::string Plot::*label) {
  return std::all_of(plots.begin(), plots.end(),
                     [&](const Plot& plot) { return plot.*label == plots.front().*label; });
}

}  // namespace

void write_plot(const std::filesystem::path& path, const Plot& plot, PictureSize size) {
  const PlotAxes axes = plot_axes(plot);
  if (size.height == 0)
    size = fitting_size(axes.x, axes.y, size.width, {.left = 94, .right = 32, .above = 60, .below = 64});
  SeriesLooks looks;
  run_gnuplot(path, gnuplot_preamble(size.width, size.height) +
                        fmt::format("set title {}\n", gnuplot_quoted(plot.title)) + axes_script(plot, axes) +
                        legend_script(legend_position(plot, axes, size)) +
                        drawing_script(plot, "series", looks));
}

void write_plots(const std::filesystem::path& path, const std::string& title, const std::vector<Plot>& plots,
                 std::size_t columns, PictureSize size) {
  if (plots.empty() || columns == 0) throw std::invalid_argument("No plots to draw");
  const std::size_t rows = (plots.size() + columns - 1) / columns;
  // Room around the axes, as parts of the picture: title and legend, and in each cell labels and marks.
  const bool shares_x_label = share_label(plots, &Plot::x_label);
  const bool shares_y_label = share_label(plots, &Plot::y_label);
  const double head = title.empty() ? 0.0 : 40.0 / size.height;
  const double legend = 58.0 / size.height;
  const double label = 24.0 / size.height;
  const double foot = legend + (shares_x_label ? label : 0.0);
  const double cell_width = 1.0 / static_cast<double>(columns);
  const double cell_height = (1.0 - head - foot) / static_cast<double>(rows);
  const double left = 84.0 / size.width;
  const double right = 20.0 / size.width;
  const double below = 32.0 / size.height + (shares_x_label ? 0.0 : label);
  const double above = 32.0 / size.height;

  SeriesLooks looks;
  std::string script = gnuplot_preamble(size.width, size.height);
  script += "set multiplot\nunset key\n";
  if (!title.empty()) {
    script += fmt::format("set label 1 {} at screen 0.5,{:.5f} center font 'DejaVu Sans,14'\n",
                          gnuplot_quoted(title), 1.0 - 0.5 * head);
  }
  for (std::size_t k = 0; k < plots.size(); ++k) {
    const std::size_t row = k / columns;
    const double cell_left = cell_width * static_cast<double>(k % columns);
    const double cell_top = 1.0 - head - cell_height * static_cast<double>(row);
    script += margins(
        {cell_left + left, cell_left + cell_width - right, cell_top - cell_height + below, cell_top - above});
    script += fmt::format("set title {} offset 0,-0.6\n", gnuplot_quoted(plots[k].title));
    script += axes_script(plots[k], plot_axes(plots[k]));
    const bool is_lowest = k + columns >= plots.size();
    if (shares_x_label && !is_lowest) script += "unset xlabel\n";
    script += shares_y_label && k % columns != 0 ? "unset ylabel\n" : "set ylabel offset 0.5,0\n";
    script += drawing_script(plots[k], fmt::format("series_{}", k), looks);
    if (k == 0) script += "unset label 1\n";
  }
  script += common_legend(plots, legend, looks) + "unset multiplot\n";
  run_gnuplot(path, script);
}

}  // namespace eisph
