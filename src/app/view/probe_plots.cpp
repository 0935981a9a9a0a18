#include "app/view/probe_plots.hpp"

#include "compare/number_table.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kSameTime = 1e-6;  ///< s

/// Columns that tell when and where, not what.
bool is_coordinate(const std::string& name) {
  return name == "time" || name == "step" || name == "distance" || name == "x" || name == "y" || name == "z";
}

}  // namespace

std::vector<ProbePlot> plots_of(const PlotTable& table, double time) {
  std::vector<ProbePlot> plots;
  const auto column_of = [&table](const char* name) -> const std::vector<double>* {
    for (std::size_t c = 0; c < table.header.columns.size(); ++c) {
      if (table.header.columns[c].name == name) return &table.columns[c];
    }
    return nullptr;
  };
  const std::vector<double>* times = column_of("time");
  const std::vector<double>* distances = column_of("distance");
  if (times == nullptr) return plots;
  if (distances == nullptr && std::adjacent_find(times->begin(), times->end()) != times->end()) return plots;
  // Rows of the plot: all of them, or those of one time.
  std::size_t first = 0;
  std::size_t last = times->size();
  std::string title = table.header.name;
  if (distances != nullptr) {
    while (last > 0 && (*times)[last - 1] > time + kSameTime) --last;
    first = last;
    while (first > 0 && (*times)[first - 1] == (*times)[last - 1]) --first;
    if (first < last) title += fmt::format(" at {:.4g} s", (*times)[last - 1]);
  }
  const auto rows = [first, last](const std::vector<double>& column) {
    return std::vector<double>(column.begin() + static_cast<std::ptrdiff_t>(first),
                               column.begin() + static_cast<std::ptrdiff_t>(last));
  };
  plots.reserve(table.header.columns.size());
  for (std::size_t c = 0; c < table.header.columns.size(); ++c) {
    const TableColumn& column = table.header.columns[c];
    if (is_coordinate(column.name)) continue;
    // Pure numbers have no scale in common.
    auto plot = std::find_if(plots.begin(), plots.end(), [&column](const ProbePlot& known) {
      return known.unit == column.unit && known.unit != "-";
    });
    if (plot == plots.end()) {
      plots.push_back({.title = title,
                       .unit = column.unit,
                       .over_distance = distances != nullptr,
                       .x = rows(distances != nullptr ? *distances : *times),
                       .series = {}});
      plot = plots.end() - 1;
    }
    plot->series.push_back({column.name, rows(table.columns[c])});
  }
  return plots;
}

std::vector<ProbePlot> plots_of(const std::vector<PlotTable>& tables, double time) {
  std::vector<ProbePlot> all;
  for (const PlotTable& table : tables) {
    std::vector<ProbePlot> plots = plots_of(table, time);
    std::move(plots.begin(), plots.end(), std::back_inserter(all));
  }
  return all;
}

std::size_t PlotTables::open_table(const TableHeader& header) {
  const std::lock_guard lock(mutex_);
  tables_.push_back({header, std::vector<std::vector<double>>(header.columns.size())});
  return tables_.size() - 1;
}

void PlotTables::append_row(std::size_t table, std::span<const double> row) {
  const std::lock_guard lock(mutex_);
  PlotTable& grown = tables_.at(table);
  for (std::size_t c = 0; c < row.size(); ++c) grown.columns[c].push_back(row[c]);
  ++rows_;
}

std::shared_ptr<const std::vector<ProbePlot>> PlotTables::plots() const {
  const std::lock_guard lock(mutex_);
  if (plotted_rows_ != rows_) {
    plots_ = std::make_shared<const std::vector<ProbePlot>>(
        plots_of(tables_, std::numeric_limits<double>::infinity()));
    plotted_rows_ = rows_;
  }
  return plots_;
}

std::vector<PlotTable> read_plot_tables(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<PlotTable> tables;
  tables.reserve(files.size());
  for (const std::filesystem::path& file : files) {
    try {
      NumberTable numbers = read_number_table(file);
      TableHeader header{.name = file.stem().string(), .columns = {}};
      header.columns.reserve(numbers.names.size());
      for (std::size_t c = 0; c < numbers.names.size(); ++c) {
        header.columns.push_back({numbers.names[c], numbers.units[c]});
      }
      tables.push_back({std::move(header), std::move(numbers.columns)});
    } catch (const InputError&) {  // not one of the program's tables
    }
  }
  return tables;
}

}  // namespace eisph
