#include "probe/probe_set.hpp"

#include "probe/hand_made.hpp"
#include "probe/pressure_sensor.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsNan;
using testing::SizeIs;

/// Keeps the rows in memory.
class MemoryTables : public TableSink {
 public:
  std::size_t open_table(const TableHeader& header) override {
    headers_.push_back(header);
    rows_.emplace_back();
    return headers_.size() - 1;
  }
  void append_row(std::size_t table, std::span<const double> row) override {
    EXPECT_EQ(row.size(), headers_.at(table).columns.size());
    rows_.at(table).emplace_back(row.begin(), row.end());
  }

  [[nodiscard]] const std::vector<std::vector<double>>& rows(const std::string& name) const {
    return rows_.at(index(name));
  }
  [[nodiscard]] std::vector<std::string> columns(const std::string& name) const {
    std::vector<std::string> result;
    for (const TableColumn& column : headers_.at(index(name)).columns) {
      result.push_back(column.name + " [" + column.unit + "]");
    }
    return result;
  }

 private:
  [[nodiscard]] std::size_t index(const std::string& name) const {
    for (std::size_t k = 0; k < headers_.size(); ++k) {
      if (headers_[k].name == name) return k;
    }
    throw std::out_of_range(name);
  }

  std::vector<TableHeader> headers_;
  std::vector<std::vector<std::vector<double>>> rows_;
};

Scene scene_with_probes(int dimension) {
  Scene scene = hand_made_scene(dimension);
  Gauge gauge;
  gauge.name = "wall";
  gauge.x = 0.05;
  gauge.y = 0.05;
  gauge.interval = 0.1;
  scene.gauges.push_back(gauge);
  PointProbe probe;
  probe.name = "bed";
  probe.position = Vec3d(0.05, 0.0, 0.15);
  probe.interval = 0.25;
  scene.probes.push_back(probe);
  return scene;
}

TEST(ProbeSet, NamesTablesAndColumnsWithUnits) {
  MemoryTables tables;
  const ProbeSet probes(scene_with_probes(3), tables);
  EXPECT_THAT(tables.columns("gauge_wall"), ElementsAre("time [s]", "level [m]", "surface [m]"));
  EXPECT_THAT(tables.columns("probe_bed"), ElementsAre("time [s]", "pressure [Pa]", "velocity_x [m/s]",
                                                       "velocity_y [m/s]", "velocity_z [m/s]"));
  EXPECT_THAT(tables.columns("leading_edge"), ElementsAre("time [s]", "front [m]", "bulk_front [m]"));
  EXPECT_THAT(
      tables.columns("ledger"),
      ElementsAre("time [s]", "step [-]", "fluid_particles [-]", "mass [kg]", "volume [m^3]",
                  "kinetic_energy [J]", "potential_energy [J]", "momentum_x [kg m/s]", "momentum_y [kg m/s]",
                  "momentum_z [kg m/s]", "compression_max [-]", "compression_p95 [-]", "penetrations [-]",
                  "lost_particles [-]", "paired_fraction [-]", "nearest_distance_p5 [-]",
                  "isolated_particles [-]", "isolated_fraction [-]"));
}

TEST(ProbeSet, HasNoTransverseColumnsAndUnitsPerMetreInTwoDimensions) {
  MemoryTables tables;
  const ProbeSet probes(scene_with_probes(2), tables);
  EXPECT_THAT(tables.columns("probe_bed"),
              ElementsAre("time [s]", "pressure [Pa]", "velocity_x [m/s]", "velocity_z [m/s]"));
  EXPECT_THAT(tables.columns("ledger"),
              ElementsAre("time [s]", "step [-]", "fluid_particles [-]", "mass [kg/m]", "volume [m^2]",
                          "kinetic_energy [J/m]", "potential_energy [J/m]", "momentum_x [kg/s]",
                          "momentum_z [kg/s]", "compression_max [-]", "compression_p95 [-]",
                          "penetrations [-]", "lost_particles [-]", "paired_fraction [-]",
                          "nearest_distance_p5 [-]", "isolated_particles [-]", "isolated_fraction [-]"));
}

TEST(ProbeSet, RecordsEachProbeAtItsOwnTimesAndTheLedgerAlways) {
  const Scene scene = scene_with_probes(3);
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  const std::vector<Vec3f> water = lattice(scene, Vec3d(0.2, 0.2, 0.2));
  for (const double time : {0.0, 0.1, 0.13, 0.2, 0.25}) probes.record(hand_made_snapshot(scene, water, time));
  EXPECT_THAT(tables.rows("gauge_wall"),
              ElementsAre(ElementsAre(0.0, DoubleNear(0.19, 1e-7), DoubleNear(0.2, 2e-6)),
                          ElementsAre(0.1, DoubleNear(0.19, 1e-7), DoubleNear(0.2, 2e-6)),
                          ElementsAre(0.2, DoubleNear(0.19, 1e-7), DoubleNear(0.2, 2e-6))));
  EXPECT_THAT(tables.rows("probe_bed"), SizeIs(2));
  EXPECT_THAT(tables.rows("leading_edge"), SizeIs(5));
  EXPECT_THAT(tables.rows("ledger"), SizeIs(5));
}

TEST(ProbeSet, VisitsEveryDueTimeWhenDrivenByNextDue) {
  Scene scene = scene_with_probes(2);
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  double time = 0.0;
  while (time <= 1.0 + 1e-9) {
    probes.record(hand_made_snapshot(scene, {}, time));
    time = probes.next_due(time);
  }
  EXPECT_THAT(tables.rows("gauge_wall"), SizeIs(11));
  EXPECT_THAT(tables.rows("probe_bed"), SizeIs(5));
  EXPECT_THAT(tables.rows("ledger"), SizeIs(13));  // 0.25 and 0.75 are not times of the gauge
}

TEST(ProbeSet, LeavesValuesOutWhereThePointIsDry) {
  const Scene scene = scene_with_probes(2);
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  probes.record(hand_made_snapshot(scene, {}, 0.0));
  Snapshot wet = hand_made_snapshot(scene, lattice(scene, Vec3d(0.2, 0.0, 0.2)), 0.25);
  wet.pressure.assign(wet.size(), 500.0F);
  probes.record(wet);
  EXPECT_THAT(tables.rows("probe_bed"), ElementsAre(ElementsAre(0.0, IsNan(), IsNan(), IsNan()),
                                                    ElementsAre(0.25, DoubleNear(500.0, 1e-9), 0.0, 0.0)));
  EXPECT_THAT(tables.rows("leading_edge").front(), ElementsAre(0.0, IsNan(), IsNan()));
}

TEST(ProbeSet, RecordsAProbeWithoutIntervalWithEverySnapshot) {
  Scene scene = scene_with_probes(2);
  scene.gauges.front().interval = 0.0;
  scene.probes.clear();
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  EXPECT_TRUE(std::isinf(probes.next_due(0.0)));
  for (const double time : {0.0, 0.017}) probes.record(hand_made_snapshot(scene, {}, time));
  EXPECT_THAT(tables.rows("gauge_wall"), SizeIs(2));
}

TEST(ProbeSet, RecordsATimeOnceOnly) {
  const Scene scene = scene_with_probes(2);
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  for (const double time : {0.1, 0.1, 0.05}) probes.record(hand_made_snapshot(scene, {}, time));
  EXPECT_THAT(tables.rows("gauge_wall"), SizeIs(1));
  EXPECT_THAT(tables.rows("ledger"), SizeIs(1));
}

TEST(ProbeSet, AsksForNoSnapshotWithoutProbes) {
  const Scene scene = hand_made_scene(3);
  MemoryTables tables;
  const ProbeSet probes(scene, tables);
  EXPECT_TRUE(std::isinf(probes.next_due(0.0)));
}

TEST(ProbeSet, AddsTheTimesOfTheLedger) {
  const Scene scene = scene_with_probes(3);
  MemoryTables tables;
  const ProbeSet probes(scene, tables, Schedule{{0.03}, 0.08});
  EXPECT_DOUBLE_EQ(probes.next_due(0.0), 0.03);
  EXPECT_DOUBLE_EQ(probes.next_due(0.03), 0.08);
  EXPECT_DOUBLE_EQ(probes.next_due(0.08), 0.1);
}

TEST(ProbeSet, WritesTheLedgerOfTheSnapshot) {
  const Scene scene = hand_made_scene(2);
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  Snapshot snapshot = hand_made_snapshot(scene, {{0.5F, 0.0F, 0.1F}}, 0.5);
  snapshot.particle_mass = 2.0;
  snapshot.step = 40;
  snapshot.velocity[0] = Vec3f(3.0F, 0.0F, -1.0F);
  snapshot.number_density[0] = 1.25F;
  snapshot.penetrations = 3;
  snapshot.lost_particles = 1;
  probes.record(snapshot);
  EXPECT_THAT(tables.rows("ledger"), ElementsAre(ElementsAre(0.5, 40.0, 1.0, 2.0, DoubleNear(0.0016, 1e-12),
                                                             10.0, DoubleNear(0.0, 1e-6), 6.0, -2.0, 0.25,
                                                             0.25, 3.0, 1.0, 0.0, 2.0, 1.0, 1.0)));
}

/// Times of the rows of the ledger that tell the distances of neighbours.
std::vector<double> search_times(const Scene& scene, const std::vector<double>& times) {
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  for (const double time : times) probes.record(hand_made_snapshot(scene, {{0.5F, 0.0F, 0.1F}}, time));
  std::vector<double> result;
  for (const std::vector<double>& row : tables.rows("ledger")) {
    if (!std::isnan(row.back())) result.push_back(row.front());
  }
  return result;
}

TEST(ProbeSet, SearchesForNeighboursAtMostAHundredTimesWithoutAnIntervalOfTheLedger) {
  Scene scene = hand_made_scene(2);
  scene.end_time = 10.0;
  EXPECT_THAT(search_times(scene, {0.0, 0.03, 0.09, 0.12, 0.15, 0.2, 0.55, 0.6, 10.0}),
              ElementsAre(0.0, 0.12, 0.2, 0.55, 0.6, 10.0));
  EXPECT_THAT(search_times(scene, {9.92, 9.97, 10.0}), ElementsAre(9.92, 10.0)) << "and at the end";
  scene.output.ledger_interval = 0.05;
  EXPECT_THAT(search_times(scene, {0.0, 0.03, 0.05, 0.07, 0.1}), ElementsAre(0.0, 0.05, 0.1));
}

TEST(ProbeSet, KeepsTheWorstDistancesAndTheLast) {
  const Scene scene = hand_made_scene(2);
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  probes.record(hand_made_snapshot(scene, {{0.5F, 0.0F, 0.2F}, {0.505F, 0.0F, 0.2F}}, 0.0));
  probes.record(hand_made_snapshot(scene, {{0.5F, 0.0F, 0.2F}, {0.52F, 0.0F, 0.2F}}, 1.0));
  EXPECT_EQ(probes.neighbours().worst.paired_fraction, 1.0);
  EXPECT_EQ(probes.neighbours().last.paired_fraction, 0.0);
  EXPECT_NEAR(probes.neighbours().worst.nearest_distance_p5, 0.25, 1e-5);
  EXPECT_NEAR(probes.neighbours().last.nearest_distance_p5, 1.0, 1e-5);
}

/// One probe of each further kind, all called "a", every 0.1 s, on a block in the middle of the tank.
Scene scene_with_further_probes(int dimension) {
  Scene scene = hand_made_scene(dimension);
  scene.obstacles.push_back({"block", box(Vec3d(0.5, 0.0, 0.1), Vec3d(0.6, 0.5, 0.4))});
  const auto start = [](auto& probes) -> auto& {
    auto& probe = probes.emplace_back();
    probe.name = "a";
    probe.interval = 0.1;
    return probe;
  };
  start(scene.pressure_sensors).position = Vec3d(0.0, 0.1, 0.15);
  start(scene.fronts).upwards = false;
  LineProbe& line = start(scene.lines);
  line.start = Vec3d(0.2, 0.1, 0.15);
  line.end = Vec3d(0.2, 0.1, 0.55);
  line.points = 3;
  start(scene.forces).obstacle = "block";
  start(scene.discharges).position = 0.25;
  return scene;
}

TEST(ProbeSet, NamesTablesAndColumnsOfTheFurtherProbes) {
  MemoryTables tables;
  const ProbeSet probes(scene_with_further_probes(3), tables);
  EXPECT_THAT(tables.columns("pressure_sensor_a"),
              ElementsAre("time [s]", "pressure [Pa]", "wetted_fraction [-]"));
  EXPECT_THAT(tables.columns("front_a"), ElementsAre("time [s]", "front [m]", "bulk_front [m]"));
  EXPECT_THAT(tables.columns("line_a"),
              ElementsAre("time [s]", "distance [m]", "x [m]", "y [m]", "z [m]", "pressure [Pa]",
                          "velocity_x [m/s]", "velocity_y [m/s]", "velocity_z [m/s]"));
  EXPECT_THAT(tables.columns("force_a"), ElementsAre("time [s]", "force_x [N]", "force_y [N]", "force_z [N]",
                                                     "moment_x [N m]", "moment_y [N m]", "moment_z [N m]"));
  EXPECT_THAT(tables.columns("discharge_a"), ElementsAre("time [s]", "discharge [m^3/s]", "volume [m^3]"));
  MemoryTables plane;
  const ProbeSet in_plane(scene_with_further_probes(2), plane);
  EXPECT_THAT(plane.columns("line_a"), ElementsAre("time [s]", "distance [m]", "x [m]", "z [m]",
                                                   "pressure [Pa]", "velocity_x [m/s]", "velocity_z [m/s]"));
  EXPECT_THAT(plane.columns("force_a"),
              ElementsAre("time [s]", "force_x [N/m]", "force_z [N/m]", "moment_y [N]"));
  EXPECT_THAT(plane.columns("discharge_a"), ElementsAre("time [s]", "discharge [m^2/s]", "volume [m^2]"));
}

TEST(ProbeSet, TellsWhatASensorOfFiniteResponseIndicates) {
  Scene scene = scene_with_further_probes(3);
  scene.pressure_sensors.front().response_time = 0.2;
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  EXPECT_THAT(tables.columns("pressure_sensor_a"),
              ElementsAre("time [s]", "pressure [Pa]", "wetted_fraction [-]", "indicated [Pa]"));
  Snapshot water = still_water(scene, Vec3d(0.5, 0.5, 0.2));
  SensorResponse response(0.2);
  for (const double time : {0.0, 0.1, 0.2}) {
    water.time = time;
    for (float& pressure : water.pressure) pressure += static_cast<float>(1000.0 * time);
    probes.record(water);
  }
  const auto& rows = tables.rows("pressure_sensor_a");
  ASSERT_THAT(rows, SizeIs(3));
  EXPECT_GT(rows[2][1], rows[0][1] + 250.0);
  for (const auto& row : rows) EXPECT_DOUBLE_EQ(row[3], response.follow(row[0], row[1])) << row[0];
}

TEST(ProbeSet, WritesTheFurtherProbesWhenTheyAreDue) {
  const Scene scene = scene_with_further_probes(3);
  MemoryTables tables;
  ProbeSet probes(scene, tables);
  EXPECT_DOUBLE_EQ(probes.next_due(0.0), 0.1);
  Snapshot water = still_water(scene, Vec3d(0.5, 0.5, 0.2));
  for (const double time : {0.0, 0.05, 0.1, 0.2}) {
    water.time = time;
    water.velocity.assign(water.size(), Vec3f(static_cast<float>(10.0 * time), 0.0F, 0.0F));
    probes.record(water);
  }
  EXPECT_THAT(tables.rows("pressure_sensor_a"), SizeIs(3));
  EXPECT_THAT(tables.rows("pressure_sensor_a").back(), ElementsAre(0.2, DoubleNear(1471.5, 0.01), 1.0));
  EXPECT_THAT(tables.rows("front_a").back(),
              ElementsAre(0.2, DoubleNear(0.01, 1e-7), DoubleNear(0.01, 1e-7)));
  ASSERT_THAT(tables.rows("line_a"), SizeIs(9));
  EXPECT_THAT(tables.rows("line_a")[7],
              ElementsAre(0.2, DoubleNear(0.2, 1e-12), 0.2, 0.1, DoubleNear(0.35, 1e-12), IsNan(), IsNan(),
                          IsNan(), IsNan()));
  EXPECT_NEAR(tables.rows("line_a")[6][6], 2.0, 1e-6);
  EXPECT_NEAR(tables.rows("force_a").back()[1], 98.1, 0.1);
  // 0, 0.1 and 0.2 m^3/s at intervals of 0.1 s.
  ASSERT_THAT(tables.rows("discharge_a"), SizeIs(3));
  EXPECT_THAT(tables.rows("discharge_a").back(),
              ElementsAre(0.2, DoubleNear(0.2, 1e-6), DoubleNear(0.02, 1e-7)));
}

TEST(Observation, SortsTheWaterOnlyWhenAskedForTheField) {
  const Scene scene = hand_made_scene(2);
  const Snapshot water = hand_made_snapshot(scene, {});
  Observation observation(scene, water);
  EXPECT_FALSE(observation.has_field());
  const FluidField* field = &observation.field();
  EXPECT_TRUE(observation.has_field());
  EXPECT_EQ(&observation.field(), field);
}

}  // namespace
}  // namespace eisph
