#include "app/commands.hpp"
#include "app/comparison/in_situ_comparison.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress.hpp"
#include "app/run_files.hpp"
#include "app/scene_run.hpp"
#include "core/error.hpp"
#include "io/scene_file.hpp"

#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace eisph {
namespace {

double end_time_of(const Scene& scene, const RunOptions& options) {
  if (!options.until) return scene.end_time;
  if (*options.until > 0.0 && *options.until <= scene.end_time) return *options.until;
  throw InputError(
      fmt::format("--until {}: the time has to be above 0 and at most the scene's end time, {} s",
                  *options.until, scene.end_time));
}

template <class Row>
void print_neighbours(const RunSummary& summary, const Row& row) {
  if (std::isnan(summary.paired_fraction_max)) return;
  row("within 0.6 dx",
      fmt::format("{:.2f} % of the particles at most, {:.2f} % at the end",
                  100.0 * summary.paired_fraction_max, 100.0 * summary.paired_fraction_final));
  row("nearest distance", fmt::format("5th percentile {:.3f} dx at least, {:.3f} dx at the end",
                                      summary.nearest_distance_p5_min, summary.nearest_distance_p5_final));
  row("isolated spray", fmt::format("{} particles at most, {} at the end", summary.isolated_particles_max,
                                    summary.isolated_particles_final));
}

void print_summary(std::ostream& out, const RunSummary& summary, const RunFiles& files) {
  const auto row = [&out](const char* name, const std::string& value) {
    fmt::print(out, "  {:<22}{}\n", name, value);
  };
  fmt::print(out, "{}: {}\n", summary.scene, summary.status == "blown_up" ? "blown up" : summary.status);
  row("simulated time", fmt::format("{:.6g} s in {} steps", summary.simulated_time, summary.steps));
  const bool cells = summary.scheme == "shallow_water";
  row("wall clock", fmt::format("{} stepping", duration_text(summary.wall_time_loop)) +
                        (cells ? std::string()
                               : fmt::format(", {} finding the first pressure",
                                             duration_text(summary.wall_time_initial_pressure))));
  if (cells) {
    row("cells", fmt::format("{}, {} on solids", summary.fluid_particles, summary.object_particles));
  } else {
    row("particles", fmt::format("{} fluid, {} object", summary.fluid_particles, summary.object_particles));
  }
  row("speed",
      fmt::format("{:.3g} million {}-steps/s on {} thread(s)", summary.particle_steps_per_second / 1e6,
                  cells ? "cell" : "particle", summary.threads));
  if (cells) {
    row("volume error", fmt::format("{:.2g}, {:.4g} {} let out", summary.mass_error, summary.outflow_volume,
                                    summary.dimension == 2 ? "m^2" : "m^3"));
  } else {
    row("largest compression", fmt::format("{:.2f} %, 95th percentile {:.2f} %",
                                           100.0 * summary.compression_max, 100.0 * summary.compression_p95));
    print_neighbours(summary, row);
    row("penetrations, lost", fmt::format("{}, {}", summary.penetrations, summary.lost_particles));
  }
  row("peak memory", fmt::format("{:.0f} MB", static_cast<double>(summary.peak_rss_bytes) / 1e6));
  row("output", files.folder.string());
  if (summary.frames_written + summary.frames_dropped == 0) return;
  std::string frames = fmt::format("{} in {}", summary.frames_written, files.frames().string());
  if (summary.frames_dropped > 0) frames += fmt::format(", {} dropped", summary.frames_dropped);
  row("frames", frames);
  if (!summary.frames_drawn_by.empty()) row("drawn by", summary.frames_drawn_by);
}

}  // namespace

int run_command(const RunOptions& options, std::ostream& out, std::ostream& progress_out) {
  const InterruptWatcher interrupt;
  Scene scene = load_scene(options.scene, options.overrides);
  const double end_time = end_time_of(scene, options);
  const ContextKind context = context_kind(options.context);
  const RunFiles files{options.out.value_or(std::filesystem::path("out") / scene.name)};
  check_run_folder(files, scene.name);
  InSituComparison comparison(scene, files.folder / "comparison");
  ProgressReporter progress(progress_out, progress_style_of_terminal(options.quiet), terminal_width());
  const RunSummary summary =
      run_scene(scene, files,
                {.end_time = end_time,
                 .frames = options.frames,
                 .context = context,
                 .observer = {},
                 .compare = comparison.observer()},
                options.threads, progress, [&interrupt] { return interrupt.requested(); });
  comparison.finish();
  if (!options.quiet) {
    print_summary(out, summary, files);
    if (comparison.compared() > 0) {
      fmt::print(out, "  {:<22}{} times, {}\n", "comparison", comparison.compared(),
                 comparison.report().string());
    }
  }
  if (summary.status == "blown_up") throw BlowUpError(summary.message);
  return summary.status == "interrupted" ? kInterrupted : kSuccess;
}

}  // namespace eisph
