#include "app/pareto/pareto_study.hpp"

#include "app/pareto/peer_runs.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace eisph {

namespace {

std::vector<std::string> overrides_of(const std::vector<std::string>& setting, double spacing, double end) {
  std::vector<std::string> overrides;
  overrides.push_back(fmt::format("particles.spacing={:.17g}", spacing));
  overrides.push_back(fmt::format("end_time={:.17g}", end));
  overrides.insert(overrides.end(), setting.begin(), setting.end());
  return overrides;
}

RunRequest request_of(const ParetoCase& chosen, const std::string& label,
                      const std::vector<std::string>& overrides, double end) {
  RunRequest request{.scene = chosen.scene, .label = label, .overrides = overrides, .states = {}};
  if (chosen.states) request.states = {end};
  return request;
}

/// One run of a point; errors and memory are those of the first one, as repetitions give the same bits.
void add_run(ParetoPoint& point, const ParetoCase& chosen, const RunRequest& request,
             const std::optional<ValidationRun>& reference, Validator& validator) {
  ValidationRun run;
  try {
    run = validator.run(request);
  } catch (const BlowUpError& error) {
    point.failure = error.what();
    return;
  }
  const RunSummary& summary = run.summary;
  point.cpu_times.push_back(summary.cpu_time_loop / summary.simulated_time);
  if (point.cpu_times.size() > 1) return;
  point.particles = summary.fluid_particles;
  point.steps = summary.steps;
  point.time_step = summary.time_step_mean;
  point.pair_evaluations = summary.pair_evaluations / summary.simulated_time;
  point.state_memory = summary.state_bytes_per_particle * static_cast<double>(summary.fluid_particles);
  point.compression = summary.compression_max;
  point.energy_gain = summary.energy_initial != 0.0 ? summary.energy_gain_max / summary.energy_initial : 0.0;
  for (const ParetoError& error : chosen.errors) {
    point.errors.push_back(error.evaluate(run, reference ? &*reference : nullptr));
  }
}

std::vector<ParetoPoint> measure_peers(const std::vector<PeerRun>& peers, const ParetoCase& chosen,
                                       const ValidationRun* reference, const Validator& validator) {
  std::vector<ParetoPoint> points;
  for (const PeerRun& peer : peers) {
    if (peer.flow != chosen.name) continue;
    const std::string label = fmt::format("peer_{:03}", points.size());
    points.push_back(measure_peer(peer, chosen, reference, validator.run_folder(label)));
  }
  return points;
}

}  // namespace

double ParetoPoint::cpu_time() const {
  if (cpu_times.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sorted = cpu_times;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

std::vector<CostAndError> ParetoResult::costs(std::size_t error, bool pairs) const {
  std::vector<CostAndError> costs;
  for (const ParetoPoint& point : points) {
    const double off =
        error < point.errors.size() ? point.errors[error] : std::numeric_limits<double>::quiet_NaN();
    costs.push_back({pairs ? point.pair_evaluations : point.cpu_time(), off});
  }
  return costs;
}

ParetoResult study(const ParetoCase& chosen, const std::vector<ParetoSetting>& settings, int repeats,
                   Validator& validator, const std::vector<PeerRun>& peers) {
  const std::vector<double>& spacings = validator.pick(chosen.full_spacings, chosen.quick_spacings);
  ParetoResult result;
  result.chosen = &chosen;
  result.end = validator.pick(chosen.full_end, chosen.quick_end);
  validator.begin_case(chosen.name);
  std::optional<ValidationRun> reference;
  if (!chosen.reference.empty()) {
    result.reference_spacing = 0.5 * spacings.back();
    const auto overrides = overrides_of(chosen.reference, result.reference_spacing, result.end);
    reference = validator.run(request_of(chosen, "reference", overrides, result.end));
    auto other = overrides;
    other.insert(other.end(), {"scheme.name=delta_sph", "scheme.stepping=runge_kutta"});
    const ValidationRun check = validator.run(request_of(chosen, "reference_delta_sph", other, result.end));
    for (const ParetoError& error : chosen.errors) {
      result.reference_spread.push_back(error.evaluate(check, &*reference));
    }
  }
  // Before anything that takes long, as they may lack what an error is measured by.
  const std::vector<ParetoPoint> peer_points =
      measure_peers(peers, chosen, reference ? &*reference : nullptr, validator);
  struct Entry {
    ParetoPoint point;
    RunRequest request;
  };
  std::vector<Entry> entries;
  for (const double spacing : spacings) {
    for (const ParetoSetting& setting : settings) {
      ParetoPoint point;
      point.scheme = setting.scheme;
      point.step = setting.step;
      point.spacing = spacing;
      const std::string label = fmt::format("{:03}", entries.size());
      entries.push_back(
          {std::move(point),
           request_of(chosen, label, overrides_of(setting.overrides, spacing, result.end), result.end)});
    }
  }
  for (int repeat = 0; repeat < repeats; ++repeat) {
    if (repeat > 0) std::reverse(entries.begin(), entries.end());
    for (Entry& entry : entries) {
      if (!entry.point.failure.empty()) continue;
      add_run(entry.point, chosen, entry.request, reference, validator);
    }
  }
  if (repeats % 2 == 0) std::reverse(entries.begin(), entries.end());
  for (Entry& entry : entries) result.points.push_back(std::move(entry.point));
  result.points.insert(result.points.end(), peer_points.begin(), peer_points.end());
  return result;
}

}  // namespace eisph
