#pragma once

#include "app/stability/stability_cases.hpp"
#include "core/run_summary.hpp"
#include "core/scene.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace eisph {

enum class Stability { Stable, Degraded, BlownUp };

[[nodiscard]] const char* stability_name(Stability stability);

/// How a run ended.
struct StabilityOutcome {
  Stability stability = Stability::Stable;
  std::string reason;  ///< by which measure it is degraded, or when and where it blew up
  double time = 0.0;   ///< s, reached
};

/// Limits beyond which a run that went to its end counts as degraded.
struct StabilityLimits {
  double compression = 0.05;  ///< 95th percentile of the number density - 1
  double energy_gain = 0.01;  ///< largest rise of the energy over the initial one
};

/// What a finished run is: degraded when particles passed walls or were lost, or by the limits.
/// `compression`: the 95th percentile, largest after the first fifth of the run, so that a bad start does not
/// count.
[[nodiscard]] StabilityOutcome judge(const RunSummary& summary, double compression,
                                     const StabilityLimits& limits = {});

/// Simulates without outputs to the end and judges. Never throws for what the simulation does: a blow-up, and
/// a time step that has shrunk so far that the run would need more than 50 times the steps planned, are
/// outcomes.
[[nodiscard]] StabilityOutcome try_out(const Scene& scene, int threads,
                                       const std::function<bool()>& stop_requested);

struct AtlasCell {
  std::string case_name;
  std::string scheme;
  double step = 0.0;  ///< phi or Courant number
  std::string step_key;
  double spacing_factor = 1.0;
  StabilityOutcome outcome;
  std::string variant;                ///< of the worst run, if the case has several
  std::vector<std::string> warnings;  ///< what `check` would say
};

struct Atlas {
  std::vector<StabilityCase> cases;
  std::vector<StabilityScheme> schemes;
  std::vector<double> step_factors;     ///< of each scheme's default step
  std::vector<double> spacing_factors;  ///< of each scene's spacing
  std::vector<AtlasCell> cells;
};

/// Writes atlas.csv, atlas.json, a map for each scheme and report.html.
void write_atlas(const std::filesystem::path& folder, const Atlas& atlas, const std::string& subtitle);

}  // namespace eisph
