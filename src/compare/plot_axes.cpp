#include "compare/plot_axes.hpp"

#include "compare/gnuplot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Calls action(x, y) for every value that can be drawn.
template <typename Action>
void for_each_value(const Plot& plot, Action action) {
  for (const PlotSeries& series : plot.series) {
    for (const Curve* curve : {&series.curve, &series.upper}) {
      for (std::size_t k = 0; k < curve->size(); ++k) {
        const double x = curve->x[k];
        const double y = curve->y[k];
        if (!std::isfinite(x) || !std::isfinite(y)) continue;
        if ((!plot.x_log || x > 0.0) && (!plot.y_log || y > 0.0)) action(x, y);
      }
    }
  }
}

void widen(PlotRange& range, double value) {
  range.least = std::min(range.least, value);
  range.most = std::max(range.most, value);
}

/// A range with some room at its ends; the end at zero of values of one sign stays.
PlotRange with_room(const PlotRange& range, bool is_log, double share) {
  if (is_log) {
    // Never none: a line along the frame is hard to see.
    const double factor =
        range.most > range.least ? std::pow(range.most / range.least, std::max(share, 0.02)) : 2.0;
    return {range.least / factor, range.most * factor};
  }
  const double width = range.most - range.least;
  const double room = width > 0.0 ? share * width : std::max(0.1 * std::abs(range.most), 1e-12);
  const double near_zero = std::max(room, 0.02 * width);
  return {range.least >= 0.0 && range.least <= near_zero ? 0.0 : range.least - room,
          range.most <= 0.0 && range.most >= -near_zero ? 0.0 : range.most + room};
}

/// Marks at 1, 2 and 5 times powers of ten for an axis that has too few powers; empty otherwise.
std::string log_marks(const PlotRange& range) {
  if (range.most / range.least > 200.0) return {};
  std::string marks;
  const int first = static_cast<int>(std::floor(std::log10(range.least)));
  const int last = static_cast<int>(std::floor(std::log10(range.most)));
  for (int power = first; power <= last; ++power) {
    for (const double digit : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0}) {
      const bool is_extra = digit == 1.5 || digit == 4.0;
      if (is_extra && range.most / range.least > 8.0) continue;
      const double mark = digit * std::pow(10.0, power);
      if (mark < range.least || mark > range.most) continue;
      marks += fmt::format("{}'{:.6g}' {}", marks.empty() ? "" : ", ", mark, gnuplot_number(mark));
    }
  }
  return marks;
}

std::string axis_script(char axis, const PlotRange& range, bool is_log, const std::string& label) {
  std::string script =
      fmt::format("set {}range [{}:{}]\n", axis, gnuplot_number(range.least), gnuplot_number(range.most));
  script += fmt::format("set {}label {}\n", axis, gnuplot_quoted(label));
  script += is_log ? fmt::format("set logscale {}\n", axis) : fmt::format("unset logscale {}\n", axis);
  const std::string marks = is_log ? log_marks(range) : "";
  script += marks.empty() ? fmt::format("set {}tics autofreq\n", axis)
                          : fmt::format("set {}tics ({})\n", axis, marks);
  return script;
}

/// Where a value lies along an axis, 0 to 1.
double place(double value, const PlotRange& range, bool is_log) {
  if (is_log) return std::log(value / range.least) / std::log(range.most / range.least);
  return (value - range.least) / (range.most - range.least);
}

/// Counts what is drawn in the corners of the plot.
class CornerCount {
 public:
  CornerCount(double width, double height) : width_(width), height_(height) {}

  void add(double x, double y) {
    if (x < 0.0 || x > 1.0 || y < 0.0 || y > 1.0) return;
    const bool is_left = x < width_;
    const bool is_right = x > 1.0 - width_;
    if (y > 1.0 - height_) {
      counts_[0] += is_right ? 1 : 0;
      counts_[1] += is_left ? 1 : 0;
    }
    if (y < height_) {
      counts_[2] += is_right ? 1 : 0;
      counts_[3] += is_left ? 1 : 0;
    }
  }
  void add_line(double x0, double y0, double x1, double y1) {
    constexpr int kSamples = 50;
    for (int k = 0; k <= kSamples; ++k) {
      const double part = static_cast<double>(k) / kSamples;
      add(x0 + part * (x1 - x0), y0 + part * (y1 - y0));
    }
  }
  [[nodiscard]] LegendPosition free_corner() const {
    constexpr std::array kCorners{LegendPosition::TopRight, LegendPosition::TopLeft,
                                  LegendPosition::BottomRight, LegendPosition::BottomLeft};
    for (std::size_t k = 0; k < kCorners.size(); ++k) {
      if (counts_[k] == 0) return kCorners[k];
    }
    return LegendPosition::Below;
  }

 private:
  double width_;
  double height_;
  std::array<int, 4> counts_{};
};

void count_curve(const Plot& plot, const PlotAxes& axes, const Curve& curve, bool has_line,
                 CornerCount& count) {
  double x_before = std::numeric_limits<double>::quiet_NaN();
  double y_before = x_before;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double x = place(curve.x[k], axes.x, plot.x_log);
    const double y = place(curve.y[k], axes.y, plot.y_log);
    count.add(x, y);
    if (has_line && std::isfinite(x_before + y_before + x + y)) count.add_line(x_before, y_before, x, y);
    x_before = x;
    y_before = y;
  }
}

}  // namespace

PlotAxes plot_axes(const Plot& plot) {
  PlotRange x_needed{kInfinity, -kInfinity};
  PlotRange y_needed{kInfinity, -kInfinity};
  const PlotRange x_allowed = plot.x_range.value_or(PlotRange{-kInfinity, kInfinity});
  for_each_value(plot, [&](double x, double y) {
    if (x < x_allowed.least || x > x_allowed.most) return;
    widen(x_needed, x);
    widen(y_needed, y);
  });
  if (x_needed.least > x_needed.most) {
    throw std::invalid_argument(fmt::format("The plot '{}' has no value to draw", plot.title));
  }
  // Lines may run from edge to edge; a lone value needs a width around it.
  const bool is_lone = x_needed.least == x_needed.most;
  const bool has_points = std::any_of(plot.series.begin(), plot.series.end(), [](const PlotSeries& series) {
    return series.style == SeriesStyle::Points || series.style == SeriesStyle::LinePoints;
  });
  const double x_share = is_lone || has_points ? 0.04 : 0.0;
  return {plot.x_range.value_or(with_room(x_needed, plot.x_log, x_share)),
          plot.y_range.value_or(with_room(y_needed, plot.y_log, 0.06))};
}

std::string axes_script(const Plot& plot, const PlotAxes& axes) {
  return axis_script('x', axes.x, plot.x_log, plot.x_label) +
         axis_script('y', axes.y, plot.y_log, plot.y_label) +
         (plot.equal_aspect ? "set size ratio -1\n" : "set size noratio\n");
}

LegendPosition legend_position(const Plot& plot, const PlotAxes& axes, PictureSize size) {
  if (plot.legend != LegendPosition::Automatic) return plot.legend;
  std::size_t entries = 0;
  std::size_t longest = 0;
  for (const PlotSeries& series : plot.series) {
    entries += series.label.empty() ? 0 : 1;
    longest = std::max(longest, series.label.size());
  }
  if (entries == 0) return LegendPosition::None;
  // Sizes in pixels of letters, samples, lines of the legend, and of what lies outside of the axes.
  const double width = (60.0 + 9.5 * static_cast<double>(longest)) / (size.width - 110.0);
  const double height = (16.0 + 22.0 * static_cast<double>(entries)) / (size.height - 110.0);
  CornerCount count(width, height);
  for (const PlotSeries& series : plot.series) {
    const bool has_line = series.style != SeriesStyle::Points;
    count_curve(plot, axes, series.curve, has_line, count);
    count_curve(plot, axes, series.upper, has_line, count);
  }
  return count.free_corner();
}

std::string legend_script(LegendPosition position) {
  const std::string form = " Left reverse samplen 2.2 spacing 1.25 width 1 nobox\n";
  switch (position) {
    case LegendPosition::TopLeft:
      return "set key inside top left" + form;
    case LegendPosition::TopRight:
      return "set key inside top right" + form;
    case LegendPosition::BottomLeft:
      return "set key inside bottom left" + form;
    case LegendPosition::BottomRight:
      return "set key inside bottom right" + form;
    case LegendPosition::Right:
      return "set key outside right top" + form;
    case LegendPosition::Automatic:
    case LegendPosition::Below:
      return "set key below center height 1" + form;
    case LegendPosition::None:
      break;
  }
  return "unset key\n";
}

}  // namespace eisph
