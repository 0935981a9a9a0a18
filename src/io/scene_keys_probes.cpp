// Keys of the probes other than gauges and points.

#include "io/scene_keys.hpp"

#include <utility>

namespace eisph {

namespace {

template <class Probe>
void add_name_key(KeyTable<Probe>& keys) {
  keys.identifier("name", &Probe::name, "Name of the record, unlike those of all other probes.").required();
}

template <class Probe>
void add_interval_key(KeyTable<Probe>& keys) {
  keys.number("interval", "s", &Probe::interval, above(0.0), "Time between records.").fallback("0.01");
}

/// A restriction to part of one axis, given as [lower, upper].
template <class Probe>
Key<Probe>& add_range_key(KeyTable<Probe>& keys, std::size_t axis) {
  const std::string name = std::string(1, "xyz"[axis]) + "_range";
  Key<Probe>& key = keys.add(
      {.name = name,
       .type = "a list of two rising numbers",
       .unit = "m",
       .meaning = "Part of the domain that counts."},
      [=](const toml::node& node, int, Probe& probe) {
        std::vector<double> ends;
        if (!read_ascending(node, any_number(), ends) || ends.size() != 2) return false;
        probe.band.range[axis] = {ends[0], ends[1]};
        return true;
      },
      [=](const Probe& probe, int) {
        const auto& range = probe.band.range[axis];
        return range ? write_numbers({(*range)[0], (*range)[1]}) : std::string();
      });
  return key.fallback("the whole domain");
}

}  // namespace

KeyTable<PressureSensor> pressure_sensor_keys() {
  KeyTable<PressureSensor> keys;
  add_name_key(keys);
  keys.vector("position", "m", &PressureSensor::position, "Centre of the sensor, on a wall.").required();
  keys.add(
          {.name = "normal",
           .type = "a list [x, y, z] of numbers that are not all zero, in 2D [x, z]",
           .meaning = "Direction from the wall into the water."},
          [](const toml::node& node, int dimension, PressureSensor& sensor) {
            return read_vector(node, dimension, sensor.normal) && sensor.normal.norm() > 0.0;
          },
          [](const PressureSensor& sensor, int dimension) { return write_vector(sensor.normal, dimension); })
      .fallback("that of the nearest face of the domain");
  keys.choice<SensorShape>(
      "shape", &PressureSensor::shape, {{"disc", SensorShape::Disc}, {"square", SensorShape::Square}},
      "Form of the sensor; in 2D both are a line. One pair of a square's sides is level.");
  keys.number("size", "m", &PressureSensor::size, at_least(0.0), "Diameter or side; 0: a point.");
  keys.number(
      "response_time", "s", &PressureSensor::response_time, at_least(0.0),
      "Time constant T of the sensor: adds what it indicates, y of T dy/dt + y = pressure; 0: it follows "
      "at once. Not below interval.");
  add_interval_key(keys);
  return keys;
}

KeyTable<FrontProbe> front_keys() {
  KeyTable<FrontProbe> keys;
  add_name_key(keys);
  const auto is_along = [](int axis) {
    return [=](const FrontProbe& front, int dimension) { return front.axis == axis && dimension == 3; };
  };
  keys.add(
          {.name = "direction",
           .type = R"(one of "+x", "-x", "+y", "-y", in 2D "+x", "-x")",
           .meaning = "Direction in which the water spreads."},
          [](const toml::node& node, int dimension, FrontProbe& front) {
            std::string word;
            if (!read_text(node, word) || word.size() != 2) return false;
            if (word[0] != '+' && word[0] != '-') return false;
            if (word[1] != 'x' && (word[1] != 'y' || dimension == 2)) return false;
            front.upwards = word[0] == '+';
            front.axis = word[1] == 'x' ? 0 : 1;
            return true;
          },
          [](const FrontProbe& front, int) {
            return write_text(std::string(front.upwards ? "+" : "-") + "xyz"[front.axis]);
          })
      .required();
  add_range_key(keys, 0).when("with direction = \"+y\" or \"-y\"", is_along(1));
  add_range_key(keys, 1).when("with direction = \"+x\" or \"-x\" and dimension = 3", is_along(0));
  add_range_key(keys, 2);
  add_interval_key(keys);
  return keys;
}

KeyTable<LineProbe> line_keys() {
  KeyTable<LineProbe> keys;
  add_name_key(keys);
  keys.vector("start", "m", &LineProbe::start, "First point.").required();
  keys.vector("end", "m", &LineProbe::end, "Last point.").required();
  keys.integer("points", "", &LineProbe::points, between(2.0, 100000.0),
               "Number of equidistant points, both ends included.");
  add_interval_key(keys);
  return keys;
}

KeyTable<ForceProbe> force_keys() {
  KeyTable<ForceProbe> keys;
  add_name_key(keys);
  keys.identifier("obstacle", &ForceProbe::obstacle, "Name of an [[obstacle]], [[dam]] or [[gate]].")
      .required();
  keys.add(
          {.name = "moment_point",
           .type = "a list [x, y, z] of numbers, in 2D [x, z]",
           .unit = "m",
           .meaning = "Point about which the moment is taken."},
          [](const toml::node& node, int dimension, ForceProbe& force) {
            return read_vector(node, dimension, force.moment_point.emplace());
          },
          [](const ForceProbe& force, int dimension) {
            return force.moment_point ? write_vector(*force.moment_point, dimension) : std::string();
          })
      .fallback("the centre of the solid's base");
  add_interval_key(keys);
  return keys;
}

KeyTable<DischargeProbe> discharge_keys() {
  KeyTable<DischargeProbe> keys;
  add_name_key(keys);
  keys.choice<int>("axis", &DischargeProbe::axis, {{"x", 0}, {"y", 1}, {"z", 2}},
                   "Axis that the plane is perpendicular to; y in 3D only.")
      .required();
  keys.number("position", "m", &DischargeProbe::position, any_number(),
              "Coordinate of the plane on its axis.")
      .required();
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const std::string letter(1, "xyz"[axis]);
    add_range_key(keys, axis)
        .when("with an axis other than \"" + letter + "\"" + (axis == 1 ? " and dimension = 3" : ""),
              [=](const DischargeProbe& plane, int dimension) {
                return plane.axis != static_cast<int>(axis) && (axis != 1 || dimension == 3);
              });
  }
  add_interval_key(keys);
  return keys;
}

}  // namespace eisph
