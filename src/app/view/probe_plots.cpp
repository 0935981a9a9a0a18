#include "app/view/probe_plots.hpp"

#include "compare/number_table.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace eisph {

namespace {

/// Columns that tell when and where, not what.
bool is_coordinate(const std::string& name) {
  return name == "time" || name == "step" || name == "distance" || name == "x" || name == "y" || name == "z";
}

}  // namespace

std::vector<ProbePlot> plots_of(const TableHeader& header, const std::vector<std::vector<double>>& columns) {
  std::vector<ProbePlot> plots;
  const auto place_of_time = std::find_if(header.columns.begin(), header.columns.end(),
                                          [](const TableColumn& column) { return column.name == "time"; });
  if (place_of_time == header.columns.end()) return plots;
  const std::vector<double>& time = columns[static_cast<std::size_t>(place_of_time - header.columns.begin())];
  if (std::adjacent_find(time.begin(), time.end()) != time.end()) return plots;
  plots.reserve(header.columns.size());
  for (std::size_t c = 0; c < header.columns.size(); ++c) {
    const TableColumn& column = header.columns[c];
    if (is_coordinate(column.name)) continue;
    // Pure numbers have no scale in common.
    auto plot = std::find_if(plots.begin(), plots.end(), [&column](const ProbePlot& known) {
      return known.unit == column.unit && known.unit != "-";
    });
    if (plot == plots.end()) {
      plots.push_back({.title = header.name, .unit = column.unit, .time = time, .series = {}});
      plot = plots.end() - 1;
    }
    plot->series.push_back({column.name, columns[c]});
  }
  return plots;
}

std::size_t PlotTables::open_table(const TableHeader& header) {
  const std::lock_guard lock(mutex_);
  tables_.push_back({header, std::vector<std::vector<double>>(header.columns.size())});
  return tables_.size() - 1;
}

void PlotTables::append_row(std::size_t table, std::span<const double> row) {
  const std::lock_guard lock(mutex_);
  Table& grown = tables_.at(table);
  for (std::size_t c = 0; c < row.size(); ++c) grown.columns[c].push_back(row[c]);
  ++rows_;
}

std::shared_ptr<const std::vector<ProbePlot>> PlotTables::plots() const {
  const std::lock_guard lock(mutex_);
  if (plotted_rows_ != rows_) {
    auto plots = std::make_shared<std::vector<ProbePlot>>();
    for (const Table& table : tables_) {
      for (ProbePlot& plot : plots_of(table.header, table.columns)) plots->push_back(std::move(plot));
    }
    plots_ = std::move(plots);
    plotted_rows_ = rows_;
  }
  return plots_;
}

std::vector<ProbePlot> read_plots(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<ProbePlot> plots;
  for (const std::filesystem::path& file : files) {
    try {
      const NumberTable table = read_number_table(file);
      TableHeader header{.name = file.stem().string(), .columns = {}};
      for (std::size_t c = 0; c < table.names.size(); ++c) {
        header.columns.push_back({table.names[c], table.units[c]});
      }
      for (ProbePlot& plot : plots_of(header, table.columns)) plots.push_back(std::move(plot));
    } catch (const InputError&) {  // not one of the program's tables
    }
  }
  return plots;
}

}  // namespace eisph
