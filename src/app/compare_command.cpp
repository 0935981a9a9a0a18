#include "app/commands.hpp"
#include "app/comparison/comparison_report.hpp"
#include "app/comparison/comparison_writer.hpp"
#include "app/comparison/photo_comparison.hpp"
#include "app/comparison/run_depths.hpp"
#include "app/comparison/video.hpp"
#include "core/error.hpp"
#include "io/comparison_file.hpp"

#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

namespace eisph {

namespace {

std::filesystem::path run_folder(const Comparison& comparison, const CompareOptions& options) {
  if (options.run) return *options.run;
  if (!comparison.run.empty()) return comparison.run;
  throw InputError(
      fmt::format("{}: run: missing; name the folder of a run there or with --run", comparison.source_file));
}

void check_times(const Comparison& comparison, const RunDepths& run, const std::filesystem::path& folder) {
  for (std::size_t k = 0; k < comparison.photographs.size(); ++k) {
    const double time = comparison.photographs[k].time;
    if (run.has(time)) continue;
    throw InputError(
        fmt::format("{}: photograph.{}.time = {}: {} has no saved state or depth at that time; it has {} s",
                    comparison.source_file, k, time, folder.string(), fmt::join(run.times(), ", ")));
  }
}

void print_result(std::ostream& out, const PhotoComparison& comparison, const ComparisonWriter& writer) {
  const DeviationStatistics s = comparison.statistics(comparison.variants().front());
  const auto mm = [](double metres) { return 1000.0 * metres; };
  if (comparison.settings().synthetic) fmt::print(out, "{}\n", synthetic_warning());
  fmt::print(out, "{}: {} photographs, {} cells, {}\n", comparison.settings().title,
             comparison.times().size(), s.points, comparison.name_of(comparison.variants().front()));
  fmt::print(out, "  registration        RMS {:.3f} pixels, {:.2f} mm\n",
             comparison.photographs().registration.rms_pixels,
             mm(comparison.photographs().registration.rms_metres));
  fmt::print(out, "  deviation           mean {:.2f}, median {:.2f}, RMS {:.2f} mm\n", mm(s.mean),
             mm(s.median), mm(s.rms));
  fmt::print(out, "  15th to 85th perc.  {:.2f} to {:.2f} mm; {:.1f} to {:.1f} mm in all\n",
             mm(s.percentile_15), mm(s.percentile_85), mm(s.minimum), mm(s.maximum));
  fmt::print(out, "  correlation         {:.3f}; wetted overlap {:.1f} %\n", s.correlation,
             100.0 * s.wetted_overlap);
  if (comparison.settings().images.video && !has_ffmpeg())
    fmt::print(out, "  no video            ffmpeg is not installed\n");
  fmt::print(out, "  report              {}\n", writer.report().string());
}

}  // namespace

int compare_command(const CompareOptions& options, std::ostream& out) {
  const Comparison comparison_settings = load_comparison(options.comparison, options.overrides);
  const std::filesystem::path folder = run_folder(comparison_settings, options);
  const RunDepths run(folder, comparison_settings.deviation);
  check_times(comparison_settings, run, folder);
  std::optional<RunDepths> other;
  if (!comparison_settings.other_run.empty())
    other.emplace(comparison_settings.other_run, comparison_settings.deviation);
  PhotoComparison comparison(comparison_settings, run.scene(), run.cell_size());
  ComparisonWriter writer(comparison, options.out.value_or(folder / "comparison"), run.scene().name,
                          std::move(other));
  writer.begin();
  for (std::size_t k = 0; k < comparison_settings.photographs.size(); ++k)
    writer.write_time(comparison.add(k, run.at(comparison_settings.photographs[k].time)));
  writer.write_end();
  if (!options.quiet) print_result(out, comparison, writer);
  return kSuccess;
}

}  // namespace eisph
