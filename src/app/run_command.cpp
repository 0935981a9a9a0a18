#include "app/build_info.hpp"
#include "app/commands.hpp"
#include "app/in_situ_run.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress.hpp"
#include "app/run_files.hpp"
#include "core/error.hpp"
#include "io/file_io.hpp"
#include "io/host.hpp"
#include "io/run_json.hpp"
#include "io/scene_file.hpp"

#include <chrono>
#include <exception>
#include <memory>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>

namespace eisph {
namespace {

double end_time_of(const Scene& scene, const RunOptions& options) {
  if (!options.until) return scene.end_time;
  if (*options.until > 0.0 && *options.until <= scene.end_time) return *options.until;
  throw InputError(
      fmt::format("--until {}: the time has to be above 0 and at most the scene's end time, {} s",
                  *options.until, scene.end_time));
}

std::shared_ptr<spdlog::logger> make_log(const RunFiles& files) {
  auto log = std::make_shared<spdlog::logger>(
      "run", std::make_shared<spdlog::sinks::basic_file_sink_mt>(files.log().string(), true));
  log->set_pattern("%Y-%m-%d %H:%M:%S.%e %l %v");
  log->flush_on(spdlog::level::info);
  return log;
}

void log_start(spdlog::logger& log, const Scene& scene, const SimulationPlan& plan, int threads) {
  log.info("{}, scene {} ({}), {} threads", software_name(), scene.name, scene.source_file, threads);
  if (scene.scheme.name == "shallow_water") {
    log.info("shallow water, {} cells of {:g} m, {} wet; time step {:.4g} s, about {} steps",
             plan.fluid_particles, plan.cell_size, plan.wet_cells, plan.time_step, plan.estimated_steps);
    return;
  }
  log.info("{} fluid, {} object, {} virtual, {} ghost particles; time step {:.4g} s, about {} steps",
           plan.fluid_particles, plan.object_particles, plan.virtual_particles, plan.ghost_particles,
           plan.time_step, plan.estimated_steps);
}

void log_end(spdlog::logger& log, const RunSummary& summary) {
  if (summary.status == "blown_up") log.error("{}", summary.message);
  log.info(
      "{} at t = {:.6g} s after {} steps and {:.2f} s, {:.4g} particle-steps/s, {} frames written, {} "
      "dropped",
      summary.status, summary.simulated_time, summary.steps, summary.wall_time_loop,
      summary.particle_steps_per_second, summary.frames_written, summary.frames_dropped);
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
    row("penetrations, lost", fmt::format("{}, {}", summary.penetrations, summary.lost_particles));
  }
  row("peak memory", fmt::format("{:.0f} MB", static_cast<double>(summary.peak_rss_bytes) / 1e6));
  row("output", files.folder.string());
  if (summary.frames_written + summary.frames_dropped == 0) return;
  std::string frames = fmt::format("{} in {}", summary.frames_written, files.frames().string());
  if (summary.frames_dropped > 0) frames += fmt::format(", {} dropped", summary.frames_dropped);
  row("frames", frames);
}

}  // namespace

int run_command(const RunOptions& options, std::ostream& out, std::ostream& progress_out) {
  const InterruptWatcher interrupt;
  const Scene scene = load_scene(options.scene, options.overrides);
  const double end_time = end_time_of(scene, options);
  const RunFiles files{options.out.value_or(std::filesystem::path("out") / scene.name)};
  check_run_folder(files, scene.name);
  const auto simulation = Simulation::create(scene, options.threads);

  RunTimes times;
  times.started = std::chrono::system_clock::now();
  prepare_run_folder(files);
  write_file_atomically(files.scene(), resolved_scene_toml(scene));
  const auto log = make_log(files);
  log_start(*log, scene, simulation->plan(), options.threads);
  ProgressReporter progress(progress_out, progress_style_of_terminal(options.quiet), terminal_width());
  RunSummary summary;
  try {
    summary = run_in_situ(*simulation, scene, files, {end_time, options.frames}, progress, *log,
                          [&interrupt] { return interrupt.requested(); });
    times.finished = std::chrono::system_clock::now();
    summary.threads = options.threads;
    write_run_json(files.summary(), summary, build_info(), host_info(), times);
  } catch (const std::exception& error) {
    log->error("{}", error.what());
    throw;
  }
  log_end(*log, summary);
  if (!options.quiet) print_summary(out, summary, files);
  if (summary.status == "blown_up") throw BlowUpError(summary.message);
  return summary.status == "interrupted" ? kInterrupted : kSuccess;
}

}  // namespace eisph
