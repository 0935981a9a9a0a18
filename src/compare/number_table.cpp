#include "compare/number_table.hpp"

#include "compare/whole_file.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace eisph {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// Fields of a line between commas. In quotes a comma is no separator and two quotes are one.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') {
      if (is_quoted && k + 1 < line.size() && line[k + 1] == '"') {
        fields.back() += line[++k];
      } else {
        is_quoted = !is_quoted;
      }
    } else if (line[k] == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[k];
    }
  }
  for (std::string& field : fields) field = trimmed(field);
  return fields;
}

/// Splits `level [m]` into name and unit.
void add_column(NumberTable& table, const std::string& field) {
  const std::size_t bracket = field.rfind('[');
  const bool has_unit = bracket != std::string::npos && field.back() == ']';
  table.names.emplace_back(trimmed(has_unit ? std::string_view(field).substr(0, bracket) : field));
  table.units.push_back(has_unit ? field.substr(bracket + 1, field.size() - bracket - 2) : "");
  table.columns.emplace_back();
}

/// The number that a field is; not-a-number for an empty one.
std::optional<double> number(const std::string& field) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const char* end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

void add_row(NumberTable& table, std::size_t line, const std::vector<std::string>& fields,
             EmptyFields empty_fields) {
  if (fields.size() != table.names.size()) {
    throw InputError(fmt::format("{}:{}: {} fields, but the header names {} columns", table.path.string(),
                                 line, fields.size(), table.names.size()));
  }
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::optional<double> value = number(fields[k]);
    if (!value || (empty_fields == EmptyFields::AreErrors && !std::isfinite(*value))) {
      throw InputError(fmt::format("{}:{}: column '{}': '{}' is not a number", table.path.string(), line,
                                   table.names[k], fields[k]));
    }
    table.columns[k].push_back(*value);
  }
}

}  // namespace

const std::vector<double>& NumberTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError(
        fmt::format("{}: no column '{}'; it has {}", path.string(), name, fmt::join(names, ", ")));
  }
  return columns[static_cast<std::size_t>(found - names.begin())];
}

Curve NumberTable::curve(const std::string& x, const std::string& y, double x_factor, double y_factor) const {
  return scaled(make_curve(column(x), column(y)), x_factor, y_factor);
}

NumberTable read_number_table(const std::filesystem::path& path, EmptyFields empty_fields) {
  const std::string content = read_whole_file(path);
  NumberTable table;
  table.path = path;
  std::string_view rest = content;
  for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, length));
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (line.empty()) continue;
    if (table.names.empty() && line.front() == '#') {
      table.comments.emplace_back(trimmed(line.substr(1)));
    } else if (table.names.empty()) {
      for (const std::string& field : fields_of(line)) add_column(table, field);
    } else {
      add_row(table, line_number, fields_of(line), empty_fields);
    }
  }
  if (table.names.empty())
    throw InputError(fmt::format("{}: no header with the columns' names", path.string()));
  return table;
}

}  // namespace eisph
