#pragma once

#include "core/scene.hpp"
#include "probe/fluid_field.hpp"

#include <optional>

namespace eisph {

struct SensorReading {
  double pressure = 0.0;         ///< Pa, mean over the sensor; dry parts count as zero
  double wetted_fraction = 0.0;  ///< of the sensor's area
};

/// Mean of FluidField::wall_pressure over a sensor, by midpoints at most half a particle spacing apart. The
/// hydrostatic pressure of a lattice of particles that carry it comes out to rounding where the sensor is
/// wetted; the wetted fraction is good to one row of midpoints.
[[nodiscard]] SensorReading read_sensor(const PressureSensor& sensor, const FluidField& field);

/// What a sensor that takes time to follow indicates: y of the first-order law
///
///   T dy/dt + y = p
///
/// with p joined by straight lines between the readings, for which it is solved exactly,
///
///   y1 = p1 - s T + (y0 - p0 + s T) exp(-(t1 - t0) / T),   s = (p1 - p0) / (t1 - t0).
///
/// The integral of y over a blow and its echo is that of p. It starts out settled on the first reading.
class SensorResponse {
 public:
  /// T > 0, s.
  explicit SensorResponse(double time_constant) : time_constant_(time_constant) {}

  /// The indication (Pa) at `time` (s), later than that of the reading before.
  double follow(double time, double pressure);

 private:
  double time_constant_;
  std::optional<double> time_;  ///< of the last reading
  double pressure_ = 0.0;
  double indicated_ = 0.0;
};

/// The sensor's normal as a unit vector; where none is given, that of the nearest face of the domain that is
/// not open, into the domain.
[[nodiscard]] Vec3d sensor_normal(const PressureSensor& sensor, const Scene& scene);

}  // namespace eisph
