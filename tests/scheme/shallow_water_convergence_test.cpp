#include "scheme/shallow_water_exact.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Orders of convergence between each error and the next, which belongs to cells half as large.
std::vector<double> orders(const std::vector<double>& errors) {
  std::vector<double> result;
  for (std::size_t k = 1; k < errors.size(); ++k) result.push_back(std::log2(errors[k - 1] / errors[k]));
  return result;
}

template <class Errors>
void record(const Errors& errors) {
  for (std::size_t k = 0; k < errors.size(); ++k) {
    testing::Test::RecordProperty("error_" + std::to_string(k), std::to_string(errors[k]));
  }
  const std::vector<double> order = orders(errors);
  for (std::size_t k = 0; k < order.size(); ++k) {
    testing::Test::RecordProperty("order_" + std::to_string(k), std::to_string(order[k]));
  }
}

constexpr double kStillDepth = 0.1;

double hump(double x) {
  const double place = (x - 1.0) / 0.5;
  return kStillDepth + (std::abs(place) < 1.0 ? 0.01 * std::pow(std::cos(0.5 * M_PI * place), 4) : 0.0);
}

/// A wave that travels to the right: u = 2 (c - c0), and every depth moves at u + c = 3 c - 2 c0.
double simple_wave_depth(double x, double time) {
  const double c0 = std::sqrt(kGravity * kStillDepth);
  double low = x - 3.0 * time * c0;
  double high = x;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    const double arrives = middle + (3.0 * std::sqrt(kGravity * hump(middle)) - 2.0 * c0) * time;
    (arrives < x ? low : high) = middle;
  }
  return hump(0.5 * (low + high));
}

double simple_wave_error(std::size_t cells, SlopeLimiter limiter) {
  const double length = 3.0;
  const double cell = length / static_cast<double>(cells);
  const double c0 = std::sqrt(kGravity * kStillDepth);
  std::vector<DepthAndVelocity> means(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    const double lower = static_cast<double>(i) * cell;
    const auto discharge = [&](double x) { return hump(x) * 2.0 * (std::sqrt(kGravity * hump(x)) - c0); };
    means[i].depth = mean_of(hump, lower, lower + cell);
    means[i].velocity = mean_of(discharge, lower, lower + cell) / means[i].depth;
  }
  Scene scene = channel(length, cell, means);
  scene.shallow_water.limiter = limiter;
  const auto simulation = start(scene);
  const double time = 0.6;  // breaks at about 1.3 s
  run_until(*simulation, time);
  return depth_error(*simulation->snapshot(), [&](double x) { return simple_wave_depth(x, time); });
}

class Convergence : public testing::TestWithParam<SlopeLimiter> {};

TEST_P(Convergence, OfASmoothWaveIsOfSecondOrder) {
  std::vector<double> errors;
  for (const std::size_t cells : {150U, 300U, 600U})
    errors.push_back(1e6 * simple_wave_error(cells, GetParam()));
  record(errors);
  EXPECT_GE(orders(errors).back(), 1.8);
  EXPECT_LT(errors.back(), 10.0) << "micrometres of a hump of a centimetre";
}

INSTANTIATE_TEST_SUITE_P(Limiters, Convergence,
                         testing::Values(SlopeLimiter::Minmod, SlopeLimiter::MonotonisedCentral),
                         [](const auto& limiter) {
                           return limiter.param == SlopeLimiter::Minmod ? "Minmod" : "MonotonisedCentral";
                         });

/// Mean depth error after a dam break in the middle of a channel of 4 m.
double dam_break_error(std::size_t cells, double deep, double shallow, double time,
                       const std::function<double(double)>& exact) {
  const double cell = 4.0 / static_cast<double>(cells);
  std::vector<DepthAndVelocity> means(cells, {shallow, 0.0});
  for (std::size_t i = 0; i < cells / 2; ++i) means[i].depth = deep;
  const auto simulation = start(channel(4.0, cell, means));
  run_until(*simulation, time);
  EXPECT_NEAR(simulation->summary().mass_error, 0.0, 1e-13);
  return depth_error(*simulation->snapshot(), [&](double x) { return exact(x - 2.0); });
}

TEST(Convergence, ToStokersBoreIsOfFirstOrder) {
  const Stoker stoker(0.2, 0.05);
  std::vector<double> errors;
  for (const std::size_t cells : {100U, 200U, 400U, 800U}) {
    errors.push_back(
        1e6 * dam_break_error(cells, 0.2, 0.05, 0.7, [&](double x) { return stoker.at(x, 0.7).depth; }));
  }
  record(errors);
  EXPECT_GE(orders(errors).back(), 0.8);
  EXPECT_LT(errors.back(), 200.0) << "micrometres: a thousandth of the depth";
}

TEST(Convergence, ToRittersDamBreakIsOfFirstOrder) {
  std::vector<double> errors;
  for (const std::size_t cells : {100U, 200U, 400U, 800U}) {
    errors.push_back(
        1e6 * dam_break_error(cells, 0.2, 0.0, 0.5, [](double x) { return ritter(0.2, x, 0.5).depth; }));
  }
  record(errors);
  EXPECT_GE(orders(errors).back(), 0.8);
  EXPECT_LT(errors.back(), 200.0);
}

TEST(DamBreak, OnAWetBedHasStokersPlateauAndBore) {
  const Stoker stoker(0.2, 0.05);
  std::vector<DepthAndVelocity> means(400, {0.05, 0.0});
  for (std::size_t i = 0; i < 200; ++i) means[i].depth = 0.2;
  const auto simulation = start(channel(4.0, 0.01, means));
  run_until(*simulation, 0.7);
  const auto snapshot = simulation->snapshot();
  const double bore = 2.0 + 0.7 * stoker.bore_speed();
  const auto behind = static_cast<std::size_t>((bore - 0.1) / 0.01);
  EXPECT_NEAR(snapshot->columns->depth[behind], stoker.middle_depth(), 1e-4);
  EXPECT_NEAR(snapshot->columns->velocity_x[behind], stoker.middle_velocity(), 1e-3);
  const auto half_way = std::find_if(snapshot->columns->depth.begin(), snapshot->columns->depth.end(),
                                     [&](float h) { return h < 0.5 * (stoker.middle_depth() + 0.05); });
  EXPECT_NEAR(0.01 * static_cast<double>(half_way - snapshot->columns->depth.begin()), bore, 0.02);
}

}  // namespace
}  // namespace eisph
