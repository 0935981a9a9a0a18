#include "probe/pressure_sensor.hpp"

#include "probe/hand_made.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

/// Indications at the multiples of `step` up to `end` for p(t), with their times.
template <class Pressure>
std::vector<std::pair<double, double>> indications(double time_constant, double step, double end,
                                                   const Pressure& pressure) {
  SensorResponse response(time_constant);
  std::vector<std::pair<double, double>> all;
  for (int k = 0; k * step <= end + 1e-12; ++k) {
    all.emplace_back(k * step, response.follow(k * step, pressure(k * step)));
  }
  return all;
}

TEST(SensorResponse, FollowsARampByItsTimeConstantWhateverTheStep) {
  constexpr double kTimeConstant = 0.004;
  constexpr double kRate = 1e6;  // Pa/s
  for (const double step : {0.0005, 0.002, 0.004}) {
    for (const auto& [time, indicated] :
         indications(kTimeConstant, step, 0.04, [](double t) { return kRate * t; })) {
      const double exact = kRate * (time - kTimeConstant * (1.0 - std::exp(-time / kTimeConstant)));
      EXPECT_NEAR(indicated, exact, 1e-6) << "step " << step << ", t " << time;
    }
  }
}

TEST(SensorResponse, StartsSettledAndStaysThere) {
  for (const auto& [time, indicated] : indications(0.01, 0.01, 0.1, [](double) { return 1234.5; })) {
    EXPECT_DOUBLE_EQ(indicated, 1234.5) << time;
  }
}

TEST(SensorResponse, KeepsTheImpulseOfABlowAndLowersItsPeak) {
  constexpr double kTimeConstant = 0.005;
  constexpr double kStep = 0.0001;
  // 50 kPa at one reading, straight lines to zero within 2 ms on either side.
  const auto blow = [](double t) { return 5e4 * std::max(0.0, 1.0 - std::abs(t - 0.01) / 0.002); };
  double impulse = 0.0;
  double peak = 0.0;
  double before = 0.0;
  for (const auto& [time, indicated] : indications(kTimeConstant, kStep, 0.2, blow)) {
    impulse += 0.5 * kStep * (before + indicated);
    peak = std::max(peak, indicated);
    before = indicated;
  }
  EXPECT_NEAR(impulse, 100.0, 0.01);
  // A blow much shorter than T leaves impulse / T behind, somewhat less as it lasts 0.8 T.
  EXPECT_GT(peak, 0.6 * 100.0 / kTimeConstant);
  EXPECT_LT(peak, 100.0 / kTimeConstant);
}

INSTANTIATE_TEST_SUITE_P(Dimension, PressureSensorTest, testing::Values(2, 3));

}  // namespace
}  // namespace eisph
