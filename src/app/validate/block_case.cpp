// A block in the way of a dam break against another program: OpenFOAM's interFoam.

#include "app/validate/cases.hpp"
#include "app/validate/sampling.hpp"
#include "compare/plot.hpp"
#include "compare/reference_table.hpp"
#include "probe/depth_grid.hpp"
#include "probe/fluid_field.hpp"
#include "probe/pressure_sensor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr std::size_t kRows = 4;     ///< of squares on the block's front, from its foot
constexpr std::size_t kColumns = 3;  ///< from the plane of symmetry
/// rho g H / 10, Pa, on the lowest row: the wave is there.
constexpr double kArrival = 0.1 * 1000.0 * 9.81 * 0.4;
/// Impulses are taken from the arrival on: over the blow, and until the water has climbed past the top row.
constexpr double kBlow = 0.1;    ///< s
constexpr double kWindow = 0.2;  ///< s
constexpr double kLimit = 20.0;  ///< %, of the impulses
constexpr double kLastTime = 0.7;
constexpr double kFront = 1.2;  ///< x of the block's front, m
constexpr double kBack = 1.36;
constexpr double kSide = 0.12;
constexpr double kTop = 0.16;
constexpr double kReservoir = 0.6;
/// How far from the front the highest water is looked for, m.
constexpr double kRunUpReach = 0.1;
const std::vector<double> kDepthTimes = {0.3, 0.4, 0.5, 0.6, 0.7};
const std::vector<double> kStates = {0.28, 0.3, 0.32, 0.34, 0.36, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7};

/// What stands against the front of the block in one program.
struct FrontRecords {
  std::array<Curve, kRows> pressure;   ///< Pa, means over the rows
  std::array<Curve, kRows> indicated;  ///< Pa, the same as slow sensors tell it
  Curve force;                         ///< N along x, on the half of the block

  [[nodiscard]] double arrival() const { return first_rise_to(pressure[0], kArrival); }
  [[nodiscard]] double impulse(std::size_t row, double window) const {
    return mean_value(pressure[row], arrival(), arrival() + window) * window;
  }
};

/// Mean of curves over the same x.
Curve mean_of(const std::vector<Curve>& curves) {
  Curve mean = curves.front();
  for (std::size_t k = 0; k < mean.size(); ++k) {
    double sum = 0.0;
    for (const Curve& curve : curves) sum += curve.y[k];
    mean.y[k] = sum / static_cast<double>(curves.size());
  }
  return mean;
}

FrontRecords records_of(const ValidationRun& run) {
  FrontRecords records;
  for (std::size_t row = 0; row < kRows; ++row) {
    std::vector<Curve> pressure;
    std::vector<Curve> indicated;
    for (std::size_t column = 0; column < kColumns; ++column) {
      const NumberTable table = run.table(fmt::format("pressure_sensor_P{}_{}", row + 1, column + 1));
      pressure.push_back(table.curve("time", "pressure"));
      indicated.push_back(table.curve("time", "indicated"));
    }
    records.pressure[row] = mean_of(pressure);
    records.indicated[row] = mean_of(indicated);
  }
  records.force = run.table("force_block").curve("time", "force_x");
  return records;
}

/// Means over runs that record at the same times.
FrontRecords mean_of(const std::vector<FrontRecords>& runs) {
  const auto mean = [&](const auto& curve_of) {
    std::vector<Curve> curves;
    curves.reserve(runs.size());
    for (const FrontRecords& run : runs) curves.push_back(curve_of(run));
    return mean_of(curves);
  };
  FrontRecords records;
  for (std::size_t row = 0; row < kRows; ++row) {
    records.pressure[row] = mean([&](const FrontRecords& run) { return run.pressure[row]; });
    records.indicated[row] = mean([&](const FrontRecords& run) { return run.indicated[row]; });
  }
  records.force = mean([](const FrontRecords& run) { return run.force; });
  return records;
}

/// The reference's pressures, and what the sensors of the run would tell of them.
FrontRecords records_of(const ReferenceTable& table, double response_time) {
  FrontRecords records;
  for (std::size_t row = 0; row < kRows; ++row) {
    std::vector<Curve> pressure;
    for (std::size_t column = 0; column < kColumns; ++column) {
      pressure.push_back(table.curve("time", fmt::format("p{}_{}", row + 1, column + 1)));
    }
    records.pressure[row] = mean_of(pressure);
    SensorResponse response(response_time);
    const Curve& mean = records.pressure[row];
    for (std::size_t k = 0; k < mean.size(); ++k) {
      records.indicated[row].add(mean.x[k], response.follow(mean.x[k], mean.y[k]));
    }
  }
  records.force = table.curve("time", "force_x");
  return records;
}

double deviation(double value, double reference) { return 100.0 * (value / reference - 1.0); }

void judge_pressures(CaseReport& report, const FrontRecords& ours, const FrontRecords& theirs,
                     double response_time) {
  add_within(report, "arrival", 1000.0 * (ours.arrival() - theirs.arrival()), -10.0, 10.0, "ms",
             fmt::format("when the lowest row passes a tenth of rho g H, against {:.1f} ms",
                         1000.0 * theirs.arrival()));
  ReportTable table{.caption = "Pressure on the rows of the block's front, EISPH / interFoam",
                    .columns = {"height [mm]", "impulse of 0.1 s [Pa s]", "impulse of 0.2 s [Pa s]",
                                "peak [kPa]", fmt::format("peak, {:g} ms sensor [kPa]", 1e3 * response_time)},
                    .rows = {}};
  for (std::size_t row = 0; row < kRows; ++row) {
    const std::string heights = fmt::format("{} to {} mm", 40 * row, 40 * (row + 1));
    const double blow = ours.impulse(row, kBlow);
    const double all = ours.impulse(row, kWindow);
    add_within(report, "impulse, " + heights, deviation(all, theirs.impulse(row, kWindow)), -kLimit, kLimit,
               "%",
               fmt::format("of the first {:g} s from the arrival on, mean over the width; interFoam {:.0f} "
                           "Pa s",
                           kWindow, theirs.impulse(row, kWindow)));
    add_information(report, "impulse of the blow, " + heights, deviation(blow, theirs.impulse(row, kBlow)),
                    "%", fmt::format("of the first {:g} s", kBlow));
    const auto kilopascals = [](const Curve& curve) { return 1e-3 * highest_point(curve).y; };
    table.rows.push_back(
        {heights, fmt::format("{:.0f} / {:.0f}", blow, theirs.impulse(row, kBlow)),
         fmt::format("{:.0f} / {:.0f}", all, theirs.impulse(row, kWindow)),
         fmt::format("{:.1f} / {:.1f}", kilopascals(ours.pressure[row]), kilopascals(theirs.pressure[row])),
         fmt::format("{:.1f} / {:.1f}", kilopascals(ours.indicated[row]),
                     kilopascals(theirs.indicated[row]))});
  }
  report.tables.push_back(table);
  add_information(report, "peak at the foot",
                  deviation(highest_point(ours.indicated[0]).y, highest_point(theirs.indicated[0]).y), "%",
                  fmt::format("by sensors of a response time of {:g} ms", 1e3 * response_time));
  const auto push = [](const FrontRecords& records) {
    return mean_value(records.force, records.arrival(), records.arrival() + kWindow);
  };
  add_information(report, "force on the block", deviation(push(ours), push(theirs)), "%",
                  fmt::format("along x, mean over the same time; interFoam {:.1f} N", push(theirs)));
}

void add_pressure_figure(Validator& validator, CaseReport& report, const FrontRecords& ours,
                         const FrontRecords& theirs) {
  std::vector<Plot> plots;
  for (std::size_t row = kRows; row-- > 0;) {
    Plot plot{.title = fmt::format("{} to {} mm", 40 * row, 40 * (row + 1)),
              .x_label = "time t [s]",
              .y_label = "pressure [Pa]",
              .series = {{.label = "EISPH", .curve = ours.pressure[row]},
                         {.label = "EISPH, slow sensor", .curve = ours.indicated[row]},
                         {.label = "interFoam", .curve = theirs.pressure[row], .colour = 0}}};
    plot.x_range = PlotRange{0.25, kLastTime};
    plot.y_range = PlotRange{0.0, 2.0 * highest_point(theirs.pressure[row]).y};
    plots.push_back(std::move(plot));
  }
  const auto path = validator.figure_path("pressures");
  write_plots(path, "Pressure on the front of the block", plots, 2, {1100, 850});
  report.figures.push_back({path, "Pressure on the front of the block, means over its width."});
}

/// Height (m) of the highest water within kRunUpReach of the front and across the block, half a spacing above
/// the highest particle at which the water fraction is at least one half: spray is not water here, nor is it
/// on the cells of the reference.
double run_up(const Scene& scene, const Snapshot& state) {
  const FluidField field(scene, state);
  std::vector<Vec3d> near;
  for (const Vec3f& at : state.position) {
    if (at.x() >= kFront - kRunUpReach && at.x() <= kFront && at.y() <= kSide)
      near.emplace_back(at.cast<double>());
  }
  std::sort(near.begin(), near.end(), [](const Vec3d& a, const Vec3d& b) { return a.z() > b.z(); });
  const auto highest =
      std::find_if(near.begin(), near.end(), [&](const Vec3d& point) { return field.is_wet(point); });
  return highest == near.end() ? 0.0 : highest->z() + 0.5 * state.particle_spacing;
}

void judge_levels(Validator& validator, CaseReport& report, const ValidationRun& run) {
  const ReferenceTable table = reference_table("block_impact_level");
  std::vector<Plot> plots;
  const auto add_plot = [&](const std::string& title, const Curve& ours, const Curve& theirs) {
    plots.push_back({.title = title,
                     .x_label = "time t [s]",
                     .y_label = "height [m]",
                     .series = {{.label = "EISPH", .curve = ours},
                                {.label = "interFoam", .curve = theirs, .colour = 0}}});
    plots.back().x_range = PlotRange{0.25, kLastTime};
  };
  for (const std::string gauge : {"before", "beside", "behind"}) {
    const Curve theirs = restricted(table.curve("time", gauge), kStates.front(), kLastTime);
    const Curve ours = run.table("gauge_" + gauge).curve("time", "surface");
    const CurveDifference difference = curve_difference(ours, theirs);
    add_information(report, "level " + gauge + " the block", 1000.0 * difference.rms, "mm",
                    fmt::format("RMS from {:g} s on; mean difference {:+.0f} mm", kStates.front(),
                                1000.0 * difference.bias));
    add_plot("Level " + gauge + " the block", ours, theirs);
  }
  Curve ours;
  for (const double time : kStates) ours.add(time, run_up(run.scene, run.state(time)));
  const Curve theirs = restricted(table.curve("time", "run_up"), kStates.front(), kLastTime);
  add_information(
      report, "run-up", 1000.0 * curve_difference(theirs, ours).rms, "mm",
      fmt::format("RMS of the highest water within {:g} mm of the front, where the water fraction is "
                  "one half; highest {:.0f} mm against {:.0f}",
                  1000.0 * kRunUpReach, 1000.0 * highest_point(ours).y, 1000.0 * highest_point(theirs).y));
  add_plot("Highest water in front of the block", ours, theirs);
  const auto path = validator.figure_path("levels");
  write_plots(path, "Water levels", plots, 2, {1100, 850});
  report.figures.push_back({path, "Levels before, beside and behind the block, and run-up."});
}

/// Depth on the cells of the reference downstream of the reservoir; on the block above its top.
DepthDifference depth_difference(const ValidationRun& run, DepthRule rule) {
  constexpr double kDry = 0.005;  // m
  const ReferenceTable table = reference_table("block_impact_depth");
  Scene ruled = run.scene;
  ruled.output.depth_rule = rule;
  const DepthGridBuilder builder(ruled);
  DepthDifference difference(kDry);
  for (const double time : kDepthTimes) {
    const DepthGrid grid = builder.build(run.state(time));
    const std::vector<double>& theirs = table.column(fmt::format("depth_{:.0f}ms", 1000.0 * time));
    for (std::size_t k = 0; k < table.rows(); ++k) {
      const double x = table.column("x")[k];
      const double y = table.column("y")[k];
      if (x < kReservoir) continue;
      double ours = grid.at(static_cast<std::size_t>((x - grid.origin_x) / grid.cell_size),
                            static_cast<std::size_t>((y - grid.origin_y) / grid.cell_size));
      if (x > kFront && x < kBack && y < kSide) ours = std::max(ours - kTop, 0.0);
      difference.add(ours, theirs[k]);
    }
  }
  return difference;
}

/// Depths by both rules; `coarse` is a run of twice the spacing.
void judge_depths(CaseReport& report, const ValidationRun& run, const ValidationRun& coarse) {
  const DepthDifference difference = depth_difference(run, DepthRule::Surface);
  add_information(report, "depth", 1000.0 * difference.rms(), "mm",
                  fmt::format("RMS over cells of 40 mm downstream of the reservoir at {} times; mean "
                              "difference {:+.1f} mm",
                              kDepthTimes.size(), 1000.0 * difference.bias()));
  add_information(report, "wetted area", 100.0 * difference.wetted_overlap(), "%",
                  "wetted by 5 mm in both over wetted in either");
  const double highest = depth_difference(run, DepthRule::HighestParticle).rms();
  const double coarse_highest = depth_difference(coarse, DepthRule::HighestParticle).rms();
  add_at_most(report, "depth by the highest particle, over that at twice the spacing",
              highest / coarse_highest, 1.0, "-",
              fmt::format("RMS {:.1f} mm against {:.1f} mm; by the free surface {:.1f} and {:.1f} mm",
                          1000.0 * highest, 1000.0 * coarse_highest, 1000.0 * difference.rms(),
                          1000.0 * depth_difference(coarse, DepthRule::Surface).rms()));
}

/// Free surface in the plane of symmetry, both programs in one picture.
void compare_sections(Validator& validator, CaseReport& report, const ValidationRun& run) {
  constexpr double kHeight = 0.6;
  const ReferenceTable table = reference_table("block_impact_section");
  const Section section{0.8, 1.8, 0.0};
  std::vector<Plot> plots;
  for (const double time : {0.3, 0.4, 0.5, 0.6}) {
    std::vector<PlanePoint> theirs;
    Plot plot{.title = fmt::format("t = {:g} s", time), .x_label = "x [m]", .y_label = "z [m]", .series = {}};
    PlotSeries reference{.label = "interFoam", .style = SeriesStyle::Points, .colour = 0};
    for (std::size_t k = 0; k < table.rows(); ++k) {
      if (std::abs(table.column("time")[k] - time) > 1e-6) continue;
      theirs.push_back({table.column("x")[k], table.column("z")[k]});
      reference.curve.add(theirs.back().x, theirs.back().z);
    }
    const Snapshot& state = run.state(time);
    const std::vector<PlanePoint> ours = surface_points(run.scene, state, section, kHeight);
    PlotSeries own{.label = "EISPH", .style = SeriesStyle::Points, .colour = 1};
    for (const PlanePoint& point : ours) own.curve.add(point.x, point.z);
    plot.series = {std::move(own), std::move(reference)};
    plot.x_range = PlotRange{section.first, section.last};
    plot.y_range = PlotRange{0.0, kHeight};
    plots.push_back(std::move(plot));
    const ProfileDifference difference = profile_difference(theirs, {}, ours);
    add_information(report, fmt::format("free surface at {:g} s", time), 1000.0 * difference.nearest_rms,
                    "mm",
                    "RMS distance of interFoam's surface in the plane of symmetry to the nearest of EISPH's");
  }
  const auto path = validator.figure_path("section");
  write_plots(path, "Free surface in the plane of symmetry", plots, 2, {1200, 900});
  report.figures.push_back({path, "Where the water fraction is one half in the plane of symmetry."});
}

/// As many records as there are steps, so that none of a blow is missed and steps are not shortened.
std::vector<std::string> overrides(double spacing) {
  std::vector<std::string> keys = {fmt::format("particles.spacing={}", spacing)};
  const std::string interval = fmt::format(".interval={}", 0.05 * spacing);
  for (std::size_t row = 1; row <= kRows; ++row) {
    for (std::size_t column = 1; column <= kColumns; ++column) {
      keys.push_back(fmt::format("pressure_sensor.P{}_{}{}", row, column, interval));
    }
  }
  keys.push_back("force.block" + interval);
  return keys;
}

}  // namespace

void validate_block_impact(Validator& validator, CaseReport& report) {
  const ReferenceTable reference = reference_table("block_impact_pressure");
  const double spacing = validator.pick(0.01, 0.02);
  report.source = reference.citation;
  report.notes = reference.notes;
  report.description = fmt::format(
      "A column of 0.6 x 0.4 m in a tank 0.64 m wide, a block 0.24 m wide, 0.16 m high and long 0.6 m from "
      "it, half of it up to the plane of symmetry, free slip, {:g} mm spacing.",
      1000.0 * spacing);
  report.comparison =
      "Pressures on 12 squares of 40 mm on the block's front, levels, depths and the free surface in the "
      "plane "
      "of symmetry against a volume-of-fluid solver with air.";
  const ValidationRun run = validator.run(
      {.scene = "block_impact", .overrides = overrides(spacing), .states = kStates, .frames = true});
  const double response_time = run.scene.pressure_sensors.front().response_time;
  // Blows scatter by tens of per cent from run to run: pressures are means over three that start alike but
  // for displacements of a hundredth of a spacing.
  std::vector<FrontRecords> runs = {records_of(run)};
  for (const int seed : {1, 2}) {
    std::vector<std::string> jittered = overrides(spacing);
    jittered.emplace_back("particles.jitter=0.01");
    jittered.push_back(fmt::format("particles.jitter_seed={}", seed));
    runs.push_back(records_of(validator.run({.scene = "block_impact",
                                             .label = fmt::format("jitter_{}", seed),
                                             .overrides = jittered,
                                             .states = {}})));
  }
  const FrontRecords ours = mean_of(runs);
  const FrontRecords theirs = records_of(reference, response_time);
  judge_pressures(report, ours, theirs, response_time);
  judge_levels(validator, report, run);
  const ValidationRun coarse =
      validator.run({.scene = "block_impact",
                     .label = "coarse",
                     .overrides = {fmt::format("particles.spacing={}", 2.0 * spacing)},
                     .states = kDepthTimes});
  judge_depths(report, run, coarse);
  add_pressure_figure(validator, report, ours, theirs);
  compare_sections(validator, report, run);
  for (const double time : {0.3, 0.4, 0.5}) {
    report.figures.push_back(
        run.frame("section", time, fmt::format("Pressure seen from the plane of symmetry, {:g} s.", time)));
  }
  report.figures.push_back(run.frame("view", 0.4, "Speed, 0.4 s."));
}

}  // namespace eisph
