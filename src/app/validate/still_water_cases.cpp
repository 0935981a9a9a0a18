// Water that should stay at rest, and water that swings.

#include "app/validate/cases.hpp"
#include "app/validate/sampling.hpp"
#include "compare/convergence.hpp"
#include "compare/hydrostatic.hpp"
#include "compare/plot.hpp"
#include "compare/sloshing.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kStillDepth = 0.3;

double mean_level(const ValidationRun& run, double time) {
  return value_at(run.table("gauge_level").curve("time", "surface"), time);
}

/// Metrics of one stepping at the end of its run.
void judge_still_water(CaseReport& report, const ValidationRun& run, const std::string& stepping,
                       std::optional<double> energy_limit) {
  const double end = run.scene.end_time;
  const Snapshot& state = run.state(end);
  const NumberTable ledger = run.table("ledger");
  const std::vector<double>& potential = ledger.column("potential_energy");
  const std::string suffix = ", " + stepping;
  const std::string note = fmt::format("after {:g} s", end);
  add_at_most(report, "pressure error" + suffix, 100.0 * hydrostatic_error(run.scene, state, kStillDepth),
              1.4, "% of rho g H", "RMS over the particles, " + note);
  add_at_most(report, "residual speed" + suffix, 1000.0 * speed_rms(state), 3.0, "mm/s", "RMS, " + note);
  const double change = 100.0 * (potential.back() / potential.front() - 1.0);
  if (energy_limit) {
    add_within(report, "potential energy" + suffix, change, -*energy_limit, *energy_limit, "%",
               "change, " + note);
  } else {
    add_information(report, "potential energy" + suffix, change, "%",
                    "change, " + note + "; +0.05 to +0.5 by the last bit of the start");
  }
  add_pairs(report, run, suffix);
  add_information(report, "surface" + suffix, 1000.0 * (mean_level(run, end) - mean_level(run, 0.0)), "mm",
                  "rise of the level in the middle of the tank, " + note);
  add_information(report, "cost" + suffix, run.summary.wall_time_loop / end, "s/s",
                  "wall clock per simulated second");
}

Plot pressure_plot(const std::vector<std::pair<std::string, const ValidationRun*>>& runs) {
  Plot plot{.title = "Still water: pressure in the middle of the tank",
            .x_label = "pressure p [Pa]",
            .y_label = "height z [m]",
            .series = {}};
  for (const auto& [label, run] : runs) {
    std::vector<double> pressure;
    std::vector<double> height;
    const Snapshot& state = run->state(run->scene.end_time);
    for (std::size_t k = 0; k < state.size(); ++k) {
      if (std::abs(state.position[k].x() - 0.5) > 0.05) continue;
      pressure.push_back(state.pressure[k]);
      height.push_back(state.position[k].z());
    }
    plot.series.push_back(
        {.label = label, .curve = make_curve(pressure, height), .style = SeriesStyle::Points});
  }
  Curve exact;
  exact.add(0.0, kStillDepth);
  exact.add(hydrostatic_pressure(kStillDepth, 0.0), 0.0);
  plot.series.push_back({.label = "hydrostatic", .curve = exact, .style = SeriesStyle::Line, .colour = 0});
  return plot;
}

void add_convergence(Validator& validator, CaseReport& report, double duration) {
  ReportTable table{.caption = fmt::format("Still water after {:g} s, default stepping", duration),
                    .columns = {"spacing [m]", "particles", "pressure error [% of rho g H]",
                                "residual speed [mm/s]", "wall clock [s]"},
                    .rows = {}};
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const double spacing : {0.02, 0.01, 0.005}) {
    const ValidationRun run = validator.run(
        {.scene = "still_water",
         .label = fmt::format("dx_{:.0f}um", 1e6 * spacing),
         .overrides = {fmt::format("particles.spacing={}", spacing), fmt::format("end_time={}", duration)},
         .states = {duration}});
    spacings.push_back(spacing);
    errors.push_back(hydrostatic_error(run.scene, run.state(duration), kStillDepth));
    table.rows.push_back({fmt::format("{:g}", spacing), fmt::format("{}", run.summary.fluid_particles),
                          fmt::format("{:.3f}", 100.0 * errors.back()),
                          fmt::format("{:.2f}", 1000.0 * speed_rms(run.state(duration))),
                          fmt::format("{:.2f}", run.summary.wall_time_loop)});
  }
  report.tables.push_back(table);
  add_information(
      report, "order of convergence", observed_order(spacings, errors).least_squares, "-",
      "of the pressure error; the free surface, where pressure starts at particles, is of first order");
}

}  // namespace

void validate_still_water(Validator& validator, CaseReport& report) {
  report.source = "Nomeritae, Daly, Grimaldi & Bui (2016), as reported by De Castro (2019), figure 2.12";
  report.description = "A closed tank of 1.0 x 0.3 m of water at rest, 2D, 10 mm spacing.";
  report.comparison =
      "Pressure against rho g (H - z), speed against zero, potential energy against its start.";
  const double end = validator.pick(30.0, 10.0);
  const std::string end_time = fmt::format("end_time={}", end);
  const ValidationRun symplectic = validator.run(
      {.scene = "still_water", .label = "symplectic", .overrides = {end_time}, .states = {end}});
  const ValidationRun thesis = validator.run({.scene = "still_water",
                                              .label = "thesis",
                                              .overrides = {end_time, "scheme.stepping=thesis"},
                                              .states = {end}});
  // The water settles by 0.16 % in the first second and rises again for half a minute. At 10 s runs that
  // differ in the last bit of their start are at -0.07 to -0.10 %.
  judge_still_water(report, symplectic, "symplectic stepping", validator.pick(0.1, 0.15));
  judge_still_water(report, thesis, "thesis stepping",
                    validator.full() ? std::nullopt : std::optional<double>(0.15));
  const auto path = validator.figure_path("pressure");
  write_plot(path, pressure_plot({{"symplectic stepping", &symplectic}, {"thesis stepping", &thesis}}));
  report.figures.push_back({path, fmt::format("Pressure of the particles within 50 mm of the middle after "
                                              "{:g} s (thesis figure 2.12 d).",
                                              end)});
  add_convergence(validator, report, validator.pick(5.0, 3.0));
}

namespace {

/// Level of the surface at a wall, measured along the normal of the inclined still surface: the start is a
/// slope, a sum of odd modes n with the amplitudes 4 a / (n pi)^2 x 2 of a triangle of half height a.
double sloshing_level(double x, double time, double length, double depth, double half_height,
                      double gravity) {
  double level = 0.0;
  for (int mode = 1; mode <= 15; mode += 2) {
    const double amplitude = 8.0 * half_height / std::pow(mode * std::numbers::pi, 2);
    const SloshingWave wave(amplitude, length, depth, mode, gravity);
    level += wave.surface(x, time) - depth;
  }
  return level;
}

/// Times at which a curve passes through zero, either way.
std::vector<double> zero_crossings(const Curve& curve) {
  std::vector<double> times;
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const double a = curve.y[k - 1];
    const double b = curve.y[k];
    if (a * b < 0.0) times.push_back(curve.x[k - 1] + (curve.x[k] - curve.x[k - 1]) * a / (a - b));
  }
  return times;
}

/// Loss of amplitude in a period (s), %: that of the square roots of the highest kinetic energies of half
/// periods, of which the wave has two in each, by a line of least squares through their logarithms.
double decay_per_period(const ValidationRun& run, double period) {
  const Curve energy = run.table("ledger").curve("time", "kinetic_energy", 1.0 / period, 1.0);
  Curve logarithms;
  const double end = run.scene.end_time / period;
  for (double from = 0.0; from + 0.5 <= end; from += 0.5) {
    const CurvePoint highest = highest_point(restricted(energy, from, from + 0.5));
    logarithms.add(highest.x, 0.5 * std::log(highest.y));
  }
  return 100.0 * (1.0 - std::exp(mean_slope(logarithms, 0.0, end)));
}

/// How fast a wave of 60 spacings dies, by scheme and viscosity.
void study_decay(Validator& validator, CaseReport& report, double period) {
  ReportTable table{.caption = "Loss of amplitude in a period, 60 spacings to the length, six periods [%]",
                    .columns = {"scheme", "default artificial viscosity", "none"},
                    .rows = {}};
  const auto decay = [&](const std::string& scheme, bool viscous) {
    std::vector<std::string> overrides = {"scheme.name=" + scheme, "particles.spacing=0.0166666667",
                                          "end_time=8.0", "output.ledger_interval=0.01"};
    if (!viscous) overrides.emplace_back("fluid.artificial_viscosity=0.0");
    const ValidationRun run =
        validator.run({.scene = "sloshing",
                       .label = fmt::format("decay_{}_{}", scheme, viscous ? "viscous" : "inviscid"),
                       .overrides = overrides,
                       .states = {}});
    return decay_per_period(run, period);
  };
  double of_default = 0.0;
  for (const std::string scheme : {"eisph", "isph", "wcsph", "delta_sph"}) {
    const double viscous = decay(scheme, true);
    if (scheme == "eisph") of_default = viscous;
    table.rows.push_back(
        {scheme, fmt::format("{:.1f}", viscous), fmt::format("{:.1f}", decay(scheme, false))});
  }
  report.tables.push_back(table);
  add_at_most(report, "decay at 60 spacings", of_default, 9.0, "% a period",
              "loss of amplitude, mean over six periods, with the default artificial viscosity, which takes "
              "about 1 of it; a known fault: the aim is 3, and the table shows the other schemes");
}

}  // namespace

void validate_sloshing(Validator& validator, CaseReport& report) {
  report.source = "Linear potential theory (Lamb 1932, art. 228)";
  report.description =
      "A closed tank of 1.0 x 0.3 m of water, 2D; gravity is inclined by 1 in 20, so the level surface of "
      "the "
      "start begins to swing about the inclined one, by 25 mm at the walls.";
  report.comparison =
      "Difference of the levels at the two walls against the sum of the first eight odd modes: the period by "
      "the mean distance of zero crossings, and the whole curve in relative L2.";
  const std::string spacing = validator.pick("particles.spacing=0.005", "particles.spacing=0.01");
  const ValidationRun run = validator.run({.scene = "sloshing", .overrides = {spacing}, .states = {}});
  const Curve left = run.table("gauge_wall").curve("time", "surface");
  const Curve right = run.table("gauge_opposite_wall").curve("time", "surface");
  // Half the difference of the walls, about the inclined surface at rest.
  const double gravity = run.scene.gravity.norm();
  const double slope = -run.scene.gravity.x() / run.scene.gravity.z();
  const double half_height = 0.5 * slope;
  Curve measured;
  Curve theory;
  for (std::size_t k = 0; k < left.size(); ++k) {
    measured.add(left.x[k], 0.5 * (left.y[k] - right.y[k]) + half_height);
    theory.add(left.x[k], sloshing_level(0.0, left.x[k], 1.0, kStillDepth, half_height, gravity));
  }
  const std::vector<double> crossings = zero_crossings(measured);
  const double period = crossings.size() < 2 ? std::nan("")
                                             : 2.0 * (crossings.back() - crossings.front()) /
                                                   static_cast<double>(crossings.size() - 1);
  const double expected = SloshingWave(0.01, 1.0, kStillDepth, 1, gravity).period();
  add_within(report, "period", 100.0 * (period / expected - 1.0), -3.0, 3.0, "%",
             fmt::format("deviation from the first mode's {:.4f} s", expected));
  add_information(report, "level at the walls", 100.0 * curve_difference(measured, theory).relative_l2, "%",
                  "relative L2 over four periods; linear theory has no viscosity, so decay counts as error");
  add_at_most(report, "level at the walls, first half period",
              100.0 * curve_difference(restricted(measured, 0.0, 0.5 * expected), theory).relative_l2, 5.0,
              "%", "relative L2");
  const double last = std::abs(highest_point(restricted(measured, 4.0, 5.5)).y);
  add_information(report, "amplitude after three periods", 100.0 * last / half_height, "% of the start");
  add_pairs(report, run);
  study_decay(validator, report, expected);
  const auto path = validator.figure_path("level");
  write_plot(
      path,
      {.title = "Standing wave: level at the wall",
       .x_label = "time t [s]",
       .y_label = "height above the level at rest [m]",
       .series = {{.label = "EISPH", .curve = measured},
                  {.label = "linear theory", .curve = theory, .style = SeriesStyle::Dashed, .colour = 0}}});
  report.figures.push_back({path, "Half the difference of the levels at the two walls."});
}

}  // namespace eisph
