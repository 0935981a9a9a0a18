#include "compare/plot_style.hpp"

#include "compare/gnuplot.hpp"

#include <array>

#include <fmt/format.h>

namespace eisph {

namespace {

// Okabe & Ito (2008), Color Universal Design, without their yellow, which is too light for lines on white.
constexpr std::array kColours{"#000000", "#0072b2", "#d55e00", "#009e73",
                              "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f"};
constexpr int kColourCount = static_cast<int>(kColours.size());
constexpr int kBandColour = 6;

// Filled circle, square, triangle, diamond; then the open ones.
constexpr std::array kPointTypes{7, 5, 9, 13, 6, 4, 8, 12};

bool is_point(SeriesStyle style) { return style == SeriesStyle::Points || style == SeriesStyle::LinePoints; }

}  // namespace

std::string series_colour(int k) { return kColours[static_cast<std::size_t>(k % kColourCount)]; }

int SeriesLooks::take_colour(const PlotSeries& series) {
  if (series.colour >= 0) return series.colour % kColourCount;
  if (series.style == SeriesStyle::Band) return kBandColour;
  for (int k = series.style == SeriesStyle::Points ? 0 : 1; k < kColourCount; ++k) {
    if (used_colours_.count(k) == 0) return k;
  }
  used_colours_.clear();
  is_repeating_ = true;
  return 1;
}

SeriesLook SeriesLooks::look_of(const PlotSeries& series) {
  const auto known = by_label_.find(series.label);
  if (!series.label.empty() && known != by_label_.end()) return known->second;
  SeriesLook look;
  const int colour = take_colour(series);
  look.colour = series_colour(colour);
  look.is_repeated = is_repeating_ && series.colour < 0;
  if (series.style != SeriesStyle::Band) used_colours_.insert(colour);
  if (is_point(series.style)) {
    look.point_type = kPointTypes[static_cast<std::size_t>(point_kinds_++) % kPointTypes.size()];
  }
  if (!series.label.empty()) by_label_[series.label] = look;
  return look;
}

std::string series_drawing(const PlotSeries& series, const SeriesLook& look) {
  const std::string title = series.label.empty() ? "notitle" : "title " + gnuplot_quoted(series.label);
  const auto lines = [&](const char* dash) {
    return fmt::format("with lines linewidth 2 dashtype {} linecolor rgb '{}' {}", dash, look.colour, title);
  };
  switch (series.style) {
    case SeriesStyle::Line:
      return lines(look.is_repeated ? "(20,5)" : "solid");
    case SeriesStyle::Dashed:
      return lines("(9,5)");
    case SeriesStyle::Dotted:
      return lines("(2,4)");
    case SeriesStyle::Points:
      return fmt::format("with points pointtype {} pointsize 1.1 linecolor rgb '{}' {}", look.point_type,
                         look.colour, title);
    case SeriesStyle::LinePoints:
      return fmt::format("with linespoints linewidth 2 pointtype {} pointsize 1.1 linecolor rgb '{}' {}",
                         look.point_type, look.colour, title);
    case SeriesStyle::Band:
      return fmt::format("with filledcurves fillstyle solid 0.35 noborder fillcolor rgb '{}' {}", look.colour,
                         title);
  }
  return {};
}

}  // namespace eisph
