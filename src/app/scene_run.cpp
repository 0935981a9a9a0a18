#include "app/scene_run.hpp"

#include "app/build_info.hpp"
#include "io/file_io.hpp"
#include "io/host.hpp"
#include "io/run_json.hpp"
#include "io/scene_file.hpp"
#include "scheme/simulation.hpp"

#include <chrono>
#include <exception>
#include <memory>

#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>

namespace eisph {
namespace {

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
  if (!summary.frames_drawn_by.empty()) log.info("frames drawn by {}", summary.frames_drawn_by);
}

}  // namespace

RunSummary run_scene(const Scene& scene, const RunFiles& files, const InSituSettings& settings, int threads,
                     ProgressReporter& progress, const std::function<bool()>& stop_requested) {
  const auto simulation = Simulation::create(scene, threads);
  RunTimes times;
  times.started = std::chrono::system_clock::now();
  prepare_run_folder(files);
  write_file_atomically(files.scene(), resolved_scene_toml(scene));
  const auto log = make_log(files);
  log_start(*log, scene, simulation->plan(), threads);
  RunSummary summary;
  try {
    summary = run_in_situ(*simulation, scene, files, settings, progress, *log, stop_requested);
    times.finished = std::chrono::system_clock::now();
    summary.threads = threads;
    write_run_json(files.summary(), summary, build_info(), host_info(), times);
  } catch (const std::exception& error) {
    log->error("{}", error.what());
    throw;
  }
  log_end(*log, summary);
  return summary;
}

}  // namespace eisph
