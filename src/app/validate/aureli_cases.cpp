// The flat tank of Aureli et al. (2008) against their own kind of model, shallow water.

#include "app/validate/cases.hpp"
#include "app/validate/sampling.hpp"
#include "compare/plot.hpp"
#include "compare/reference_table.hpp"
#include "probe/depth_grid.hpp"
#include "probe/fluid_field.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

const std::string kSource =
    "Aureli, Maranzoni, Mignosa & Ziveri (2008), J. Hydraul. Eng. 134:1089-1101, in De Castro (2019)";
const std::string kDepthRules = "output.depth_rule=surface";
/// Cells on which depths are compared: those of the thesis at 10 mm spacing.
const std::string kDepthCells = "output.depth_cell_size=0.015";
constexpr double kDryDepth = 0.005;  ///< m, what the experiment's camera could not see
constexpr double kDownstream = 0.825;

bool is_floodable(const Scene& scene, const Vec3d& point) {
  if (point.x() < kDownstream) return false;
  return std::none_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const Obstacle& obstacle) {
    return obstacle.shape.signed_distance(Vec3d(point.x(), point.y(), scene.domain_min.z() + 1e-6), 3) <
           scene.output.depth_cell_size;
  });
}

/// Depth of one model against another's over the floodable area, all times pooled.
DepthDifference depth_difference(const ValidationRun& run, const ValidationRun& reference,
                                 const std::vector<double>& times) {
  const DepthGridBuilder run_depth(run.scene);
  const DepthGridBuilder reference_depth(reference.scene);
  DepthDifference difference(kDryDepth);
  for (const double time : times) {
    const DepthGrid a = run_depth.build(run.state(time));
    const DepthGrid b = reference_depth.build(reference.state(time));
    for (std::size_t j = 0; j < std::min(a.rows, b.rows); ++j) {
      for (std::size_t i = 0; i < std::min(a.columns, b.columns); ++i) {
        const Vec3d centre(a.origin_x + (static_cast<double>(i) + 0.5) * a.cell_size,
                           a.origin_y + (static_cast<double>(j) + 0.5) * a.cell_size, 0.0);
        if (is_floodable(run.scene, centre)) difference.add(a.at(i, j), b.at(i, j));
      }
    }
  }
  return difference;
}

/// RMS (m) of a deviation table of the thesis: its simulation against the photographs.
double thesis_rms(const std::string& table) {
  const ReferenceTable deviation = reference_table(table);
  double sum = 0.0;
  for (std::size_t k = 0; k < deviation.rows(); ++k) {
    const double value = deviation.column("deviation")[k];
    sum += deviation.column("share")[k] * value * value;
  }
  return std::sqrt(sum);
}

void judge_depth(CaseReport& report, const ValidationRun& run, const ValidationRun& shallow,
                 const std::vector<double>& times) {
  const DepthDifference difference = depth_difference(run, shallow, times);
  const double limit = 1000.0 * thesis_rms("thesis_deviation_144k");
  add_at_most(report, "depth", 1000.0 * difference.rms(), limit, "mm",
              "RMS against the shallow-water solver over the floodable area, all times; the limit is the "
              "thesis's own RMS against the photographs of test 4");
  add_information(report, "depth, bias", 1000.0 * difference.bias(), "mm", "mean of EISPH - shallow water");
  add_information(report, "wetted area", 100.0 * difference.wetted_overlap(), "%",
                  "wetted by 5 mm in both over wetted in either");
  add_pairs(report, run);
}

void add_depth_maps(CaseReport& report, const ValidationRun& run, const ValidationRun& shallow,
                    const std::vector<double>& times, const std::string& figure) {
  for (const double time : times) {
    report.figures.push_back(
        run.frame("depth", time, fmt::format("EISPH, water depth at {:g} s ({}).", time, figure)));
    report.figures.push_back(
        shallow.frame("depth", time, fmt::format("Shallow water, water depth at {:g} s.", time)));
  }
}

ValidationRun shallow_water_run(Validator& validator, const std::string& scene, double end,
                                const std::vector<double>& times) {
  return validator.run(
      {.scene = scene,
       .label = "shallow_water",
       .overrides = {"scheme.name=shallow_water", fmt::format("end_time={}", end), kDepthCells},
       .states = times,
       .frames = true});
}

void add_gauge_series(Plot& plot, const ValidationRun& run, const std::string& label) {
  const NumberTable table = run.table("gauge_gauge");
  plot.series.push_back({.label = label + ", free surface", .curve = table.curve("time", "surface")});
  if (run.scene.scheme.name != "eisph") return;
  plot.series.push_back({.label = label + ", highest particle",
                         .curve = table.curve("time", "level"),
                         .style = SeriesStyle::Dotted});
}

void add_gauge_figure(Validator& validator, CaseReport& report, const ValidationRun& run,
                      const ValidationRun& shallow, const std::string& figure) {
  Plot plot{.title = "Water level at x = 1.674 m, y = 0.022 m",
            .x_label = "time t [s]",
            .y_label = "water level [m]",
            .series = {}};
  add_gauge_series(plot, run, "EISPH");
  add_gauge_series(plot, shallow, "shallow water");
  const auto path = validator.figure_path("gauge");
  write_plot(path, plot);
  report.figures.push_back({path, fmt::format("Water level at the gauge ({}).", figure)});
}

}  // namespace

void validate_aureli_test4(Validator& validator, CaseReport& report) {
  const std::vector<double> times = {0.4, 0.75, 1.45, 2.16, 2.86};
  const double end = validator.pick(5.4, 2.9);
  report.source = kSource + ", section 4.2.1";
  report.description = fmt::format(
      "Tank of 2.6 x 1.2 m, 0.15 m of water behind a breach, an obstacle behind it: EISPH at {} mm spacing, "
      "the "
      "shallow-water solver on 5 mm cells with Manning 0.007 s m^(-1/3).",
      validator.pick("10", "16.7"));
  report.comparison =
      "Water depth on 15 mm cells at the five times of the photographs, which cannot be had, against the "
      "shallow-water solver, the kind of model that the authors of the experiment used.";
  const ValidationRun run =
      validator.run({.scene = validator.pick<std::string>("aureli_test4_full", "aureli_coarse"),
                     .label = "eisph",
                     .overrides = {fmt::format("end_time={}", end), kDepthRules, kDepthCells},
                     .states = times,
                     .frames = true});
  const ValidationRun shallow = shallow_water_run(validator, "aureli_test4_full", end, times);
  judge_depth(report, run, shallow, times);
  add_at_most(report, "worst compression", 100.0 * run.summary.compression_max, 10.0, "%");
  add_at_most(report, "energy gain", 100.0 * run.summary.energy_gain_max / run.summary.energy_initial, 0.5,
              "%");
  add_gauge_figure(validator, report, run, shallow, "thesis figure 4.15");
  add_depth_maps(report, run, shallow, times, "thesis figure 4.13, right");
  report.figures.push_back(run.frame("view", 0.75, "Frame at 0.75 s."));
}

namespace {

/// A test of the tank without a block that stands out of the water.
void validate_flat_tank(Validator& validator, CaseReport& report, const std::string& scene,
                        const std::string& figure) {
  const std::vector<double> times = {0.46, 1.16, 1.51, 2.22, 2.92};
  report.source = kSource + ", section 2.2.1";
  report.comparison =
      "Water depth on 15 mm cells at the five times of the photographs against shallow water.";
  const ValidationRun run = validator.run({.scene = scene,
                                           .label = "eisph",
                                           .overrides = {kDepthRules, kDepthCells},
                                           .states = times,
                                           .frames = true});
  const ValidationRun shallow = shallow_water_run(validator, scene, 3.0, times);
  judge_depth(report, run, shallow, times);
  add_depth_maps(report, run, shallow, times, figure);
}

}  // namespace

void validate_aureli_test1(Validator& validator, CaseReport& report) {
  report.description =
      "The same tank without an obstacle: EISPH at 10 mm spacing, shallow water on 5 mm cells.";
  validate_flat_tank(validator, report, "aureli_test1", "thesis figure 2.5");
}

void validate_aureli_test2(Validator& validator, CaseReport& report) {
  report.description =
      "The tank with 20 mm of water on its floor, our choice where the source is open: EISPH at 10 mm "
      "spacing, shallow water on 5 mm cells.";
  validate_flat_tank(validator, report, "aureli_test2", "laid out as thesis figure 2.5");
}

void validate_aureli_test3(Validator& validator, CaseReport& report) {
  report.description =
      "The tank with a block 50 mm high off its axis, size and place our choice where the source is open: "
      "EISPH at 10 mm spacing, shallow water on 5 mm cells.";
  validate_flat_tank(validator, report, "aureli_test3", "laid out as thesis figure 2.5");
}

namespace {

/// Transverse velocity at mid depth of a state over x of the reservoir and half of the tank's width.
GridValues transverse_velocity(const Scene& scene, const Snapshot& state) {
  const FluidField field(scene, state);
  GridValues grid;
  grid.spacing = 0.01;
  grid.origin_x = 0.0;
  grid.origin_y = 0.0;
  grid.columns = 101;
  grid.rows = 61;
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const Vec3d point(static_cast<double>(i) * grid.spacing, static_cast<double>(j) * grid.spacing, 0.05);
      grid.values.push_back(field.is_wet(point) ? field.sample_at(point).velocity.y() : std::nan(""));
    }
  }
  return grid;
}

/// Largest difference of two fields within `reach` of the corner of symmetry plane and upstream wall.
double corner_difference(const GridValues& half, const GridValues& full, double reach) {
  double worst = 0.0;
  for (std::size_t j = 0; j < half.rows; ++j) {
    for (std::size_t i = 0; i < half.columns; ++i) {
      const double x = static_cast<double>(i) * half.spacing;
      const double y = 0.6 - static_cast<double>(j) * half.spacing;
      if (x * x + y * y > reach * reach) continue;
      const double difference = std::abs(half.at(i, j) - full.at(i, j));
      if (!std::isnan(difference)) worst = std::max(worst, difference);
    }
  }
  return worst;
}

void compare_corner(Validator& validator, CaseReport& report) {
  const std::vector<double> times = {0.05, 0.15};
  const auto early = [&](const std::string& scene, const std::string& label) {
    return validator.run({.scene = scene,
                          .label = label,
                          .overrides = {"particles.spacing=0.01", "end_time=0.15"},
                          .states = times});
  };
  const ValidationRun half = early("aureli_test4_half", "corner_half");
  const ValidationRun full = early("aureli_test4_full", "corner_full");
  for (const double time : times) {
    const GridValues in_half = transverse_velocity(half.scene, half.state(time));
    const GridValues in_full = transverse_velocity(full.scene, full.state(time));
    add_at_most(
        report, fmt::format("corner at {:g} s", time), 1000.0 * corner_difference(in_half, in_full, 0.1), 1.0,
        "mm/s",
        "largest difference of the transverse velocity, half against full, within 0.1 m of the corner of "
        "symmetry plane and upstream wall (the thesis's defect)");
    for (const auto& [label, grid] : {std::pair{"half", &in_half}, std::pair{"full", &in_full}}) {
      FieldPlot plot{.title = fmt::format("Transverse velocity, {} domain, t = {:g} s", label, time),
                     .x_label = "x [m]",
                     .y_label = "y [m]",
                     .value_label = "v_y [m/s]",
                     .grid = *grid,
                     .levels = {}};
      plot.value_range = PlotRange{-0.3, 0.3};
      const auto path = validator.figure_path(fmt::format("transverse_{}_{:g}s", label, time));
      write_field_plot(path, plot);
      report.figures.push_back(
          {path,
           fmt::format("Transverse velocity at z = 0.05 m, {} domain, {:g} s (thesis figures 4.20, 4.21).",
                       label, time)});
    }
  }
}

}  // namespace

void validate_aureli_half(Validator& validator, CaseReport& report) {
  const std::vector<double> times = {0.4, 0.75, 1.45, 2.16, 2.86};
  report.source = kSource + ", section 4.2.2";
  report.description =
      "Half of the tank up to its plane of symmetry: EISPH at 5 mm spacing, 576,000 particles, to 2.9 s; the "
      "corner at 10 mm spacing in half and full domain.";
  report.comparison =
      "Transverse velocity in the corner of symmetry plane and upstream wall against the full domain; water "
      "depth against the shallow-water solver.";
  compare_corner(validator, report);
  const ValidationRun run = validator.run({.scene = "aureli_test4_half",
                                           .label = "eisph",
                                           .overrides = {"end_time=2.9", kDepthRules, kDepthCells},
                                           .states = times,
                                           .frames = true});
  const ValidationRun shallow = shallow_water_run(validator, "aureli_test4_half", 2.9, times);
  judge_depth(report, run, shallow, times);
  add_gauge_figure(validator, report, run, shallow, "thesis figure 4.26");
  add_depth_maps(report, run, shallow, times, "thesis figure 4.23, right");
  report.figures.push_back(run.frame("view", 0.75, "Frame at 0.75 s (thesis figure 4.25)."));
}

}  // namespace eisph
