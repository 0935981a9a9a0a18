#include "probe/probe_set.hpp"

#include "probe/column_probes.hpp"
#include "probe/leading_edge.hpp"
#include "probe/ledger.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace eisph {

namespace {

constexpr double kTimeTolerance = 1e-9;  ///< s
/// Least time between searches for the nearest neighbours, as part of the run's.
constexpr double kSearchInterval = 0.01;

std::vector<TableColumn> ledger_columns(int dimension) {
  const bool per_metre = dimension == 2;
  const std::string energy = per_metre ? "J/m" : "J";
  std::vector<TableColumn> columns{time_column(),
                                   {"step", "-"},
                                   {"fluid_particles", "-"},
                                   {"mass", per_metre ? "kg/m" : "kg"},
                                   {"volume", per_metre ? "m^2" : "m^3"},
                                   {"kinetic_energy", energy},
                                   {"potential_energy", energy}};
  add_vector_columns(columns, "momentum", per_metre ? "kg/s" : "kg m/s", dimension);
  for (const char* name :
       {"compression_max", "compression_p95", "penetrations", "lost_particles", "paired_fraction",
        "nearest_distance_p5", "isolated_particles", "isolated_fraction"}) {
    columns.push_back({name, "-"});
  }
  return columns;
}

}  // namespace

ProbeSet::ProbeSet(const Scene& scene, TableSink& sink, Schedule ledger_times)
    : scene_(scene),
      sink_(&sink),
      instruments_(make_instruments(scene, sink)),
      ledger_times_(std::move(ledger_times)),
      edge_table_(sink.open_table({"leading_edge", {time_column(), {"front", "m"}, {"bulk_front", "m"}}})),
      ledger_table_(sink.open_table({"ledger", ledger_columns(scene.dimension)})) {}

void ProbeSet::record(const Snapshot& snapshot) {
  const double time = snapshot.time;
  if (!(time > last_time_)) return;
  last_time_ = time;
  Observation observation(scene_, snapshot);
  for (const Instrument& instrument : instruments_) {
    if (instrument.is_due(time)) instrument.record(observation);
  }
  const LeadingEdge edge = leading_edge(snapshot);
  sink_->append_row(edge_table_, std::array{time, edge.front, edge.bulk_front});
  record_ledger(snapshot);
}

void ProbeSet::record_ledger(const Snapshot& snapshot) {
  const LedgerEntry entry = take_ledger(snapshot, scene_);
  std::vector<double> row{
      snapshot.time,
      static_cast<double>(snapshot.step),
      static_cast<double>(snapshot.columns ? wet_columns(*snapshot.columns) : snapshot.size()),
      entry.mass,
      entry.volume,
      entry.kinetic_energy,
      entry.potential_energy};
  add_vector(row, entry.momentum, scene_.dimension);
  row.insert(row.end(),
             {entry.compression_max, entry.compression_p95, entry.penetrations, entry.lost_particles});
  add_neighbour_distances(row, snapshot);
  sink_->append_row(ledger_table_, row);
}

void ProbeSet::add_neighbour_distances(std::vector<double>& row, const Snapshot& snapshot) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const bool at_end = std::abs(snapshot.time - scene_.end_time) <= kTimeTolerance;
  if (snapshot.columns || (snapshot.time < next_search_ - kTimeTolerance && !at_end)) {
    row.insert(row.end(), 4, kNone);
    return;
  }
  const double given = scene_.output.ledger_interval;
  const double interval = given > 0.0 ? given : kSearchInterval * scene_.end_time;
  if (interval > 0.0) next_search_ = Schedule{{}, interval}.next_after(snapshot.time);
  const NeighbourDistances distances = neighbour_distances(snapshot);
  row.insert(row.end(), {distances.paired_fraction, distances.nearest_distance_p5,
                         static_cast<double>(distances.isolated_particles), distances.isolated_fraction});
  neighbours_.add(distances);
}

double ProbeSet::next_due(double time) const {
  double next = ledger_times_.next_after(time);
  for (const Instrument& instrument : instruments_)
    next = std::min(next, instrument.schedule.next_after(time));
  return next;
}

}  // namespace eisph
