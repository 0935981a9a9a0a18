#pragma once

#include "core/scene.hpp"
#include "probe/fluid_field.hpp"

namespace eisph {

struct SensorReading {
  double pressure = 0.0;         ///< Pa, mean over the sensor; dry parts count as zero
  double wetted_fraction = 0.0;  ///< of the sensor's area
};

/// Mean of FluidField::wall_pressure over a sensor, by midpoints at most half a particle spacing apart. The
/// hydrostatic pressure of a lattice of particles that carry it comes out to rounding where the sensor is
/// wetted; the wetted fraction is good to one row of midpoints.
[[nodiscard]] SensorReading read_sensor(const PressureSensor& sensor, const FluidField& field);

/// The sensor's normal as a unit vector; where none is given, that of the nearest face of the domain that is
/// not open, into the domain.
[[nodiscard]] Vec3d sensor_normal(const PressureSensor& sensor, const Scene& scene);

}  // namespace eisph
