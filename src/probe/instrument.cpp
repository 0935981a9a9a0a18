#include "probe/instrument.hpp"

#include "probe/column_probes.hpp"
#include "probe/discharge.hpp"
#include "probe/force.hpp"
#include "probe/front.hpp"
#include "probe/gauge.hpp"
#include "probe/line_probe.hpp"
#include "probe/point_probe.hpp"
#include "probe/pressure_sensor.hpp"

#include <array>
#include <limits>
#include <utility>

namespace eisph {

namespace {

void add_sample(std::vector<double>& row, const PointSample& sample, int dimension) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  row.push_back(sample.wet ? sample.pressure : kNone);
  add_vector(row, sample.wet ? sample.velocity : Vec3d::Constant(kNone), dimension);
}

// One function per kind of probe: opens its table and returns what appends to it.

using Recorder = std::function<void(Observation&)>;

Recorder recorder(const Gauge& gauge, const Scene&, TableSink& sink) {
  const std::size_t table =
      sink.open_table({"gauge_" + gauge.name, {time_column(), {"level", "m"}, {"surface", "m"}}});
  return [=, &sink](Observation& seen) {
    sink.append_row(table, std::array{seen.snapshot().time, water_level(gauge, seen.scene(), seen.snapshot()),
                                      surface_level(gauge, seen.field())});
  };
}

Recorder recorder(const PointProbe& probe, const Scene& scene, TableSink& sink) {
  TableHeader header{"probe_" + probe.name, {time_column(), {"pressure", "Pa"}}};
  add_vector_columns(header.columns, "velocity", "m/s", scene.dimension);
  const std::size_t table = sink.open_table(header);
  return [=, &sink](Observation& seen) {
    std::vector<double> row{seen.snapshot().time};
    const auto& columns = seen.snapshot().columns;
    add_sample(row,
               columns ? sample_column(probe.position, *columns, seen.scene())
                       : sample_at(probe.position, seen.snapshot()),
               seen.scene().dimension);
    sink.append_row(table, row);
  };
}

Recorder recorder(const PressureSensor& sensor, const Scene&, TableSink& sink) {
  TableHeader header{"pressure_sensor_" + sensor.name,
                     {time_column(), {"pressure", "Pa"}, {"wetted_fraction", "-"}}};
  std::optional<SensorResponse> response;
  if (sensor.response_time > 0.0) {
    response.emplace(sensor.response_time);
    header.columns.push_back({"indicated", "Pa"});
  }
  const std::size_t table = sink.open_table(header);
  return [=, &sink](Observation& seen) mutable {
    const double time = seen.snapshot().time;
    const SensorReading reading = read_sensor(sensor, seen.field());
    std::vector<double> row{time, reading.pressure, reading.wetted_fraction};
    if (response) row.push_back(response->follow(time, reading.pressure));
    sink.append_row(table, row);
  };
}

Recorder recorder(const FrontProbe& probe, const Scene&, TableSink& sink) {
  const std::size_t table =
      sink.open_table({"front_" + probe.name, {time_column(), {"front", "m"}, {"bulk_front", "m"}}});
  return [=, &sink](Observation& seen) {
    const auto& columns = seen.snapshot().columns;
    const LeadingEdge edge =
        columns ? column_front(probe, *columns, seen.scene()) : front_position(probe, seen.snapshot());
    sink.append_row(table, std::array{seen.snapshot().time, edge.front, edge.bulk_front});
  };
}

Recorder recorder(const LineProbe& line, const Scene& scene, TableSink& sink) {
  TableHeader header{"line_" + line.name, {time_column(), {"distance", "m"}}};
  header.columns.push_back({"x", "m"});
  if (scene.dimension == 3) header.columns.push_back({"y", "m"});
  header.columns.push_back({"z", "m"});
  header.columns.push_back({"pressure", "Pa"});
  add_vector_columns(header.columns, "velocity", "m/s", scene.dimension);
  const std::size_t table = sink.open_table(header);
  return [=, &sink](Observation& seen) {
    for (const LineSample& point : sample_line(line, seen.field())) {
      std::vector<double> row{seen.snapshot().time, point.distance};
      add_vector(row, point.position, seen.scene().dimension);
      add_sample(row, point.sample, seen.scene().dimension);
      sink.append_row(table, row);
    }
  };
}

Recorder recorder(const ForceProbe& probe, const Scene& scene, TableSink& sink) {
  const bool plane = scene.dimension == 2;
  TableHeader header{"force_" + probe.name, {time_column()}};
  add_vector_columns(header.columns, "force", plane ? "N/m" : "N", scene.dimension);
  if (plane) {
    header.columns.push_back({"moment_y", "N"});
  } else {
    add_vector_columns(header.columns, "moment", "N m", scene.dimension);
  }
  const std::size_t table = sink.open_table(header);
  return [=, &sink](Observation& seen) {
    const WaterForce result = water_force(probe, seen.field());
    std::vector<double> row{seen.snapshot().time};
    add_vector(row, result.force, seen.scene().dimension);
    if (plane) {
      row.push_back(result.moment.y());
    } else {
      add_vector(row, result.moment, seen.scene().dimension);
    }
    sink.append_row(table, row);
  };
}

/// Adds up the volume from its first record on, by the trapezium rule.
class DischargeRecorder {
 public:
  DischargeRecorder(DischargeProbe probe, const Scene& scene, TableSink& sink)
      : probe_(std::move(probe)), sink_(&sink) {
    const bool plane = scene.dimension == 2;
    table_ = sink.open_table(
        {"discharge_" + probe_.name,
         {time_column(), {"discharge", plane ? "m^2/s" : "m^3/s"}, {"volume", plane ? "m^2" : "m^3"}}});
  }

  void operator()(Observation& seen) {
    const double time = seen.snapshot().time;
    const double now = discharge(probe_, seen.scene(), seen.snapshot());
    if (last_time_) volume_ += 0.5 * (last_ + now) * (time - *last_time_);
    last_ = now;
    last_time_ = time;
    sink_->append_row(table_, std::array{time, now, volume_});
  }

 private:
  DischargeProbe probe_;
  TableSink* sink_;
  std::size_t table_ = 0;
  double last_ = 0.0;
  std::optional<double> last_time_;
  double volume_ = 0.0;
};

Recorder recorder(const DischargeProbe& probe, const Scene& scene, TableSink& sink) {
  return DischargeRecorder(probe, scene, sink);
}

}  // namespace

std::vector<Instrument> make_instruments(const Scene& scene, TableSink& sink) {
  std::vector<Instrument> instruments;
  const auto add = [&](const auto& probes) {
    for (const auto& probe : probes)
      instruments.push_back({Schedule{{}, probe.interval}, recorder(probe, scene, sink)});
  };
  add(scene.gauges);
  add(scene.probes);
  add(scene.pressure_sensors);
  add(scene.fronts);
  add(scene.lines);
  add(scene.forces);
  add(scene.discharges);
  return instruments;
}

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

}  // namespace eisph
