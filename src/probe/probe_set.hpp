#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "core/table.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace eisph {

/// All probes of a scene. Opens one table per probe in the sink when it is made:
///
///   gauge_<name>   time, level
///   probe_<name>   time, pressure, velocity; no values where the point is outside the water
///   leading_edge   time, front and bulk_front along +x
///   ledger         time, step, particles, mass, energies, momentum, compression
///
/// Gauges and point probes are recorded at the multiples of their interval, t = 0 included; without an
/// interval they are recorded with every snapshot. The leading edge and the ledger are recorded with every
/// snapshot that is handed in, whatever it was published for; a schedule of their own can add times. Without
/// gauges, point probes and that schedule nothing is ever due, so no snapshot is taken for the probes' sake.
class ProbeSet {
 public:
  /// The sink must outlive the probes.
  ProbeSet(const Scene& scene, TableSink& sink, Schedule ledger_times = {});

  /// Hands what is due at snapshot.time to the sink. To be called with every published snapshot in the order
  /// of time, that at t = 0 included; one that is not later than the last changes nothing.
  void record(const Snapshot& snapshot);

  /// The first time after `time` (s) at which a snapshot is needed, infinity if there is none.
  [[nodiscard]] double next_due(double time) const;

 private:
  template <typename Probe>
  struct Scheduled {
    Probe probe;
    Schedule schedule;
    std::size_t table = 0;

    [[nodiscard]] bool is_due(double time) const { return schedule.empty() || schedule.is_due(time); }
  };

  void open_tables();
  void record_ledger(const Snapshot& snapshot);

  Scene scene_;
  TableSink* sink_;
  std::vector<Scheduled<Gauge>> gauges_;
  std::vector<Scheduled<PointProbe>> points_;
  Schedule ledger_times_;
  std::size_t edge_table_ = 0;
  std::size_t ledger_table_ = 0;
  double last_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace eisph
