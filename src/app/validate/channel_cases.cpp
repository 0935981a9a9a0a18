// Dam breaks in channels with an exact solution in shallow water: Ritter, Stoker.

#include "app/validate/cases.hpp"
#include "app/validate/sampling.hpp"
#include "compare/convergence.hpp"
#include "compare/plot.hpp"
#include "compare/ritter.hpp"
#include "compare/stoker.hpp"

#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace eisph {

namespace {

using Profile = std::function<double(double x, double t)>;

/// An exact profile at the places of another curve.
Curve exact_profile(const Curve& places, double time, const Profile& depth) {
  Curve exact;
  for (const double x : places.x) exact.add(x, depth(x, time));
  return exact;
}

Plot profile_plot(const std::string& title, double time) {
  return {.title = fmt::format("{}, t = {:g} s", title, time),
          .x_label = "x [m]",
          .y_label = "depth [m]",
          .series = {}};
}

}  // namespace

namespace {

constexpr double kBoxDepth = 0.15;
constexpr double kBoxLength = 0.15;
constexpr double kBoxMiddle = 0.075;

/// Speed of a front by differences over `window`, s.
Curve front_speed(const Curve& front, double window) {
  Curve speed;
  const auto count = static_cast<int>(front.x.back() / (0.5 * window)) - 1;
  for (int k = 1; k <= count; ++k) {
    const double t = 0.5 * window * k;
    speed.add(t, (value_at(front, t + 0.5 * window) - value_at(front, t - 0.5 * window)) / window);
  }
  return speed;
}

void add_front_figures(Validator& validator, CaseReport& report, const Curve& front,
                       const RitterSolution& ritter) {
  const double end = front.x.back();
  Curve exact_speed;
  exact_speed.add(0.0, ritter.front_speed());
  exact_speed.add(end, ritter.front_speed());
  const auto speed_path = validator.figure_path("front_speed");
  write_plot(
      speed_path,
      {.title = "Speed of the front",
       .x_label = "time t [s]",
       .y_label = "speed [m/s]",
       .series = {{.label = "EISPH", .curve = front_speed(front, 0.02)},
                  {.label = "Ritter", .curve = exact_speed, .style = SeriesStyle::Dashed, .colour = 0}},
       .y_range = PlotRange{0.0, 3.0}});
  report.figures.push_back({speed_path, "Speed of the front (thesis figure 4.7)."});

  Curve exact;
  exact.add(0.0, kBoxLength);
  exact.add(end, kBoxLength + ritter.front(end));
  const auto path = validator.figure_path("front");
  write_plot(path,
             {.title = "Position of the front",
              .x_label = "time t [s]",
              .y_label = "x [m]",
              .series = {{.label = "EISPH", .curve = front},
                         {.label = "Ritter", .curve = exact, .style = SeriesStyle::Dashed, .colour = 0}}});
  report.figures.push_back({path, "Position of the front (thesis figure 4.8)."});
}

/// Profiles (thesis figures 4.9, 4.10) and the depth at the dam (4.11).
void add_depth_figures(Validator& validator, CaseReport& report, const ValidationRun& run,
                       const RitterSolution& ritter) {
  const auto depth = [&](double x, double t) { return ritter.depth(x - kBoxLength, t); };
  std::vector<Plot> plots;
  Plot evolution{
      .title = "Evolution of the profile", .x_label = "x [m]", .y_label = "depth [m]", .series = {}};
  for (const double time : {0.01, 0.1, 0.2, 0.3}) {
    const Curve profile = surface_profile(run.scene, run.state(time), {0.0, 0.9, kBoxMiddle});
    const Curve exact = exact_profile(profile, time, depth);
    Plot plot = profile_plot("Profile", time);
    plot.series.push_back({.label = "EISPH", .curve = profile});
    plot.series.push_back({.label = "Ritter", .curve = exact, .style = SeriesStyle::Dashed, .colour = 0});
    const int colour = static_cast<int>(evolution.series.size() / 2) + 1;
    evolution.series.push_back(
        {.label = fmt::format("EISPH, {:g} s", time), .curve = profile, .colour = colour});
    evolution.series.push_back({.label = fmt::format("Ritter, {:g} s", time),
                                .curve = exact,
                                .style = SeriesStyle::Dashed,
                                .colour = colour});
    if (time < 0.3) plots.push_back(std::move(plot));
  }
  const auto path = validator.figure_path("profiles");
  write_plots(path, "Wave profile", plots, 1);
  report.figures.push_back({path, "Profiles at three times (thesis figure 4.9)."});
  const auto evolution_path = validator.figure_path("evolution");
  write_plot(evolution_path, evolution);
  report.figures.push_back({evolution_path, "Evolution of the profile (thesis figure 4.10)."});

  const Curve at_dam = run.table("gauge_dam").curve("time", "surface");
  Curve exact;
  exact.add(0.0, ritter.depth_at_dam());
  exact.add(run.scene.end_time, ritter.depth_at_dam());
  const auto dam_path = validator.figure_path("depth_at_dam");
  write_plot(dam_path, {.title = "Depth at the dam",
                        .x_label = "time t [s]",
                        .y_label = "depth [m]",
                        .series = {{.label = "EISPH", .curve = at_dam},
                                   {.label = "Ritter: 4/9 of the first depth",
                                    .curve = exact,
                                    .style = SeriesStyle::Dashed,
                                    .colour = 0}},
                        .y_range = PlotRange{0.0, kBoxDepth}});
  report.figures.push_back({dam_path, "Depth at the dam (thesis figure 4.11)."});
}

}  // namespace

void validate_ritter_box(Validator& validator, CaseReport& report) {
  report.source = "Ritter (1892); De Castro (2019), section 4.1.2";
  report.description =
      "Water 0.15 m deep, long and wide in a channel, 27,000 particles 5 mm apart, free slip.";
  report.comparison =
      "Speed of the front against the prototype (2.23 to 2.25 m/s), the thesis (2.25) and Ritter (2.43 in an "
      "endless reservoir).";
  const std::vector<double> times = {0.01, 0.1, 0.2, 0.3};
  const ValidationRun run = validator.run({.scene = "ritter", .states = times, .frames = true});
  const RitterSolution ritter(kBoxDepth);
  const Curve front = run.table("front_front").curve("time", "bulk_front");
  add_within(report, "late speed of the front", mean_slope(front, 0.4, 0.5), 2.23, ritter.front_speed(),
             "m/s", "from 0.4 to 0.5 s");
  add_front_figures(validator, report, front, ritter);
  add_depth_figures(validator, report, run, ritter);
  report.figures.push_back(run.frame("front", 0.2, "Frame at 0.2 s."));
}

namespace {

constexpr double kChannelDepth = 0.1;
constexpr double kDam = 1.5;
const std::vector<double> kProfileTimes = {0.2, 0.4, 0.6, 0.8};

/// Relative L2 of a profile.
double profile_error(const ValidationRun& run, double time, const Section& section, const Profile& depth) {
  const Curve profile = surface_profile(run.scene, run.state(time), section);
  return curve_difference(profile, exact_profile(profile, time, depth)).relative_l2;
}

void add_profiles(Validator& validator, CaseReport& report, const ValidationRun& run,
                  const ValidationRun& shallow, const Section& section, const std::string& theory,
                  const Profile& depth) {
  std::vector<Plot> plots;
  for (const double time : kProfileTimes) {
    Plot plot = profile_plot("Profile", time);
    const Curve profile = surface_profile(run.scene, run.state(time), section);
    plot.series.push_back({.label = "EISPH", .curve = profile});
    plot.series.push_back({.label = "shallow-water solver",
                           .curve = surface_profile(shallow.scene, shallow.state(time), section)});
    plot.series.push_back({.label = theory,
                           .curve = exact_profile(profile, time, depth),
                           .style = SeriesStyle::Dashed,
                           .colour = 0});
    plot.y_range = PlotRange{0.0, 1.15 * kChannelDepth};
    plots.push_back(std::move(plot));
  }
  const auto path = validator.figure_path("profiles");
  write_plots(path, "Wave profiles", plots, 1, {900, 1300});
  report.figures.push_back({path, "Profiles at four times."});
}

/// Error of the profile at the last time, cost and order over three spacings.
void add_profile_convergence(CaseReport& report, const std::vector<ValidationRun>& runs,
                             const Section& section, const Profile& depth) {
  const double time = kProfileTimes.back();
  ReportTable table{
      .caption = fmt::format("Profile at {:g} s against the exact solution in shallow water", time),
      .columns = {"spacing [m]", "particles", "relative L2 [%]", "wall clock [s]",
                  "wall clock per simulated second [s/s]"},
      .rows = {}};
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const ValidationRun& run : runs) {
    spacings.push_back(run.scene.particle_spacing);
    errors.push_back(profile_error(run, time, section, depth));
    table.rows.push_back(
        {fmt::format("{:g}", spacings.back()), fmt::format("{}", run.summary.fluid_particles),
         fmt::format("{:.2f}", 100.0 * errors.back()), fmt::format("{:.2f}", run.summary.wall_time_loop),
         fmt::format("{:.2f}", run.summary.wall_time_loop / run.summary.simulated_time)});
  }
  report.tables.push_back(table);
  if (runs.size() < 3) return;
  add_information(
      report, "order of convergence", observed_order(spacings, errors).least_squares, "-",
      "towards shallow water, which leaves out vertical acceleration: not expected to go on for ever");
}

std::vector<ValidationRun> channel_runs(Validator& validator, const std::string& scene,
                                        const std::vector<double>& spacings) {
  std::vector<ValidationRun> runs;
  runs.reserve(spacings.size());
  for (const double spacing : spacings) {
    runs.push_back(validator.run({.scene = scene,
                                  .label = fmt::format("dx_{:.0f}um", 1e6 * spacing),
                                  .overrides = {fmt::format("particles.spacing={}", spacing)},
                                  .states = kProfileTimes}));
  }
  return runs;
}

ValidationRun shallow_run(Validator& validator, const std::string& scene) {
  return validator.run({.scene = scene,
                        .label = "shallow_water",
                        .overrides = {"scheme.name=shallow_water", "shallow_water.cell_size=0.005",
                                      "shallow_water.manning=0.0"},
                        .states = kProfileTimes});
}

}  // namespace

void validate_ritter_long(Validator& validator, CaseReport& report) {
  report.source = "Ritter (1892)";
  report.description =
      "Water 0.1 m deep, 1.5 m long, in a channel of 3.3 m, 2D: until 0.8 s neither end is felt. Also by the "
      "shallow-water solver on 5 mm cells without friction.";
  report.comparison = "Free surface along the channel against Ritter's parabola, relative L2.";
  const RitterSolution ritter(kChannelDepth);
  const Profile depth = [&](double x, double t) { return ritter.depth(x - kDam, t); };
  const Section section{0.0, 3.3, 0.0};
  const std::vector<ValidationRun> runs = channel_runs(
      validator, "ritter_long", validator.pick<std::vector<double>>({0.01, 0.005, 0.0025}, {0.01, 0.005}));
  const ValidationRun shallow = shallow_run(validator, "ritter_long");
  const ValidationRun& run = runs.back();
  add_at_most(report, "profile", 100.0 * profile_error(run, 0.8, section, depth), 5.0, "%",
              fmt::format("relative L2 at 0.8 s, spacing {:g} mm", 1000.0 * run.scene.particle_spacing));
  add_at_most(report, "profile, shallow-water solver", 100.0 * profile_error(shallow, 0.8, section, depth),
              1.0, "%", "relative L2 at 0.8 s");
  const Curve at_dam = run.table("gauge_dam").curve("time", "surface");
  add_within(report, "depth at the dam", 100.0 * (mean_value(at_dam, 0.5, 0.8) / ritter.depth_at_dam() - 1.0),
             -5.0, 5.0, "%", "mean from 0.5 to 0.8 s against 4/9 of the first depth");
  const Curve front = run.table("front_front").curve("time", "bulk_front");
  // The tip of Ritter's parabola is thinner than half a spacing over the last 3 t sqrt(g dx / 2).
  const double unresolved = 3.0 * std::sqrt(9.81 * 0.5 * run.scene.particle_spacing) / ritter.front_speed();
  add_within(report, "speed of the front", mean_slope(front, 0.5, 0.8) / ritter.front_speed(),
             1.0 - unresolved, 1.0, "of 2 sqrt(g h0)",
             "from 0.5 to 0.8 s; not below that of the depth dx / 2 in Ritter's profile");
  const Curve discharge = run.table("discharge_dam_section").curve("time", "discharge");
  const double exact = 8.0 / 27.0 * kChannelDepth * ritter.celerity();
  add_within(report, "discharge at the dam", 100.0 * (mean_value(discharge, 0.5, 0.8) / exact - 1.0), -5.0,
             5.0, "%", "mean from 0.5 to 0.8 s against 8/27 h0 c0");
  add_profile_convergence(report, runs, section, depth);
  add_profiles(validator, report, run, shallow, section, "Ritter", depth);
}

void validate_stoker(Validator& validator, CaseReport& report) {
  constexpr double kDownstream = 0.02;
  report.source = "Stoker (1957), Water Waves, section 10.8";
  report.description =
      "Water 0.1 m deep behind a dam, 0.02 m downstream, 2D: until 0.8 s neither end is felt. Also by the "
      "shallow-water solver on 5 mm cells without friction.";
  report.comparison = "Free surface against Stoker's solution: plateau and bore.";
  const StokerSolution stoker(kChannelDepth, kDownstream);
  const Profile depth = [&](double x, double t) { return stoker.depth(x - kDam, t); };
  const Section section{0.0, 3.0, 0.0};
  const std::vector<ValidationRun> runs = channel_runs(
      validator, "stoker", validator.pick<std::vector<double>>({0.005, 0.0025, 0.00125}, {0.005, 0.0025}));
  const ValidationRun shallow = shallow_run(validator, "stoker");
  const ValidationRun& run = runs.back();

  // The farthest water above half the height of the bore, averaged over one depth of the reservoir: that
  // leaves a step where it is and takes out the spray ahead of it and the pockets of its breaking.
  const double middle_height = 0.5 * (stoker.middle_depth() + kDownstream);
  for (const double time : {0.6, 0.8}) {
    const Curve profile = surface_profile(run.scene, run.state(time), section);
    const double bore = last_above(moving_average(profile, kChannelDepth), middle_height) - kDam;
    add_within(report, fmt::format("way of the bore at {:g} s", time),
               100.0 * (bore / stoker.bore(time) - 1.0), -5.0, 5.0, "%",
               fmt::format("against {:.3f} m, at {:.3f} m/s", stoker.bore(time), stoker.bore_speed()));
  }
  const Curve last = surface_profile(run.scene, run.state(0.8), section);
  const double first = kDam + stoker.middle_begin(0.8);
  const double end = kDam + stoker.bore(0.8);
  const double plateau = mean_value(last, first + 0.2 * (end - first), end - 0.2 * (end - first));
  add_within(report, "depth of the plateau", 100.0 * (plateau / stoker.middle_depth() - 1.0), -5.0, 5.0, "%",
             "mean over the middle 60 % at 0.8 s");
  add_information(report, "profile", 100.0 * profile_error(run, 0.8, section, depth), "%",
                  "relative L2 at 0.8 s; the short waves behind the bore count as error");
  add_at_most(report, "profile, shallow-water solver", 100.0 * profile_error(shallow, 0.8, section, depth),
              2.0, "%", "relative L2 at 0.8 s");
  add_profile_convergence(report, runs, section, depth);
  add_profiles(validator, report, run, shallow, section, "Stoker", depth);
}

}  // namespace eisph
