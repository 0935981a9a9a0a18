#pragma once

#include "app/view/probe_plots.hpp"
#include "core/snapshot.hpp"
#include "scheme/simulation.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace eisph {

/// How a source of states stands.
struct SourceStatus {
  double time = 0.0;  ///< s, of the simulation; that of the newest state may be earlier
  double time_step = 0.0;
  std::uint64_t steps = 0;
  std::uint64_t carriers = 0;  ///< particles, or cells
  bool playing = false;
  bool at_end = false;
  std::string message;  ///< of a failure; empty: none
  double carrier_steps_per_second = 0.0;
  std::vector<std::pair<std::string, double>> stage_times;  ///< ns per particle and step
};

/// Where a viewer gets its states from. All functions are called on the thread of the viewer and none waits
/// for the simulation.
class StateSource {
 public:
  virtual ~StateSource() = default;

  /// The newest state; null as long as there is none.
  [[nodiscard]] virtual std::shared_ptr<const Snapshot> latest() = 0;
  [[nodiscard]] virtual SourceStatus status() const = 0;
  [[nodiscard]] virtual std::shared_ptr<const std::vector<ProbePlot>> plots() const = 0;

  virtual void play() = 0;
  virtual void pause() = 0;
  /// One time step, or the next saved state.
  virtual void step() = 0;
  virtual void restart() = 0;
  /// Plays up to `time` (s).
  virtual void run_to(double time) = 0;

  /// Of saved states, s; empty for a running simulation.
  [[nodiscard]] virtual const std::vector<double>& saved_times() const;
  /// Shows the saved state of that number.
  virtual void show(std::size_t) {}

  /// Whether the simulation takes parameters while it runs.
  [[nodiscard]] virtual bool takes_parameters() const { return false; }
  virtual void set_parameters(const RunningParameters&) {}

  /// From now on `take` is handed the state at every multiple of `interval` (s), on the thread of the viewer
  /// while it calls latest(); none is left out, so the simulation may have to wait. An empty function ends
  /// it.
  using Recorder = std::function<void(const Snapshot&)>;
  virtual void record(double interval, Recorder take) = 0;
};

}  // namespace eisph
