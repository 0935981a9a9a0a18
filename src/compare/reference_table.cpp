#include "compare/reference_table.hpp"

#include "core/assets.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

namespace eisph {

ReferenceTable read_reference_table(const std::filesystem::path& path) {
  ReferenceTable table{read_number_table(path, EmptyFields::AreErrors), {}, {}};
  if (table.comments.empty() || table.comments.front().empty()) {
    throw InputError(
        fmt::format("{}: no citation: its first line should be '# AUTHOR (YEAR), ...'", path.string()));
  }
  table.citation = table.comments.front();
  table.notes.assign(table.comments.begin() + 1, table.comments.end());
  if (table.rows() == 0) throw InputError(fmt::format("{}: no rows", path.string()));
  return table;
}

ReferenceTable reference_table(const std::string& name) {
  return read_reference_table(home_folder() / "assets" / "reference" / (name + ".csv"));
}

}  // namespace eisph
