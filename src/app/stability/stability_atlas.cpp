#include "app/stability/stability_atlas.hpp"

#include "core/error.hpp"
#include "scheme/simulation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

/// A run that needs this many times the steps planned goes nowhere.
constexpr double kMostSteps = 50.0;

/// The state is looked at this often, from the first part's end on.
constexpr int kParts = 5;

/// 95th percentile of the number density - 1.
double compression_p95(const Snapshot& snapshot) {
  if (snapshot.size() == 0) return 0.0;
  std::vector<float> density = snapshot.number_density;
  const auto place =
      density.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(density.size()));
  std::nth_element(density.begin(), place, density.end());
  return std::max(0.0, *place - 1.0);
}

}  // namespace

const char* stability_name(Stability stability) {
  switch (stability) {
    case Stability::Stable:
      return "stable";
    case Stability::Degraded:
      return "degraded";
    case Stability::BlownUp:
      break;
  }
  return "blown up";
}

StabilityOutcome judge(const RunSummary& summary, double compression, const StabilityLimits& limits) {
  StabilityOutcome outcome;
  outcome.time = summary.simulated_time;
  const auto degrade = [&](const std::string& reason) {
    outcome.stability = Stability::Degraded;
    outcome.reason += (outcome.reason.empty() ? "" : "; ") + reason;
  };
  if (summary.lost_particles > 0) degrade(fmt::format("{} particles lost", summary.lost_particles));
  if (summary.penetrations > 0) degrade(fmt::format("{} penetrations", summary.penetrations));
  if (compression > limits.compression) {
    degrade(fmt::format("compression {:.0f} % (95th percentile)", 100.0 * compression));
  }
  const double scale = std::abs(summary.energy_initial);
  if (summary.energy_gain_max > limits.energy_gain * scale) {
    degrade(scale > 0.0 ? fmt::format("energy gain {:.2g} %", 100.0 * summary.energy_gain_max / scale)
                        : fmt::format("energy gain {:.2g} J", summary.energy_gain_max));
  }
  return outcome;
}

StabilityOutcome try_out(const Scene& scene, int threads, const std::function<bool()>& stop_requested) {
  const auto simulation = Simulation::create(scene, threads);
  const double most_steps = kMostSteps * static_cast<double>(simulation->plan().estimated_steps + 1);
  simulation->initialise();
  double compression = 0.0;
  try {
    for (int part = 1; part <= kParts; ++part) {
      const double until = scene.end_time * part / kParts;
      while (simulation->time() < until) {
        if (stop_requested()) return {};
        simulation->step(until);
        if (static_cast<double>(simulation->steps()) < most_steps) continue;
        return {Stability::BlownUp,
                fmt::format("t = {:.4g} s: the time step has fallen to {:.3g} s", simulation->time(),
                            simulation->time_step()),
                simulation->time()};
      }
      compression = std::max(compression, compression_p95(*simulation->snapshot()));
    }
  } catch (const BlowUpError& error) {
    return {Stability::BlownUp, error.what(), simulation->time()};
  }
  return judge(simulation->summary(), compression);
}

}  // namespace eisph
