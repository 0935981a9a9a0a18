#pragma once

#include "core/table.hpp"
#include "io/file_io.hpp"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace eisph {

/// A CSV file that grows row by row. The first line names the columns with their units: `time [s],level [m]`.
/// Numbers have the fewest digits that give the same double when read back; not-a-number is an empty field.
/// A row is in the file as a whole when append() returns, so an interrupted run leaves a valid file. Failures
/// throw std::runtime_error naming the path.
class CsvTable {
 public:
  /// Creates the file, or replaces the one that is there, and writes the header.
  CsvTable(std::filesystem::path path, const std::vector<TableColumn>& columns);

  /// One value per column; throws std::invalid_argument for any other number of values.
  void append(std::span<const double> row);

 private:
  std::filesystem::path path_;
  std::size_t columns_;
  OutputFile file_;
};

/// Writes each table to <folder>/<table>.csv. Characters of a table's name other than letters, digits, '_',
/// '-' and '.' become '_' in the file's name.
class CsvFolder : public TableSink {
 public:
  /// Makes the folder with the first table.
  explicit CsvFolder(std::filesystem::path folder);

  /// Throws InputError if another table has the same file name, std::runtime_error if it cannot be written.
  std::size_t open_table(const TableHeader& header) override;
  void append_row(std::size_t table, std::span<const double> row) override;

 private:
  std::filesystem::path folder_;
  std::vector<CsvTable> tables_;
  std::map<std::string, std::string> table_of_file_;
};

}  // namespace eisph
