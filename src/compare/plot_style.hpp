#pragma once

#include "compare/plot.hpp"

#include <map>
#include <set>
#include <string>

namespace eisph {

/// How one series is drawn.
struct SeriesLook {
  std::string colour;        ///< #rrggbb
  int point_type = 7;        ///< of gnuplot
  bool is_repeated = false;  ///< a colour that an earlier series has: lines are then dashed
};

/// Colour number k of those for series (0 is black), which readers who do not see all colours can tell apart.
[[nodiscard]] std::string series_colour(int k);

/// Gives every series a look of its own, and the same look to series with the same label in several plots.
class SeriesLooks {
 public:
  [[nodiscard]] SeriesLook look_of(const PlotSeries& series);

 private:
  int take_colour(const PlotSeries& series);

  std::map<std::string, SeriesLook> by_label_;
  std::set<int> used_colours_;
  int point_kinds_ = 0;
  bool is_repeating_ = false;
};

/// What follows the data in a plot command: "with lines ... title ...".
[[nodiscard]] std::string series_drawing(const PlotSeries& series, const SeriesLook& look);

}  // namespace eisph
