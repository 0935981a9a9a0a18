#include "io/csv_table.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

/// As a field of the file: in quotes where it has a character with a meaning of its own.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char character : text) {
    if (character == '"') field += '"';
    field += character;
  }
  return field + '"';
}

std::string header_line(const std::vector<TableColumn>& columns) {
  std::string line;
  for (const TableColumn& column : columns) {
    if (!line.empty()) line += ',';
    line += quoted(fmt::format("{} [{}]", column.name, column.unit));
  }
  return line + '\n';
}

void add_number(std::string& line, double value) {
  if (std::isnan(value)) return;
  char digits[32];
  const auto end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
  line.append(std::begin(digits), end);
}

std::string file_name(const std::string& table) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  std::string name = table;
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return kPlain.find(c) == std::string_view::npos; }, '_');
  return name + ".csv";
}

}  // namespace

CsvTable::CsvTable(std::filesystem::path path, const std::vector<TableColumn>& columns)
    : path_(std::move(path)), columns_(columns.size()), file_(path_) {
  file_.append(header_line(columns));
}

void CsvTable::append(std::span<const double> row) {
  if (row.size() != columns_) {
    throw std::invalid_argument(
        fmt::format("{}: a row of {} values for {} columns", path_.string(), row.size(), columns_));
  }
  std::string line;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0) line += ',';
    add_number(line, row[k]);
  }
  line += '\n';
  file_.append(line);
}

CsvFolder::CsvFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::size_t CsvFolder::open_table(const TableHeader& header) {
  const std::string name = file_name(header.name);
  const auto [entry, is_new] = table_of_file_.try_emplace(name, header.name);
  if (!is_new) {
    throw InputError(
        fmt::format("{}: both '{}' and '{}' would be written to it: give them names of their own",
                    (folder_ / name).string(), entry->second, header.name));
  }
  create_folder(folder_);
  tables_.emplace_back(folder_ / name, header.columns);
  return tables_.size() - 1;
}

void CsvFolder::append_row(std::size_t table, std::span<const double> row) { tables_.at(table).append(row); }

}  // namespace eisph
