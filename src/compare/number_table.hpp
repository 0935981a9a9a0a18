#pragma once

#include "compare/curve.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

/// A CSV file of numbers with named columns: `time [s],level [m]`, as the program writes them. Lines that
/// begin with '#' before the header are comments.
struct NumberTable {
  std::filesystem::path path;
  std::vector<std::string> comments;  ///< without the '#' and the space after it
  std::vector<std::string> names;     ///< of the columns, without units
  std::vector<std::string> units;     ///< "-" for a pure number, empty where the header has none
  std::vector<std::vector<double>> columns;

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// Throws InputError naming the file and the columns that it has.
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
  /// One column over another, both scaled.
  [[nodiscard]] Curve curve(const std::string& x, const std::string& y, double x_factor = 1.0,
                            double y_factor = 1.0) const;
};

enum class EmptyFields { AreGaps, AreErrors };

/// Reads a table of a run, where an empty field is not-a-number: no water there. Throws InputError naming
/// file, line and column if the file cannot be read, a row has another number of fields than the header, or a
/// field is no number.
[[nodiscard]] NumberTable read_number_table(const std::filesystem::path& path,
                                            EmptyFields empty_fields = EmptyFields::AreGaps);

}  // namespace eisph
