#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace eisph {

struct TableColumn {
  std::string name;
  std::string unit;  ///< SI; "-" for a pure number
};

/// A table that grows by rows while a run goes on.
struct TableHeader {
  std::string name;
  std::vector<TableColumn> columns;
};

/// Takes tables row by row: what a probe hands its values to.
class TableSink {
 public:
  virtual ~TableSink() = default;
  /// Starts a table and returns its number.
  virtual std::size_t open_table(const TableHeader& header) = 0;
  /// Adds one row: a value per column, not-a-number where there is none.
  virtual void append_row(std::size_t table, std::span<const double> row) = 0;
};

}  // namespace eisph
