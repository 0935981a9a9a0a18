#pragma once

#include "core/table.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace eisph {

/// Columns of one table and one unit over time, or along a line.
struct ProbePlot {
  struct Series {
    std::string name;
    std::vector<double> values;  ///< not-a-number where there is none
  };
  std::string title;  ///< of the table
  std::string unit;
  bool over_distance = false;
  std::vector<double> x;  ///< time, s, or distance, m
  std::vector<Series> series;
};

/// A table in memory.
struct PlotTable {
  TableHeader header;
  std::vector<std::vector<double>> columns;
};

/// The columns of a table over its column `time`, those of one unit together but pure numbers apart. A table
/// of a line is plotted over its column `distance`, at the last time up to `time` (s); other tables with
/// several rows at a time give nothing.
[[nodiscard]] std::vector<ProbePlot> plots_of(const PlotTable& table, double time);
[[nodiscard]] std::vector<ProbePlot> plots_of(const std::vector<PlotTable>& tables, double time);

/// Tables in memory, filled by one thread and read by another.
class PlotTables final : public TableSink {
 public:
  std::size_t open_table(const TableHeader& header) override;
  void append_row(std::size_t table, std::span<const double> row) override;

  /// What has been recorded so far; the same object as long as nothing is added.
  [[nodiscard]] std::shared_ptr<const std::vector<ProbePlot>> plots() const;

 private:
  mutable std::mutex mutex_;
  std::vector<PlotTable> tables_;
  std::uint64_t rows_ = 0;
  mutable std::uint64_t plotted_rows_ = 0;
  mutable std::shared_ptr<const std::vector<ProbePlot>> plots_ =
      std::make_shared<const std::vector<ProbePlot>>();
};

/// All tables (.csv) in the folder of a run. Files that are no tables of numbers are left out.
[[nodiscard]] std::vector<PlotTable> read_plot_tables(const std::filesystem::path& folder);

}  // namespace eisph
