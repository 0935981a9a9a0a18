#include "app/pareto/pareto_cases.hpp"

#include "app/case_choice.hpp"
#include "app/validate/sampling.hpp"
#include "compare/reference_table.hpp"
#include "compare/ritter.hpp"

#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kGravity = 9.81;
constexpr double kDensity = 1000.0;

constexpr double kRitterDepth = 0.1;
constexpr double kRitterDam = 1.5;

/// Relative L2 of the free surface at the end of the run.
double ritter_error(const ValidationRun& run, const ValidationRun*) {
  const RitterSolution ritter(kRitterDepth);
  const double time = run.scene.end_time;
  const Curve profile = surface_profile(run.scene, run.state(time), {0.0, 3.3, 0.0});
  Curve exact;
  for (const double x : profile.x) exact.add(x, ritter.depth(x - kRitterDam, time));
  return 100.0 * curve_difference(profile, exact).relative_l2;
}

/// Relative L2 of the front, after the delay of the release that suits best.
double martin_moyce_error(const ValidationRun& run, const ValidationRun*) {
  constexpr double kWidth = 0.05715;
  constexpr double kLongestDelay = 0.5;
  const Curve front = scaled(run.table("front_front").curve("time", "front"),
                             std::sqrt(2.0 * kGravity / kWidth), 1.0 / kWidth);
  const Curve measured = reference_table("martin_moyce_front_n2_2").curve("scaled_time", "scaled_front");
  return 100.0 * best_shift(front, measured, 0.0, kLongestDelay).difference.relative_l2;
}

/// RMS of the pressure of the particles, over rho g H.
double still_water_error(const ValidationRun& run, const ValidationRun*) {
  return 100.0 * hydrostatic_error(run.scene, run.state(run.scene.end_time), 0.3);
}

constexpr double kBuchnerDepth = 0.6;
const double kBuchnerTime = std::sqrt(kGravity / kBuchnerDepth);

Curve buchner_pressure(const ValidationRun& run, const std::string& sensor) {
  const Curve pressure =
      run.table("pressure_sensor_" + sensor)
          .curve("time", "pressure", kBuchnerTime, 1.0 / (kDensity * kGravity * kBuchnerDepth));
  // Single blows of particles on the sensor are no part of what was measured.
  return moving_average(pressure, 0.02 * kBuchnerTime);
}

/// Relative L2 of the pressure from its arrival until the jet falls back.
double buchner_p1_error(const ValidationRun& run, const ValidationRun*) {
  const Curve measured = restricted(reference_table("buchner_p1").curve("scaled_time", "scaled_pressure"),
                                    2.3, std::min(6.2, run.scene.end_time * kBuchnerTime));
  return 100.0 * curve_difference(buchner_pressure(run, "P1_114"), measured).relative_l2;
}

/// Relative L2 of the pressure in the corner against the reference run, until the front reaches the wall.
double buchner_p0_error(const ValidationRun& run, const ValidationRun* reference) {
  const Curve exact = restricted(buchner_pressure(*reference, "P0"), 0.1, 2.3);
  return 100.0 * curve_difference(buchner_pressure(run, "P0"), exact).relative_l2;
}

/// Relative L2 of the way of the front against the reference run. The water reaches half a spacing beyond
/// the centre of its first particle.
double front_error(const ValidationRun& run, const ValidationRun* reference, double start, double end) {
  const auto way = [&](const ValidationRun& of) {
    return shifted(of.table("front_front").curve("time", "bulk_front"), 0.0,
                   0.5 * of.scene.particle_spacing - start);
  };
  return 100.0 * curve_difference(way(run), restricted(way(*reference), 0.02, end)).relative_l2;
}

std::vector<std::string> phi(double value) { return {fmt::format("scheme.phi={}", value)}; }

void add(std::vector<ParetoSetting>& settings, const std::string& series, const std::string& step,
         const std::vector<std::string>& scheme, const std::vector<std::string>& more) {
  ParetoSetting setting{series, step, scheme};
  setting.overrides.insert(setting.overrides.end(), more.begin(), more.end());
  settings.push_back(std::move(setting));
}

}  // namespace

const std::vector<ParetoSetting>& pareto_settings() {
  static const std::vector<ParetoSetting> kSettings = [] {
    std::vector<ParetoSetting> settings;
    for (const double value : {0.06, 0.11, 0.17, 0.25}) {
      add(settings, "EISPH", fmt::format("phi {:g}", value), {"scheme.name=eisph"}, phi(value));
    }
    add(settings, "EISPH", "phi 0.17, fast at rest",
        {"scheme.name=eisph", "scheme.reference_speed_weight=0.67"}, phi(0.17));
    add(settings, "EISPH", "phi 0.25, 2 sweeps", {"scheme.name=eisph", "scheme.pressure_sweeps=2"},
        phi(0.25));
    for (const double value : {0.034, 0.06, 0.114}) {
      add(settings, "EISPH, thesis", fmt::format("phi {:g}", value),
          {"scheme.name=eisph", "scheme.stepping=thesis"}, phi(value));
    }
    for (const double value : {0.06, 0.17, 0.25}) {
      add(settings, "ISPH", fmt::format("phi {:g}", value), {"scheme.name=isph"}, phi(value));
    }
    struct Compressible {
      const char* name;
      const char* label;
    };
    for (const auto& [name, label] :
         {Compressible{"wcsph", "WCSPH"}, Compressible{"delta_sph", "delta-SPH"}}) {
      const std::string scheme = std::string("scheme.name=") + name;
      for (const double value : {0.25, 0.5}) {
        add(settings, label, fmt::format("Courant {:g}", value),
            {scheme, fmt::format("scheme.courant={}", value)}, {});
      }
      add(settings, std::string(label) + ", Runge-Kutta", "Courant 1.5",
          {scheme, "scheme.stepping=runge_kutta", "scheme.courant=1.5"}, {});
    }
    return settings;
  }();
  return kSettings;
}

std::string setting_name(const std::string& scheme, const std::string& step) { return scheme + ", " + step; }

std::vector<ParetoSetting> choose_settings(const std::vector<std::string>& texts) {
  return choose_by_text(
      "pareto --only", pareto_settings(),
      [](const ParetoSetting& setting) { return setting_name(setting.scheme, setting.step); }, texts);
}

const std::vector<ParetoCase>& pareto_cases() {
  static const std::vector<ParetoCase> kCases = {
      {.name = "ritter_long",
       .title = "Dam break on a dry bed, long reservoir",
       .scene = "ritter_long",
       .full_spacings = {0.01, 0.005, 0.0025},
       .quick_spacings = {0.01, 0.005},
       .full_end = 0.8,
       .quick_end = 0.8,
       .errors = {{"profile", "free surface at 0.8 s against Ritter (1892), relative L2", ritter_error}},
       .states = true},
      {.name = "martin_moyce",
       .title = "Collapse of a column, n^2 = 2",
       .scene = "martin_moyce_n2",
       .full_spacings = {0.0047625, 0.00238125, 0.001190625},
       .quick_spacings = {0.0047625, 0.00238125},
       .full_end = 0.24,
       .quick_end = 0.24,
       .errors = {{"front",
                   "way of the front against Martin & Moyce (1952) after the delay of the release that "
                   "suits best, relative L2",
                   martin_moyce_error},
                  {"reference", "way of the front against the reference run, relative L2",
                   [](const ValidationRun& run, const ValidationRun* reference) {
                     return front_error(run, reference, 0.05715, 0.24);
                   }}},
       .reference = {"scheme.phi=0.06"}},
      {.name = "still_water",
       .title = "Water at rest",
       .scene = "still_water",
       .full_spacings = {0.02, 0.01, 0.005},
       .quick_spacings = {0.02, 0.01},
       .full_end = 5.0,
       .quick_end = 2.0,
       .errors = {{"pressure", "pressure of the particles at the end against rho g depth, RMS over rho g H",
                   still_water_error}},
       .states = true},
      {.name = "buchner",
       .title = "Dam break against a wall",
       .scene = "buchner",
       .full_spacings = {0.01, 0.008, 0.006},
       .quick_spacings = {0.02, 0.01},
       .full_end = 4.2,
       .quick_end = 1.6,
       .errors = {{"P1",
                   "pressure on the wall at 114 mm against Buchner (2002) from t sqrt(g / H) = 2.3 to 6.2, "
                   "averaged over 20 ms, relative L2",
                   buchner_p1_error},
                  {"P0",
                   "pressure in the corner under the reservoir against the reference run until the wave "
                   "reaches the wall, relative L2",
                   buchner_p0_error},
                  {"front",
                   "way of the front against the reference run until it reaches the wall, relative L2",
                   [](const ValidationRun& run, const ValidationRun* reference) {
                     return front_error(run, reference, 1.2, 0.55);
                   }}},
       .reference = {"scheme.phi=0.06", "end_time=0.7"}},
      {.name = "shao_lo_3d",
       .title = "Collapse of a column in space",
       .scene = "shao_lo_3d",
       .full_spacings = {0.01, 0.00625, 0.005},
       .quick_spacings = {0.01},
       .full_end = 0.2,
       .quick_end = 0.2,
       .errors = {{"front", "way of the front against the reference run, relative L2",
                   [](const ValidationRun& run, const ValidationRun* reference) {
                     return front_error(run, reference, 0.1, 0.2);
                   }}},
       .reference = {"scheme.phi=0.06", "end_time=0.2"}},
  };
  return kCases;
}

}  // namespace eisph
