#include "probe/pressure_sensor.hpp"

#include "core/scene_geometry.hpp"
#include "probe/surface_elements.hpp"

#include <cmath>

namespace eisph {

SensorReading read_sensor(const PressureSensor& sensor, const FluidField& field) {
  constexpr double kSpacing = 0.5;
  const Scene& scene = field.scene();
  const Vec3d normal = sensor_normal(sensor, scene);
  const auto lay_out = sensor.shape == SensorShape::Disc ? disc_elements : square_elements;
  double area = 0.0;
  double wetted = 0.0;
  double force = 0.0;
  for (const SurfaceElement& element :
       lay_out(sensor.position, normal, sensor.size, kSpacing * scene.particle_spacing, scene.dimension)) {
    area += element.area;
    const std::optional<double> pressure = field.wall_pressure(element.point, normal);
    if (!pressure) continue;
    wetted += element.area;
    force += *pressure * element.area;
  }
  return {force / area, wetted / area};
}

double SensorResponse::follow(double time, double pressure) {
  if (time_) {
    const double step = time - *time_;
    const double lag = (pressure - pressure_) / step * time_constant_;
    indicated_ = pressure - lag + (indicated_ - pressure_ + lag) * std::exp(-step / time_constant_);
  } else {
    indicated_ = pressure;
  }
  time_ = time;
  pressure_ = pressure;
  return indicated_;
}

Vec3d sensor_normal(const PressureSensor& sensor, const Scene& scene) {
  if (sensor.normal != Vec3d::Zero()) return sensor.normal.normalized();
  const std::optional<NearestFace> face = nearest_face(scene, sensor.position);
  return face ? face->normal : Vec3d(Vec3d::UnitZ());
}

}  // namespace eisph
