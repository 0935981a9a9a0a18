// Columns of water that collapse onto a dry floor: Shao & Lo, Martin & Moyce.

#include "app/validate/cases.hpp"
#include "app/validate/sampling.hpp"
#include "compare/convergence.hpp"
#include "compare/field_plot.hpp"
#include "compare/plot.hpp"
#include "compare/reference_table.hpp"

#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kGravity = 9.81;

/// Largest difference in T that a gate or diaphragm is allowed to explain.
constexpr double kLongestDelay = 0.5;

/// Front in Z = x / a over T = t sqrt(n2 g / a).
Curve dimensionless_front(const ValidationRun& run, double width, double n2) {
  return scaled(run.table("front_front").curve("time", "front"), std::sqrt(n2 * kGravity / width),
                1.0 / width);
}

/// Compares a front with a measured one after the shift in T that suits best.
ShiftedDifference judge_front(CaseReport& report, const Curve& front, const Curve& measured, double limit) {
  const ShiftedDifference best = best_shift(front, measured, 0.0, kLongestDelay);
  add_at_most(
      report, "front", 100.0 * best.difference.relative_l2, limit, "%",
      fmt::format("relative L2 of Z after a delay of T = {:.2f} for the release, which is not modelled",
                  best.shift));
  add_information(report, "front without a delay", 100.0 * curve_difference(front, measured).relative_l2, "%",
                  "relative L2 of Z");
  return best;
}

/// The same column on walls that hold the water: what friction could do to the front.
Curve no_slip_front(Validator& validator, const std::string& scene, double width, double n2) {
  const ValidationRun run =
      validator.run({.scene = scene,
                     .label = "no_slip",
                     .overrides = {"domain.faces.x_min=no_slip", "domain.faces.z_min=no_slip"},
                     .states = {}});
  return dimensionless_front(run, width, n2);
}

Plot front_plot(const std::string& title, const std::string& time_label, const Curve& front, double shift,
                const ReferenceTable& measured) {
  Plot plot{.title = title, .x_label = time_label, .y_label = "Z = x / a [-]", .series = {}};
  plot.series.push_back({.label = "EISPH", .curve = front});
  plot.series.push_back({.label = fmt::format("EISPH, delayed by T = {:.2f}", shift),
                         .curve = shifted(front, shift),
                         .style = SeriesStyle::Dashed});
  plot.series.push_back({.label = "Martin & Moyce (1952)",
                         .curve = measured.curve("scaled_time", "scaled_front"),
                         .style = SeriesStyle::Points,
                         .colour = 0});
  return plot;
}

constexpr double kShaoLoWidth = 0.1;
constexpr double kShaoLoHeight = 0.2;

/// Isobars at 0.05 and 0.18 s (thesis figures 4.4, 4.5) and the largest smoothed pressure at 0.05 s.
void judge_pressure(Validator& validator, CaseReport& report, const ValidationRun& run, double y) {
  const Section section{0.0, 0.4, y};
  const double whole = run.scene.density * kGravity * kShaoLoHeight;
  for (const double time : {0.05, 0.18}) {
    const GridValues pressure = pressure_field(run.scene, run.state(time), section, kShaoLoHeight);
    if (time == 0.05) {
      add_within(report, "largest pressure at 0.05 s", largest(pressure) / whole, 0.47, 0.53, "rho g H",
                 "kernel-smoothed; about half in Shao & Lo and in the thesis");
    }
    FieldPlot plot{.title = fmt::format("Pressure at t = {:g} s", time),
                   .x_label = "x [m]",
                   .y_label = "z [m]",
                   .value_label = "pressure [Pa]",
                   .grid = pressure,
                   .levels = {100.0, 200.0, 400.0, 600.0, 800.0}};
    plot.value_range = {0.0, 1000.0};
    const auto path = validator.figure_path(fmt::format("isobars_{:g}s", time));
    write_field_plot(path, plot);
    report.figures.push_back({path, fmt::format("Isobars at {:g} s (thesis figures 4.4, 4.5).", time)});
  }
}

/// Particles at four times (thesis figure 4.2).
void add_configurations(Validator& validator, CaseReport& report, const ValidationRun& run, double y) {
  for (const double time : {0.05, 0.1, 0.15, 0.18}) {
    ScatterPlot plot = pressure_scatter(run.state(time), {0.0, 0.42, y}, kShaoLoHeight);
    plot.title = fmt::format("Particles at t = {:g} s", time);
    plot.value_range = {0.0, 1000.0};
    const auto path = validator.figure_path(fmt::format("particles_{:g}s", time));
    write_scatter_plot(path, plot);
    report.figures.push_back({path, fmt::format("Particles at {:g} s (thesis figure 4.2).", time)});
  }
}

void judge_shao_lo(Validator& validator, CaseReport& report, const ValidationRun& run, double y) {
  const Curve front = dimensionless_front(run, kShaoLoWidth, 2.0);
  const ReferenceTable measured = reference_table("martin_moyce_front_n2_2");
  add_within(report, "T at Z = 3", first_rise_to(front, 3.0), 2.28, 2.60, "-",
             "free slip; prototype 2.29, Martin & Moyce 2.51 with a diaphragm that took time to go");
  const ShiftedDifference best =
      judge_front(report, front, measured.curve("scaled_time", "scaled_front"), 5.0);
  judge_pressure(validator, report, run, y);

  Plot plot =
      front_plot("Front of the collapsing column", "T = t sqrt(2 g / a) [-]", front, best.shift, measured);
  plot.series.push_back({.label = "Koshizuka & Oka (1996)",
                         .curve = reference_table("koshizuka_oka_front").curve("scaled_time", "scaled_front"),
                         .style = SeriesStyle::Points});
  plot.x_range = {0.0, 3.5};
  plot.y_range = {1.0, 4.5};
  const auto path = validator.figure_path("front");
  write_plot(path, plot);
  report.figures.push_back({path, "Leading edge (thesis figure 4.3)."});
  add_configurations(validator, report, run, y);
}

/// Order of the front's position, from three spacings and Richardson's argument: differences of successive
/// spacings fall with the order of the scheme.
void add_front_convergence(Validator& validator, CaseReport& report) {
  constexpr double kTime = 0.15;
  ReportTable table{.caption = "Front of the 2D column at 0.15 s, default stepping",
                    .columns = {"spacing [m]", "particles", "front [m]", "difference to the next finer [mm]",
                                "wall clock [s]"},
                    .rows = {}};
  std::vector<double> fronts;
  const std::vector<double> spacings = {0.01, 0.005, 0.0025, 0.00125};
  for (const double spacing : spacings) {
    const ValidationRun run = validator.run(
        {.scene = "shao_lo_2d",
         .label = fmt::format("dx_{:.0f}um", 1e6 * spacing),
         .overrides = {fmt::format("particles.spacing={}", spacing), fmt::format("end_time={}", kTime)},
         .states = {}});
    // The water reaches half a spacing beyond the centre of its first particle.
    fronts.push_back(value_at(run.table("front_front").curve("time", "front"), kTime) + 0.5 * spacing);
    table.rows.push_back({fmt::format("{:g}", spacing), fmt::format("{}", run.summary.fluid_particles),
                          fmt::format("{:.4f}", fronts.back()), "",
                          fmt::format("{:.2f}", run.summary.wall_time_loop)});
  }
  std::vector<double> differences;
  for (std::size_t k = 0; k + 1 < fronts.size(); ++k) {
    differences.push_back(std::abs(fronts[k + 1] - fronts[k]));
    table.rows[k][3] = fmt::format("{:.2f}", 1000.0 * differences.back());
  }
  report.tables.push_back(table);
  add_information(report, "order of convergence",
                  observed_order({spacings.begin(), spacings.end() - 1}, differences).least_squares, "-",
                  "of the front at 0.15 s, from differences of successive spacings");
  add_at_most(report, "spacing error of the front", 1000.0 * differences[1], 5.0, "mm",
              "between 5 mm and 2.5 mm spacing, at 0.15 s");
}

}  // namespace

void validate_shao_lo_2d(Validator& validator, CaseReport& report) {
  report.source =
      "Shao & Lo (2003), Adv. Water Resour. 26:787-800, in De Castro (2019), section 4.1.1; Martin & Moyce "
      "(1952), Phil. Trans. R. Soc. A 244:312-324";
  report.description = "A column 0.1 m wide and 0.2 m high, 800 particles 5 mm apart, free slip.";
  report.comparison = "Front against the measured one, pressure against that of Shao & Lo.";
  const ValidationRun run = validator.run({.scene = "shao_lo_2d", .states = {0.05, 0.1, 0.15, 0.18}});
  judge_shao_lo(validator, report, run, 0.0);
  add_front_convergence(validator, report);
}

void validate_shao_lo_3d(Validator& validator, CaseReport& report) {
  report.source = "As in two dimensions; De Castro (2019), section 4.1.1";
  report.description = "The same column 0.1 m deep, 16,000 particles 5 mm apart, free slip.";
  report.comparison =
      "The middle of the channel: front against the measured one, pressure against Shao & Lo.";
  const ValidationRun run =
      validator.run({.scene = "shao_lo_3d", .states = {0.05, 0.1, 0.15, 0.18}, .frames = true});
  judge_shao_lo(validator, report, run, 0.05);
  report.figures.push_back(run.frame("front", 0.15, "Frame at 0.15 s."));
  add_at_most(report, "energy gain", 100.0 * run.summary.energy_gain_max / run.summary.energy_initial, 0.25,
              "%", "prototype 0.25 %");
  add_at_most(report, "worst compression", 100.0 * run.summary.compression_max, 5.0, "%",
              "of a single particle; prototype 2.5 %, with its rougher walls");
  add_at_most(report, "95th percentile of compression", 100.0 * run.summary.compression_p95, 1.5, "%");
}

void validate_martin_moyce_n1(Validator& validator, CaseReport& report) {
  constexpr double kWidth = 0.05715;
  const ReferenceTable measured = reference_table("martin_moyce_front_n2_1");
  report.source = measured.citation;
  report.description = "A square column, a = 57.15 mm, 2D, 24 particles wide, free slip.";
  report.comparison = "Front against the measured one.";
  const ValidationRun run = validator.run({.scene = "martin_moyce_n1", .states = {}});
  const Curve front = dimensionless_front(run, kWidth, 1.0);
  const ShiftedDifference best =
      judge_front(report, front, measured.curve("scaled_time", "scaled_front"), 10.0);
  const auto path = validator.figure_path("front");
  Plot plot = front_plot("Square column: front", "T = t sqrt(g / a) [-]", front, best.shift, measured);
  plot.series.push_back({.label = "EISPH, no slip",
                         .curve = no_slip_front(validator, "martin_moyce_n1", kWidth, 1.0),
                         .style = SeriesStyle::Dotted});
  write_plot(path, plot);
  report.figures.push_back({path, "Leading edge."});
}

void validate_martin_moyce_n2(Validator& validator, CaseReport& report) {
  constexpr double kWidth = 0.05715;
  const ReferenceTable measured = reference_table("martin_moyce_front_n2_2");
  const ReferenceTable heights = reference_table("martin_moyce_height_n2_2");
  report.source = measured.citation;
  report.description = "A column twice as high as wide, a = 57.15 mm, 2D, 24 particles wide, free slip.";
  report.comparison =
      "Front and residual height at the upstream wall against the measured ones, each after the delay of the "
      "release that suits best (not more than T = 0.5).";
  const ValidationRun run = validator.run({.scene = "martin_moyce_n2", .states = {0.1, 0.2}, .frames = true});
  const Curve front = dimensionless_front(run, kWidth, 2.0);
  const ShiftedDifference best =
      judge_front(report, front, measured.curve("scaled_time", "scaled_front"), 5.0);
  const Curve height = scaled(run.table("gauge_column").curve("time", "surface"),
                              std::sqrt(kGravity / kWidth), 1.0 / (2.0 * kWidth));
  const Curve measured_height = heights.curve("scaled_time", "scaled_height");
  const ShiftedDifference height_shift = best_shift(height, measured_height, 0.0, kLongestDelay);
  add_at_most(report, "column height", 100.0 * height_shift.difference.relative_l2, 5.0, "%",
              fmt::format("relative L2 after a delay of tau = {:.2f}", height_shift.shift));
  add_information(report, "column height without a delay",
                  100.0 * curve_difference(height, measured_height).relative_l2, "%", "relative L2");

  const auto path = validator.figure_path("front");
  Plot plot = front_plot("Tall column: front", "T = t sqrt(2 g / a) [-]", front, best.shift, measured);
  plot.series.push_back({.label = "EISPH, no slip",
                         .curve = no_slip_front(validator, "martin_moyce_n2", kWidth, 2.0),
                         .style = SeriesStyle::Dotted});
  plot.x_range = {0.0, 3.5};
  plot.y_range = {1.0, 5.0};
  write_plot(path, plot);
  report.figures.push_back({path, "Leading edge (thesis figure 2.10)."});
  const auto height_path = validator.figure_path("height");
  write_plot(height_path, {.title = "Tall column: residual height at the upstream wall",
                           .x_label = "tau = t sqrt(g / a) [-]",
                           .y_label = "height / 2a [-]",
                           .series = {{.label = "EISPH", .curve = height},
                                      {.label = "Martin & Moyce (1952)",
                                       .curve = measured_height,
                                       .style = SeriesStyle::Points,
                                       .colour = 0}}});
  report.figures.push_back({height_path, "Height of the column at the wall."});
  report.figures.push_back(run.frame("front", 0.1, "Frame at 0.1 s."));
}

}  // namespace eisph
