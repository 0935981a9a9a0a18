#include "app/stability/stability_atlas.hpp"
#include "compare/illustrated_page.hpp"
#include "compare/status_map.hpp"
#include "io/file_io.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace eisph {

namespace {

using Json = nlohmann::ordered_json;

std::string colour_of(Stability stability) {
  switch (stability) {
    case Stability::Stable:
      return "#7fbf7b";
    case Stability::Degraded:
      return "#fdd870";
    case Stability::BlownUp:
      break;
  }
  return "#d7604f";
}

/// The measure in a word for the map.
std::string short_reason(const StabilityOutcome& outcome) {
  if (outcome.stability == Stability::BlownUp) return fmt::format("{:.3g} s", outcome.time);
  if (outcome.stability == Stability::Stable) return "";
  for (const char* word : {"lost", "penetrations", "energy", "compression"}) {
    if (outcome.reason.find(word) != std::string::npos) return word;
  }
  return "";
}

/// A text as a field of a CSV file, whatever commas it has.
std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  return '"' + text + '"';
}

const AtlasCell* find_cell(const Atlas& atlas, const std::string& case_name, const StabilityScheme& scheme,
                           double step_factor, double spacing_factor) {
  for (const AtlasCell& cell : atlas.cells) {
    if (cell.case_name == case_name && cell.scheme == scheme.name && cell.spacing_factor == spacing_factor &&
        std::abs(cell.step - step_factor * scheme.step) < 1e-9) {
      return &cell;
    }
  }
  return nullptr;
}

StatusMap map_of(const Atlas& atlas, const StabilityScheme& scheme) {
  StatusMap map;
  map.title = fmt::format("{}: stable, degraded or blown up", scheme.name);
  for (const double spacing : atlas.spacing_factors) {
    for (const double factor : atlas.step_factors) {
      map.columns.push_back(fmt::format("{} {:.3g}{}", scheme.step_key, factor * scheme.step,
                                        spacing == 1.0 ? "" : fmt::format(", {:g} dx", spacing)));
    }
  }
  for (const StabilityCase& row : atlas.cases) {
    map.rows.push_back(row.title);
    for (const double spacing : atlas.spacing_factors) {
      for (const double factor : atlas.step_factors) {
        const AtlasCell* cell = find_cell(atlas, row.name, scheme, factor, spacing);
        map.cells.push_back(cell == nullptr ? StatusMap::Cell{"#eeeeee", ""}
                                            : StatusMap::Cell{colour_of(cell->outcome.stability),
                                                              short_reason(cell->outcome)});
      }
    }
  }
  for (const Stability stability : {Stability::Stable, Stability::Degraded, Stability::BlownUp}) {
    map.keys.push_back({colour_of(stability), stability_name(stability)});
  }
  return map;
}

std::filesystem::path map_path(const std::filesystem::path& folder, const StabilityScheme& scheme) {
  std::string name;
  for (const char character : scheme.name) {
    if (std::isalnum(static_cast<unsigned char>(character)) != 0) name += character;
  }
  return folder / (name + ".png");
}

std::vector<std::string> table_row(const AtlasCell& cell) {
  return {cell.case_name + (cell.variant.empty() ? "" : " (" + cell.variant + ")"),
          cell.scheme,
          fmt::format("{} {:.3g}", cell.step_key, cell.step),
          fmt::format("{:g}", cell.spacing_factor),
          stability_name(cell.outcome.stability),
          cell.outcome.reason,
          cell.warnings.empty() ? "no" : "yes"};
}

ReportTable cells_table(const std::vector<const AtlasCell*>& cells, const std::string& caption) {
  ReportTable table{.caption = caption,
                    .columns = {"case", "scheme", "time step", "spacing", "outcome", "reason", "check warns"},
                    .rows = {}};
  for (const AtlasCell* cell : cells) table.rows.push_back(table_row(*cell));
  return table;
}

}  // namespace

void write_atlas(const std::filesystem::path& folder, const Atlas& atlas, const std::string& subtitle) {
  std::string csv = "case,scheme,step_key,step [-],spacing_factor [-],outcome,time [s],warned [-],reason\n";
  Json json = {{"format", "eisph stability 1"}, {"header", subtitle}, {"cells", Json::array()}};
  std::vector<const AtlasCell*> all;
  std::vector<const AtlasCell*> unwarned;
  for (const AtlasCell& cell : atlas.cells) {
    const StabilityOutcome& outcome = cell.outcome;
    csv += fmt::format("{},{},{},{:g},{:g},{},{:g},{},{}\n", cell.case_name, quoted(cell.scheme),
                       cell.step_key, cell.step, cell.spacing_factor, stability_name(outcome.stability),
                       outcome.time, cell.warnings.empty() ? 0 : 1, quoted(outcome.reason));
    json["cells"].push_back({{"case", cell.case_name},
                             {"variant", cell.variant},
                             {"scheme", cell.scheme},
                             {"step_key", cell.step_key},
                             {"step", cell.step},
                             {"spacing_factor", cell.spacing_factor},
                             {"outcome", stability_name(outcome.stability)},
                             {"time", outcome.time},
                             {"reason", outcome.reason},
                             {"warnings", cell.warnings}});
    all.push_back(&cell);
    if (outcome.stability == Stability::BlownUp && cell.warnings.empty()) unwarned.push_back(&cell);
  }
  write_file_atomically(folder / "atlas.csv", csv);
  write_file_atomically(folder / "atlas.json", json.dump(2) + "\n");

  IllustratedPage page;
  page.title = "Where the schemes are stable";
  page.subtitle = subtitle;
  PageSection maps;
  maps.title = "Maps";
  const StabilityLimits limits;
  maps.paragraphs = {
      fmt::format("Every case ran to its end for every scheme, over the time step (default in the middle of "
                  "the range tried) "
                  "and the spacing. Degraded: particles passed a wall or were lost, the 95th percentile of "
                  "the compression "
                  "(number density - 1) rose above {:g} %, or the energy rose by more than {:g} % of the "
                  "initial one. The "
                  "word in a cell is the gravest of these, of blow-ups the time.",
                  100.0 * limits.compression, 100.0 * limits.energy_gain)};
  for (const StabilityScheme& scheme : atlas.schemes) {
    const auto path = map_path(folder, scheme);
    write_status_map(path, map_of(atlas, scheme));
    maps.figures.push_back({path, scheme.name + "."});
  }
  PageSection tables;
  tables.title = "Tables";
  tables.paragraphs = {
      unwarned.empty()
          ? "No run blew up in a setting of which eisph check does not warn."
          : "Some runs blew up in settings of which eisph check does not warn; they come first."};
  if (!unwarned.empty()) tables.tables.push_back(cells_table(unwarned, "Blown up without a warning"));
  tables.tables.push_back(cells_table(all, "All runs"));
  page.sections = {maps, tables};
  write_illustrated_page(folder / "report.html", page);
}

}  // namespace eisph
