#include "probe/probe_set.hpp"

#include "probe/gauge.hpp"
#include "probe/leading_edge.hpp"
#include "probe/ledger.hpp"
#include "probe/point_probe.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace eisph {

namespace {

const TableColumn kTime{"time", "s"};

/// A column for each direction of the scene: x, y, z, or x and z in two dimensions.
void add_vector_columns(std::vector<TableColumn>& columns, const std::string& name, const std::string& unit,
                        int dimension) {
  columns.push_back({name + "_x", unit});
  if (dimension == 3) columns.push_back({name + "_y", unit});
  columns.push_back({name + "_z", unit});
}

void add_vector(std::vector<double>& row, const Vec3d& value, int dimension) {
  row.push_back(value.x());
  if (dimension == 3) row.push_back(value.y());
  row.push_back(value.z());
}

std::vector<TableColumn> ledger_columns(int dimension) {
  const bool per_metre = dimension == 2;
  const std::string energy = per_metre ? "J/m" : "J";
  std::vector<TableColumn> columns{kTime,
                                   {"step", "-"},
                                   {"fluid_particles", "-"},
                                   {"mass", per_metre ? "kg/m" : "kg"},
                                   {"kinetic_energy", energy},
                                   {"potential_energy", energy}};
  add_vector_columns(columns, "momentum", per_metre ? "kg/s" : "kg m/s", dimension);
  columns.push_back({"compression_max", "-"});
  columns.push_back({"compression_p95", "-"});
  return columns;
}

std::vector<double> point_row(double time, const PointSample& sample, int dimension) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> row{time, sample.wet ? sample.pressure : kNone};
  add_vector(row, sample.wet ? sample.velocity : Vec3d::Constant(kNone), dimension);
  return row;
}

}  // namespace

ProbeSet::ProbeSet(const Scene& scene, TableSink& sink, Schedule ledger_times)
    : scene_(scene), sink_(&sink), ledger_times_(std::move(ledger_times)) {
  for (const Gauge& gauge : scene.gauges) gauges_.push_back({gauge, Schedule{{}, gauge.interval}});
  for (const PointProbe& probe : scene.probes) points_.push_back({probe, Schedule{{}, probe.interval}});
  open_tables();
}

void ProbeSet::open_tables() {
  for (auto& gauge : gauges_) {
    gauge.table = sink_->open_table({"gauge_" + gauge.probe.name, {kTime, {"level", "m"}}});
  }
  for (auto& point : points_) {
    TableHeader header{"probe_" + point.probe.name, {kTime, {"pressure", "Pa"}}};
    add_vector_columns(header.columns, "velocity", "m/s", scene_.dimension);
    point.table = sink_->open_table(header);
  }
  edge_table_ = sink_->open_table({"leading_edge", {kTime, {"front", "m"}, {"bulk_front", "m"}}});
  ledger_table_ = sink_->open_table({"ledger", ledger_columns(scene_.dimension)});
}

void ProbeSet::record(const Snapshot& snapshot) {
  const double time = snapshot.time;
  if (!(time > last_time_)) return;
  last_time_ = time;
  for (const auto& gauge : gauges_) {
    if (!gauge.is_due(time)) continue;
    sink_->append_row(gauge.table, std::array{time, water_level(gauge.probe, scene_, snapshot)});
  }
  for (const auto& point : points_) {
    if (!point.is_due(time)) continue;
    const PointSample sample = sample_at(point.probe.position, snapshot);
    sink_->append_row(point.table, point_row(time, sample, scene_.dimension));
  }
  const LeadingEdge edge = leading_edge(snapshot);
  sink_->append_row(edge_table_, std::array{time, edge.front, edge.bulk_front});
  record_ledger(snapshot);
}

void ProbeSet::record_ledger(const Snapshot& snapshot) {
  const LedgerEntry entry = take_ledger(snapshot, scene_);
  std::vector<double> row{snapshot.time,
                          static_cast<double>(snapshot.step),
                          static_cast<double>(snapshot.size()),
                          entry.mass,
                          entry.kinetic_energy,
                          entry.potential_energy};
  add_vector(row, entry.momentum, scene_.dimension);
  row.push_back(entry.compression_max);
  row.push_back(entry.compression_p95);
  sink_->append_row(ledger_table_, row);
}

double ProbeSet::next_due(double time) const {
  double next = ledger_times_.next_after(time);
  for (const auto& gauge : gauges_) next = std::min(next, gauge.schedule.next_after(time));
  for (const auto& point : points_) next = std::min(next, point.schedule.next_after(time));
  return next;
}

}  // namespace eisph
