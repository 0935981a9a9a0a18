#pragma once

#include "compare/number_table.hpp"

#include <string>
#include <vector>

namespace eisph {

/// Figures measured or published by others, from assets/reference/<name>.csv.
struct ReferenceTable : NumberTable {
  std::string citation;            ///< whose figures, and where they are published
  std::vector<std::string> notes;  ///< what was measured, units, conversions
};

/// Reads assets/reference/<name>.csv in home_folder(). Its first comment is the citation. Unlike in a table
/// of a run every field has a number. Throws InputError as read_number_table() does, or if there is no
/// citation.
[[nodiscard]] ReferenceTable reference_table(const std::string& name);
[[nodiscard]] ReferenceTable read_reference_table(const std::filesystem::path& path);

}  // namespace eisph
