#include "probe/pressure_sensor.hpp"

#include "probe/hand_made.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

class PressureSensorTest : public testing::TestWithParam<int> {
 protected:
  Scene scene_ = hand_made_scene(GetParam());
  Snapshot water_ = still_water(scene_, Vec3d(0.4, 0.5, 0.2));

  /// A sensor at (x, height above the floor), half-way across.
  [[nodiscard]] PressureSensor sensor_at(double x, double height, SensorShape shape, double size) const {
    PressureSensor sensor;
    sensor.position = scene_.domain_min + Vec3d(x, GetParam() == 2 ? 0.0 : 0.25, height);
    sensor.shape = shape;
    sensor.size = size;
    return sensor;
  }
  [[nodiscard]] SensorReading read(const PressureSensor& sensor) const {
    return read_sensor(sensor, FluidField(scene_, water_));
  }
};

TEST_P(PressureSensorTest, ReadsThePressureAtTheCentreOfAWettedDiscSquareOrPoint) {
  for (const SensorShape shape : {SensorShape::Disc, SensorShape::Square}) {
    for (const double size : {0.0, 0.015, 0.09}) {
      const SensorReading reading = read(sensor_at(0.0, 0.1, shape, size));
      EXPECT_NEAR(reading.pressure, 981.0, 0.01) << size;
      EXPECT_DOUBLE_EQ(reading.wetted_fraction, 1.0) << size;
    }
  }
}

TEST_P(PressureSensorTest, ReadsTheFloor) {
  const SensorReading reading = read(sensor_at(0.2, 0.0, SensorShape::Disc, 0.05));
  EXPECT_NEAR(reading.pressure, 1962.0, 0.01);
}

TEST_P(PressureSensorTest, CountsTheDryHalfAsZero) {
  for (const SensorShape shape : {SensorShape::Disc, SensorShape::Square}) {
    EXPECT_NEAR(read(sensor_at(0.0, 0.2, shape, 0.08)).wetted_fraction, 0.5, 1e-9);
  }
  // The wetted half of the square is a triangle of pressure: rho g (0.04 m)^2 / 2 over 0.08 m.
  EXPECT_NEAR(read(sensor_at(0.0, 0.2, SensorShape::Square, 0.08)).pressure, 98.1, 0.1);
  const SensorReading dry = read(sensor_at(0.0, 0.35, SensorShape::Square, 0.08));
  EXPECT_EQ(dry.pressure, 0.0);
  EXPECT_EQ(dry.wetted_fraction, 0.0);
}

TEST_P(PressureSensorTest, LooksAwayFromTheNearestFaceUnlessToldOtherwise) {
  PressureSensor sensor = sensor_at(0.0, 0.1, SensorShape::Disc, 0.0);
  EXPECT_EQ(sensor_normal(sensor, scene_), Vec3d(1.0, 0.0, 0.0));
  sensor.position.x() = 1.0;
  EXPECT_EQ(sensor_normal(sensor, scene_), Vec3d(-1.0, 0.0, 0.0));
  sensor.normal = Vec3d(0.0, 0.0, 5.0);
  EXPECT_EQ(sensor_normal(sensor, scene_), Vec3d(0.0, 0.0, 1.0));
}

TEST_P(PressureSensorTest, ReadsTheFaceOfASolid) {
  scene_.obstacles.push_back({"block", box(Vec3d(0.2, -1.0, 0.1), Vec3d(0.3, 1.0, 0.5))});
  water_ = still_water(scene_, Vec3d(0.4, 0.5, 0.2));
  PressureSensor sensor = sensor_at(0.2, 0.1, SensorShape::Square, 0.06);
  sensor.normal = Vec3d(-1.0, 0.0, 0.0);
  EXPECT_NEAR(read(sensor).pressure, 981.0, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Dimension, PressureSensorTest, testing::Values(2, 3));

}  // namespace
}  // namespace eisph
