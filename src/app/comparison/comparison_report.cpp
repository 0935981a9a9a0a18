#include "app/comparison/comparison_report.hpp"

#include "app/build_info.hpp"
#include "io/host.hpp"
#include "io/run_json.hpp"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kMillimetre = 0.001;
constexpr double kWhite = 255.0;

std::string mm(double metres) {
  return std::isnan(metres) ? "none" : fmt::format("{:.2f}", metres / kMillimetre);
}
std::string mm3(double metres) { return fmt::format("{:.3f}", metres / kMillimetre); }
std::string percent(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

/// De Castro (2019), tables 2 and 4, m: against photographs of the experiment.
std::vector<NamedStatistics> thesis_statistics() {
  DeviationStatistics whole;
  whole.maximum = 0.11116;
  whole.minimum = -0.13000;
  whole.mean = -0.00215;
  whole.median = -0.00168;
  whole.percentile_15 = -0.01842;
  whole.percentile_85 = 0.00840;
  DeviationStatistics half;
  half.maximum = 0.10861;
  half.minimum = -0.10767;
  half.mean = 0.00058;
  half.median = -0.00263;
  half.percentile_15 = -0.00489;
  half.percentile_85 = 0.00237;
  for (DeviationStatistics* one : {&whole, &half})
    one->rms = one->correlation = one->wetted_overlap = std::nan("");
  whole.points = 47200;
  half.points = 188800;
  return {{"thesis, table 2: 144,000 particles, whole tank", whole},
          {"thesis, table 4: 576,000 particles, half tank", half}};
}

PageSection statistics_section(const PhotoComparison& comparison,
                               const std::vector<NamedStatistics>& statistics,
                               const ComparisonFigures& figures) {
  const DeviationSettings& settings = comparison.settings().deviation;
  PageSection section{
      .title = "Deviations of water depth", .paragraphs = {}, .tables = {}, .figures = figures.classes};
  section.paragraphs.push_back(fmt::format(
      "Deviation is the simulated minus the photographed depth, cell by cell ({:g} mm cells), all {} times "
      "together. Percentiles are of the ordered deviations. The overlap is the number of cells deeper than "
      "{:g} mm "
      "on both sides over that on either side.",
      comparison.times().front().simulation.front().grid.cell_size / kMillimetre, comparison.times().size(),
      settings.dry_depth / kMillimetre));
  std::vector<NamedStatistics> rows = {statistics.front()};
  const std::vector<NamedStatistics> thesis = thesis_statistics();
  rows.insert(rows.end(), thesis.begin(), thesis.end());
  section.tables.push_back(statistics_table("Statistics, beside those of De Castro (2019)", rows));
  section.paragraphs.emplace_back(
      "The thesis compares with photographs of the experiment of Aureli et al. (2008), read at the centres "
      "of "
      "cells, with rims filled by the nearest depth and 10 % more and depths under 5 mm not visible. Its "
      "figures "
      "are comparable with a comparison with those photographs only.");
  section.tables.push_back(statistics_table("What the rules for depth and rims change", statistics));
  return section;
}

PageSection times_section(const PhotoComparison& comparison) {
  ReportTable table{.caption = "Time by time",
                    .columns = {"time [s]", "mean [mm]", "RMS [mm]", "correlation", "overlap", "front [mm]",
                                "front, RMS of rows [mm]", "cells compared", "rims", "not readable"},
                    .rows = {}};
  for (const ComparedTime& time : comparison.times()) {
    const DeviationStatistics s = comparison.statistics_at(time);
    const FrontDistance front = comparison.front_at(time);
    const auto cells = [&](CellState state) { return time.measured.cells[static_cast<std::size_t>(state)]; };
    table.rows.push_back(
        {fmt::format("{:g}", time.time), mm(s.mean), mm(s.rms), fmt::format("{:.3f}", s.correlation),
         percent(s.wetted_overlap), mm(front.foremost), mm(front.rms), fmt::format("{}", s.points),
         fmt::format("{}", cells(CellState::Rim)), fmt::format("{}", cells(CellState::Unreadable))});
  }
  return {.title = "Times",
          .paragraphs =
              {"The front is how much farther in x the foremost wet cell of the simulation is than that of "
               "the photograph, and the RMS of that over the rows of cells that are wet on both sides; "
               "single wet cells "
               "count as drops or noise."},
          .tables = {table},
          .figures = {}};
}

PageSection registration_section(const PhotoComparison& comparison, const Repeatability& repeatability,
                                 const ComparisonFigures& figures) {
  const PhotographSet& set = comparison.photographs();
  const RegistrationSettings& settings = comparison.settings().registration;
  PageSection section{.title = "Registration", .paragraphs = {}, .tables = {}, .figures = {figures.grid}};
  section.paragraphs.push_back(fmt::format(
      "A projective transform takes the floor to the picture{}, with the least squares of the distances of "
      "{} "
      "points in pixels: RMS {:.3f} pixels, {:.3f} mm on the floor. A cell is {:.1f} pixels wide.",
      settings.radial_distortion
          ? fmt::format(", and a radial distortion (k1 = {:.4g})", set.registration.camera.k1())
          : std::string(),
      set.points.size(), set.registration.rms_pixels, set.registration.rms_metres / kMillimetre,
      comparison.times().front().measured.pixels_per_cell));
  if (set.bow) {
    section.paragraphs.push_back(
        fmt::format("The corners were found in the outline of the floor, whose edges depart from straight "
                    "lines by up to {:.2f} "
                    "pixels (but for a twentieth of their points).",
                    *set.bow));
  }
  ReportTable points{.caption = "Reference points",
                     .columns = {"point", "x, y [m]", "pixel", "residual [pixels]", "residual [mm]"},
                     .rows = {}};
  for (std::size_t k = 0; k < set.points.size(); ++k) {
    const ReferencePoint& point = set.points[k];
    points.rows.push_back({point.name, fmt::format("{:g}, {:g}", point.plane.x(), point.plane.y()),
                           fmt::format("{:.2f}, {:.2f}", point.pixel.x(), point.pixel.y()),
                           fmt::format("{:.3f}", set.registration.residual_pixels[k]),
                           mm3(set.registration.residual_metres[k])});
  }
  section.tables.push_back(points);
  if (repeatability.repetitions == 0) return section;
  section.tables.push_back(
      {.caption =
           fmt::format("Standard deviation over {} repetitions, each point off by {:g} pixels (standard "
                       "deviation, both directions), mm",
                       repeatability.repetitions, settings.pick_error),
       .columns = {"", "maximum", "minimum", "mean", "median", "15th percentile", "85th percentile", "RMS",
                   "largest shift of the mean"},
       .rows = {{"this comparison", mm3(repeatability.maximum), mm3(repeatability.minimum),
                 mm3(repeatability.mean), mm3(repeatability.median), mm3(repeatability.percentile_15),
                 mm3(repeatability.percentile_85), mm3(repeatability.rms), mm3(repeatability.mean_shift)},
                {"thesis, table 1: four repetitions by hand", "0.037", "0.000", "0.011", "0.015", "0.013",
                 "0.011", "", ""}}});
  return section;
}

PageSection calibration_section(const PhotoComparison& comparison, const ComparisonFigures& figures) {
  const PhotographSet& set = comparison.photographs();
  const DepthCalibration& calibration = set.calibration;
  PageSection section{.title = "From grey levels to depth", .paragraphs = {}, .tables = {}, .figures = {}};
  if (figures.calibration) section.figures.push_back(*figures.calibration);
  const auto& weights = comparison.settings().grey_weights;
  const std::string colour = set.coloured ? fmt::format(", grey = {:g} red + {:g} green + {:g} blue",
                                                        weights[0], weights[1], weights[2])
                                          : std::string();
  section.paragraphs.push_back(
      fmt::format("Pictures of {} x {} pixels, {} bits{}. {} between {} known depths from {:g} to {:g} mm, "
                  "by a monotone cubic. "
                  "Noise of a pixel: {:.2f} of 255 (standard deviation). Levels up to {:.2f} of 255 beyond "
                  "the ends count as the "
                  "ends; farther ones have no depth.",
                  set.width, set.height, set.bit_depth, colour,
                  calibration.has_pixel_curves() ? "A curve for each pixel" : "One curve for all pixels",
                  calibration.points().size(), calibration.points().front().depth / kMillimetre,
                  calibration.points().back().depth / kMillimetre, kWhite * calibration.noise(),
                  kWhite * calibration.tolerance()));
  if (calibration.unusable() > 0) {
    section.paragraphs.push_back(
        fmt::format("{} pixels are left out: their level does not fall from each depth to the next.",
                    calibration.unusable()));
  }
  ReportTable table{.caption = "Samples beyond the calibration, of those on the floor",
                    .columns = {"time [s]", "taken as an end", "too bright, no depth", "too dark, no depth"},
                    .rows = {}};
  for (const ComparedTime& time : comparison.times()) {
    table.rows.push_back({fmt::format("{:g}", time.time), percent(time.measured.clamped_share),
                          percent(time.measured.bright_share), percent(time.measured.dark_share)});
  }
  section.tables.push_back(table);
  return section;
}

}  // namespace

std::string synthetic_warning() {
  return "The photographs are synthetic: computed from the depth that another model gave, as a camera would "
         "have "
         "seen it. Nothing here is a measurement.";
}

ReportTable statistics_table(const std::string& caption, const std::vector<NamedStatistics>& statistics) {
  ReportTable table{.caption = caption,
                    .columns = {"", "points", "max [mm]", "min [mm]", "mean [mm]", "median [mm]",
                                "15th perc. [mm]", "85th perc. [mm]", "RMS [mm]", "correlation", "overlap"},
                    .rows = {}};
  for (const auto& [name, s] : statistics) {
    table.rows.push_back({name, fmt::format("{}", s.points), mm(s.maximum), mm(s.minimum), mm(s.mean),
                          mm(s.median), mm(s.percentile_15), mm(s.percentile_85),
                          std::isnan(s.rms) ? "not given" : mm(s.rms),
                          std::isnan(s.correlation) ? "not given" : fmt::format("{:.3f}", s.correlation),
                          std::isnan(s.wetted_overlap) ? "not given" : percent(s.wetted_overlap)});
  }
  return table;
}

IllustratedPage comparison_page(const PhotoComparison& comparison, const std::string& run,
                                const std::vector<NamedStatistics>& statistics,
                                const Repeatability& repeatability, const ComparisonFigures& figures) {
  const Comparison& settings = comparison.settings();
  const BuildInfo build = build_info();
  IllustratedPage page;
  page.title = settings.title;
  page.subtitle =
      fmt::format("{}{} · {} · {}", software_name(), build.commit.empty() ? "" : " (" + build.commit + ")",
                  iso_time(std::chrono::system_clock::now()), settings.source_file);
  if (settings.synthetic) page.warning = synthetic_warning();
  page.sections.push_back(statistics_section(comparison, statistics, figures));
  page.sections.front().paragraphs.insert(
      page.sections.front().paragraphs.begin(),
      fmt::format("Simulation: {}. Photographs: {}.", run, settings.experiment));
  page.sections.push_back(times_section(comparison));
  for (const auto& [photograph, pictures] : figures.by_photograph) {
    page.sections.push_back({.title = fmt::format("t = {:g} s", settings.photographs[photograph].time),
                             .paragraphs = {},
                             .tables = {},
                             .figures = pictures});
  }
  page.sections.push_back(registration_section(comparison, repeatability, figures));
  page.sections.push_back(calibration_section(comparison, figures));
  return page;
}

}  // namespace eisph
