#include "app/comparison/comparison_writer.hpp"

#include "app/build_info.hpp"
#include "app/comparison/comparison_report.hpp"
#include "app/comparison/video.hpp"
#include "compare/plot.hpp"
#include "compare/reference_table.hpp"
#include "io/file_io.hpp"
#include "io/vtk_output.hpp"
#include "render/png_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kMillimetre = 0.001;
constexpr double kWhite = 255.0;
constexpr double kSecondsEach = 1.5;  ///< of a picture in a video

/// Grey levels of the photographs over depth, from their calibration.
ColourMap photograph_tones(const DepthCalibration& calibration, double depth) {
  const std::vector<CalibrationPoint>& points = calibration.points();
  ColourMap::Table table{};
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double wanted = depth * static_cast<double>(k) / (ColourMap::kSize - 1);
    std::size_t next = 1;
    while (next + 1 < points.size() && points[next].depth < wanted) ++next;
    const CalibrationPoint& a = points[next - 1];
    const CalibrationPoint& b = points[next];
    const double share = std::clamp((wanted - a.depth) / (b.depth - a.depth), 0.0, 1.0);
    const auto level = static_cast<float>(a.level + share * (b.level - a.level));
    table[k] = {level, level, level};
  }
  return ColourMap(table);
}

/// Names that a comparison gives its files: those of an earlier one are removed.
bool is_own_file(const std::string& name) {
  for (const char* kind :
       {"photograph_and_depth_", "depths_", "overlay_", "deviation_", "halves_", "photograph_depth_"}) {
    if (name.rfind(kind, 0) == 0) return true;
  }
  const std::vector<std::string> others = {"report.html",     "statistics.csv", "classes.csv",
                                           "calibration.csv", "grid.png",       "classes.png",
                                           "calibration.png"};
  return std::find(others.begin(), others.end(), name) != others.end();
}

Curve curve_of(const std::vector<double>& x, const std::vector<double>& y) {
  Curve curve;
  curve.x = x;
  curve.y = y;
  return curve;
}

}  // namespace

ComparisonWriter::ComparisonWriter(const PhotoComparison& comparison, std::filesystem::path folder,
                                   std::string run, std::optional<RunDepths> other)
    : comparison_(comparison), folder_(std::move(folder)), run_(std::move(run)), other_(std::move(other)) {}

void ComparisonWriter::begin() {
  require_gnuplot();
  create_folder(folder_);
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.is_regular_file() && is_own_file(entry.path().filename().string()))
      std::filesystem::remove(entry.path());
  }
}

ComparisonHeading ComparisonWriter::heading(const ComparedTime& time) const {
  const Comparison& settings = comparison_.settings();
  return {settings.title + (settings.synthetic ? " (SYNTHETIC photographs)" : ""),
          fmt::format("t = {:g} s", time.time)};
}

void ComparisonWriter::write_picture(const std::string& kind, const ComparedTime& time, const Image& image,
                                     const std::string& caption) {
  const auto path = folder_ / fmt::format("{}_{:04}.png", kind, time.photograph);
  write_png(path, image,
            {{"Title", comparison_.settings().title},
             {"Time", fmt::format("{:.9g} s", time.time)},
             {"Description", comparison_.settings().synthetic ? synthetic_warning() : caption},
             {"Software", software_name()}});
  pictures_[kind].push_back(path);
  figures_[time.photograph].push_back({path, caption});
}

void ComparisonWriter::write_time(const ComparedTime& time) {
  const Comparison& settings = comparison_.settings();
  const PhotographSet& set = comparison_.photographs();
  if (!painter_) {
    painter_ =
        std::make_unique<ComparisonPainter>(comparison_.scene(), set.floor.area, settings.images.width);
  }
  const double depth = settings.images.depth;
  const double range = settings.images.deviation > 0.0 ? settings.images.deviation : depth / 3.0;
  const ColourMap grey = ColourMap::load("grey_depth");
  const DepthSide simulation{run_, depth_by_rule(time, settings.deviation.depth_rule)};
  const DepthSide measured{comparison_.settings().experiment, time.compared.grid, &time.compared.valid};
  const PhotographSide photograph{
      comparison_.settings().experiment, set.pictures[time.photograph],
      [&set](const Eigen::Vector2d& plane) { return set.registration.camera.pixel_of(plane); }};

  write_picture("photograph_and_depth", time,
                painter_->photograph_and_depth(heading(time), photograph, simulation,
                                               photograph_tones(set.calibration, depth), depth),
                "Photograph, made upright, and simulation in the photograph's grey tones.");
  write_picture("depths", time,
                painter_->depths(heading(time), measured, simulation, ColourMap::load("depth_blue"), depth),
                "Water depth of the photograph and of the simulation on the cells compared.");
  write_picture(
      "overlay", time,
      painter_->overlay(heading(time), simulation, measured, grey, depth, settings.deviation.dry_depth),
      "Simulated depth, under the area that is wet in the photograph.");
  write_picture("deviation", time,
                painter_->deviation(heading(time), simulation, measured, ColourMap::load("blue_red"), range),
                "Deviation: simulated minus photographed depth.");
  if (other_ && other_->has(time.time)) {
    const DepthGrid lower = other_->at(time.time).front().grid;
    const double middle = 0.5 * (comparison_.scene().domain_min.y() + comparison_.scene().domain_max.y());
    write_picture(
        "halves", time,
        painter_->halves(heading(time), simulation, {other_->scene().name, lower}, middle, grey, depth),
        fmt::format("{} above the middle, {} below it.", run_, other_->scene().name));
  }
  DepthGrid saved = time.compared.grid;
  saved.time = time.time;
  write_depth(folder_ / fmt::format("photograph_depth_{:04}.vti", time.photograph), saved);
}

void ComparisonWriter::write_grid_picture() {
  const PhotographSet& set = comparison_.photographs();
  const ComparedTime& time = comparison_.times().front();
  std::vector<PictureMark> marks;
  for (const ReferencePoint& point : set.points) marks.push_back({point.name, point.pixel});
  const PhotographSide photograph{
      comparison_.settings().experiment, set.pictures[time.photograph],
      [&set](const Eigen::Vector2d& plane) { return set.registration.camera.pixel_of(plane); }};
  write_png(folder_ / "grid.png",
            painter_->grid_over_photograph(heading(time), photograph, time.simulation.front().grid, marks),
            {{"Title", comparison_.settings().title}, {"Software", software_name()}});
}

std::vector<ReportFigure> ComparisonWriter::write_plots_of_classes() {
  const auto own = deviation_classes(comparison_.samples(comparison_.variants().front()),
                                     comparison_.settings().deviation.classes);
  write_deviation_classes(folder_ / "classes.csv", own);
  Plot count{
      .title = "Absolute frequency", .x_label = "deviation [mm]", .y_label = "thousand points", .series = {}};
  Plot share{.title = "Relative frequency",
             .x_label = "deviation [mm]",
             .y_label = "share of points [-]",
             .series = {}};
  Plot sum{.title = "Cumulative frequency",
           .x_label = "deviation [mm]",
           .y_label = "share of points up to here [-]",
           .series = {}};
  const auto add = [&](const std::string& label, const std::vector<DeviationClass>& classes,
                       SeriesStyle style) {
    std::vector<double> x;
    std::vector<double> counts;
    std::vector<double> shares;
    std::vector<double> sums;
    for (const DeviationClass& one : classes) {
      x.push_back(one.centre / kMillimetre);
      counts.push_back(1e-3 * static_cast<double>(one.count));
      shares.push_back(one.share);
      sums.push_back(one.cumulative_share);
    }
    count.series.push_back({.label = label, .curve = curve_of(x, counts), .style = style});
    share.series.push_back({.label = label, .curve = curve_of(x, shares), .style = style});
    sum.series.push_back({.label = label, .curve = curve_of(x, sums), .style = style});
  };
  add(comparison_.settings().synthetic ? "this, synthetic" : "this comparison", own, SeriesStyle::Line);
  for (const auto& [name, label] : {std::pair{"thesis_deviation_144k", "thesis, 144,000 particles"},
                                    std::pair{"thesis_deviation_576k", "thesis, 576,000 particles"}}) {
    const ReferenceTable table = reference_table(name);
    std::vector<std::size_t> counts;
    for (const double value : table.column("count")) counts.push_back(static_cast<std::size_t>(value));
    add(label, classes_from_counts(table.column("deviation"), counts), SeriesStyle::LinePoints);
  }
  const auto path = folder_ / "classes.png";
  write_plots(path, comparison_.settings().title, {count, share, sum}, 1, {900, 1150});
  return {
      {path,
       fmt::format(
           "How often deviations occur, in {} equal classes, beside those of the thesis's tables 3 and 5, "
           "which are against photographs of the experiment.",
           own.size())}};
}

ReportFigure ComparisonWriter::write_calibration_plot() {
  const DepthCalibration& calibration = comparison_.photographs().calibration;
  std::vector<double> level;
  std::vector<double> depth;
  std::string table = "level [of 255],depth [m]\n";
  for (const CalibrationPoint& point : calibration.points()) {
    level.push_back(kWhite * point.level);
    depth.push_back(point.depth / kMillimetre);
    table += fmt::format("{:.3f},{:.6g}\n", kWhite * point.level, point.depth);
  }
  write_file_atomically(folder_ / "calibration.csv", table);
  const auto path = folder_ / "calibration.png";
  write_plot(
      path,
      {.title = calibration.has_pixel_curves() ? "Calibration, median of all pixels" : "Calibration",
       .x_label = "grey level [of 255]",
       .y_label = "water depth [mm]",
       .series = {
           {.label = "known depths", .curve = curve_of(level, depth), .style = SeriesStyle::LinePoints}}});
  return {path, "Grey level and water depth."};
}

void ComparisonWriter::write_videos() {
  if (!comparison_.settings().images.video || !has_ffmpeg()) return;
  for (const auto& [kind, pictures] : pictures_)
    write_video(folder_ / (kind + "_video.mp4"), pictures, kSecondsEach);
}

void ComparisonWriter::write_end() {
  if (comparison_.times().empty()) return;
  std::vector<NamedStatistics> statistics;
  for (const DeviationVariant& variant : comparison_.variants())
    statistics.push_back({comparison_.name_of(variant), comparison_.statistics(variant)});
  write_deviation_statistics(folder_ / "statistics.csv", statistics);
  write_grid_picture();
  ComparisonFigures figures{
      .grid = {folder_ / "grid.png", "The cells compared, over a photograph, with the reference points."},
      .calibration = write_calibration_plot(),
      .classes = write_plots_of_classes(),
      .by_photograph = figures_};
  const Repeatability repeatability = comparison_.repeatability();
  write_illustrated_page(report(), comparison_page(comparison_, run_, statistics, repeatability, figures));
  write_videos();
}

}  // namespace eisph
