#pragma once

#include "app/pareto/pareto_cases.hpp"
#include "app/validate/validator.hpp"
#include "compare/pareto_front.hpp"
#include "core/peer_run.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

/// What came of one setting on one spacing, or of another program. What that did not tell is not-a-number.
struct ParetoPoint {
  std::string scheme;
  std::string step;
  double spacing = 0.0;  ///< m
  std::uint64_t particles = 0;
  std::uint64_t steps = 0;
  double time_step = 0.0;         ///< s, mean
  std::vector<double> cpu_times;  ///< CPU s per simulated s, of every repetition
  double pair_evaluations = 0.0;  ///< per simulated s
  double state_memory = 0.0;      ///< of the solver, bytes
  double compression = 0.0;       ///< largest number density - 1
  double energy_gain = 0.0;       ///< over the initial energy
  std::vector<double> errors;     ///< per cent, in the order of ParetoCase::errors
  std::string failure;            ///< of a blow-up; then there is no error

  /// Median of the repetitions.
  [[nodiscard]] double cpu_time() const;
};

struct ParetoResult {
  const ParetoCase* chosen = nullptr;
  double end = 0.0;  ///< s
  std::vector<ParetoPoint> points;
  double reference_spacing = 0.0;        ///< m; 0: no reference run
  std::vector<double> reference_spread;  ///< errors of delta-SPH at the spacing of the reference, per cent

  /// Costs against one error; by CPU time, or by pair evaluations.
  [[nodiscard]] std::vector<CostAndError> costs(std::size_t error, bool pairs) const;
};

/// Runs the settings on all spacings of a case, `repeats` times, every other time in reverse order, so that
/// a machine that becomes slower or faster favours none. Those of `peers` that are of this case follow them.
/// Throws ValidationInterrupted.
[[nodiscard]] ParetoResult study(const ParetoCase& chosen, const std::vector<ParetoSetting>& settings,
                                 int repeats, Validator& validator, const std::vector<PeerRun>& peers = {});

/// Writes <folder>/<case>.csv and the charts <folder>/<case>_<error>.png and _pairs.png.
void write_pareto_case(const std::filesystem::path& folder, const ParetoResult& result);
/// Writes pareto.json and report.html of all cases; charts must have been written.
void write_pareto_report(const std::filesystem::path& folder, const std::vector<ParetoResult>& results,
                         const std::string& subtitle);

}  // namespace eisph
