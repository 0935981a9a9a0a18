#include "app/build_info.hpp"
#include "app/case_choice.hpp"
#include "app/commands.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress.hpp"
#include "app/scene_report.hpp"
#include "app/stability/stability_atlas.hpp"
#include "compare/plot.hpp"
#include "core/assets.hpp"
#include "io/file_io.hpp"
#include "io/host.hpp"
#include "io/scene_file.hpp"
#include "scheme/simulation.hpp"

#include <chrono>
#include <iterator>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace eisph {

namespace {

/// The scene of a cell, for one of the variants of its case.
Scene scene_of(const StabilityCase& row, const StabilityScheme& scheme, const AtlasCell& cell,
               const std::vector<std::string>& variant) {
  const auto file = shipped_scene(row.scene);
  std::vector<std::string> overrides = row.overrides;
  overrides.insert(overrides.end(), variant.begin(), variant.end());
  if (cell.spacing_factor != 1.0) {
    const double spacing = load_scene(file, overrides).particle_spacing;
    overrides.push_back(fmt::format("particles.spacing={:.17g}", cell.spacing_factor * spacing));
  }
  overrides.insert(overrides.end(), scheme.overrides.begin(), scheme.overrides.end());
  overrides.push_back(fmt::format("scheme.{}={:.17g}", cell.step_key, cell.step));
  return load_scene(file, overrides);
}

AtlasCell fill_cell(const StabilityCase& row, const StabilityScheme& scheme, double step_factor,
                    double spacing_factor, int threads, const std::function<bool()>& stop_requested) {
  AtlasCell cell;
  cell.case_name = row.name;
  cell.scheme = scheme.name;
  cell.step_key = scheme.step_key;
  cell.step = step_factor * scheme.step;
  cell.spacing_factor = spacing_factor;
  const auto variants = row.variants.empty() ? std::vector<std::vector<std::string>>{{}} : row.variants;
  bool first = true;
  for (const std::vector<std::string>& variant : variants) {
    const Scene scene = scene_of(row, scheme, cell, variant);
    if (first) cell.warnings = scene_warnings(scene, Simulation::create(scene, 1)->plan());
    const StabilityOutcome outcome = try_out(scene, threads, stop_requested);
    if (first || outcome.stability > cell.outcome.stability) {
      cell.outcome = outcome;
      cell.variant = variant.empty() ? "" : variant.front();
    }
    first = false;
  }
  return cell;
}

}  // namespace

int stability_command(const StabilityOptions& options, std::ostream& out) {
  if (options.list) {
    for (const StabilityCase& known : stability_cases(options.full)) {
      fmt::print(out, "{:<18}{}\n", known.name, known.title);
    }
    return 0;
  }
  const InterruptWatcher interrupt;
  const auto stop = [&interrupt] { return interrupt.requested(); };
  Atlas atlas;
  const std::vector<StabilityCase> all = stability_cases(options.full);
  for (const StabilityCase* chosen : choose_cases("stability", all, options.cases)) {
    atlas.cases.push_back(*chosen);
  }
  atlas.schemes = choose_by_text(
      "stability --only", stability_schemes(), [](const StabilityScheme& scheme) { return scheme.name; },
      options.only);
  atlas.step_factors = options.full
                           ? std::vector<double>(std::begin(kFullStepFactors), std::end(kFullStepFactors))
                           : std::vector<double>(std::begin(kQuickStepFactors), std::end(kQuickStepFactors));
  atlas.spacing_factors = options.full ? std::vector<double>{1.0, 0.5} : std::vector<double>{1.0};
  require_gnuplot();
  create_folder(options.out);
  const BuildInfo build = build_info();
  const std::string subtitle =
      fmt::format("{}{}, {}", software_name(), build.commit.empty() ? "" : " (" + build.commit + ")",
                  iso_time(std::chrono::system_clock::now()));
  for (const StabilityCase& row : atlas.cases) {
    for (const StabilityScheme& scheme : atlas.schemes) {
      for (const double spacing : atlas.spacing_factors) {
        for (const double factor : atlas.step_factors) {
          const AtlasCell cell = fill_cell(row, scheme, factor, spacing, options.threads, stop);
          if (interrupt.requested()) {
            fmt::print(out, "interrupted; finished cases are in {}\n", options.out.string());
            return kInterrupted;
          }
          if (!options.quiet) {
            fmt::print(out, "{:<14}{:<24}{} {:<7.3g}{:g} dx  {}{}{}\n", row.name, scheme.name, cell.step_key,
                       cell.step, spacing, stability_name(cell.outcome.stability),
                       cell.outcome.reason.empty() ? "" : ": ", cell.outcome.reason);
            out.flush();
          }
          atlas.cells.push_back(cell);
        }
      }
    }
    write_atlas(options.out, atlas, subtitle);
  }
  if (!options.quiet) fmt::print(out, "report in {}\n", (options.out / "report.html").string());
  return 0;
}

}  // namespace eisph
