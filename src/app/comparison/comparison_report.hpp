#pragma once

#include "app/comparison/photo_comparison.hpp"
#include "compare/illustrated_page.hpp"

#include <string>
#include <vector>

namespace eisph {

/// Figures of the report that are not those of one time.
struct ComparisonFigures {
  ReportFigure grid;
  std::optional<ReportFigure> calibration;
  std::vector<ReportFigure> classes;
  std::map<std::size_t, std::vector<ReportFigure>> by_photograph;
};

/// What stands at the top of everything that synthetic photographs go into.
[[nodiscard]] std::string synthetic_warning();

/// The page of a comparison; `statistics` are those of comparison.variants(), in their order.
[[nodiscard]] IllustratedPage comparison_page(const PhotoComparison& comparison, const std::string& run,
                                              const std::vector<NamedStatistics>& statistics,
                                              const Repeatability& repeatability,
                                              const ComparisonFigures& figures);

/// Statistics as text, m given in mm with two decimals: the thesis's rows, then RMS, correlation and overlap.
[[nodiscard]] ReportTable statistics_table(const std::string& caption,
                                           const std::vector<NamedStatistics>& statistics);

}  // namespace eisph
