#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "core/table.hpp"
#include "probe/instrument.hpp"
#include "probe/nearest_neighbours.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace eisph {

/// All probes of a scene. Opens one table per probe in the sink when it is made:
///
///   gauge_<name>            time, level, surface
///   probe_<name>            time, pressure, velocity; no values where the point is outside the water
///   pressure_sensor_<name>  time, pressure, wetted_fraction
///   front_<name>            time, front, bulk_front
///   line_<name>             time, distance, position, pressure, velocity: a row per point, values as of a
///                           probe
///   force_<name>            time, force, moment
///   discharge_<name>        time, discharge, volume since the first record
///   leading_edge            time, front and bulk_front along +x
///   ledger                  time, step, particles, mass, volume, energies, momentum, compression,
///                           penetrations, lost particles, figures of NeighbourDistances
///
/// All but the last two are recorded at the multiples of their interval, t = 0 included; without an interval
/// they are recorded with every snapshot. The leading edge and the ledger are recorded with every snapshot
/// that is handed in, whatever it was published for; a schedule of their own can add times. Without probes
/// and that schedule nothing is ever due, so no snapshot is taken for the probes' sake.
///
/// Distances of neighbours, which take as long as all else of the ledger several times over, are found in the
/// rows at multiples of scene.output.ledger_interval, without one in rows at least a hundredth of the scene's
/// time apart, and at its end; the other rows have no values there, nor do those of a model without
/// particles.
class ProbeSet {
 public:
  /// The sink must outlive the probes.
  ProbeSet(const Scene& scene, TableSink& sink, Schedule ledger_times = {});

  /// Hands what is due at snapshot.time to the sink. To be called with every published snapshot in the order
  /// of time, that at t = 0 included; one that is not later than the last changes nothing.
  void record(const Snapshot& snapshot);

  /// The first time after `time` (s) at which a snapshot is needed, infinity if there is none.
  [[nodiscard]] double next_due(double time) const;

  /// Distances of neighbours recorded so far.
  [[nodiscard]] const NeighbourHistory& neighbours() const { return neighbours_; }

 private:
  void record_ledger(const Snapshot& snapshot);
  void add_neighbour_distances(std::vector<double>& row, const Snapshot& snapshot);

  Scene scene_;
  TableSink* sink_;
  std::vector<Instrument> instruments_;
  Schedule ledger_times_;
  std::size_t edge_table_ = 0;
  std::size_t ledger_table_ = 0;
  double last_time_ = -std::numeric_limits<double>::infinity();
  double next_search_ = 0.0;  ///< s
  NeighbourHistory neighbours_;
};

}  // namespace eisph
