#include "app/in_situ_run.hpp"

#include "app/frame_stage.hpp"
#include "app/gauge_history.hpp"
#include "app/output_plan.hpp"
#include "app/pipeline.hpp"
#include "app/record_stage.hpp"
#include "app/time_loop.hpp"
#include "core/error.hpp"
#include "io/file_io.hpp"
#include "io/host.hpp"

#include <chrono>
#include <memory>
#include <vector>

namespace eisph {
namespace {

PipelineStages make_stages(const Scene& scene, const RunFiles& files, const OutputPlan& plan,
                           const InSituSettings& settings, std::string& frames_drawn_by,
                           NeighbourHistory& neighbours) {
  PipelineStages stages;
  std::shared_ptr<GaugeHistory> history;
  if (plan.has_frames() && draws_gauges(scene)) history = std::make_shared<GaugeHistory>(scene);
  if (plan.has_records() || plan.has_frames()) {
    stages.make_write = [&scene, &files, &settings, &neighbours, history] {
      // However this thread ends, the one that draws does not wait for more.
      const std::shared_ptr<void> closing(nullptr, [history](void*) {
        if (history) history->close();
      });
      auto stage = std::make_shared<RecordStage>(scene, files, history.get());
      return [stage, &settings, &neighbours, closing](const Publication& publication) {
        stage->write(publication);
        neighbours = stage->neighbours();
        if (publication.due.comparison && settings.compare) settings.compare(*publication.snapshot);
      };
    };
  }
  if (!plan.has_frames()) return stages;
  stages.make_draw = [&scene, &settings, &frames_drawn_by, history] {
    auto stage = std::make_shared<FrameStage>(scene, settings.context);
    frames_drawn_by = stage->context_description();
    return [&scene, stage, history](const Snapshot& snapshot, const DueFrame& due) {
      const ImageSettings& image = scene.images[due.image];
      std::vector<GaugeCurve> curves;
      if (!image.gauges.empty()) curves = history->up_to(snapshot.time, image.gauges);
      return Frame{frame_file_name(image.name, due.index), snapshot.time,
                   stage->draw(snapshot, due.image, curves)};
    };
  };
  stages.make_encode = [&scene, &files] {
    create_folder(files.frames());
    return [&scene, &files](const Frame& frame) { write_frame(files.frames(), scene, frame); };
  };
  return stages;
}

/// Wall clock since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

ProgressState progress_state(const Simulation& simulation, double end_time, const Stopwatch& watch) {
  return {simulation.time(),
          end_time,
          simulation.time_step(),
          simulation.steps(),
          simulation.fluid_particles(),
          watch.seconds(),
          simulation.carriers()};
}

LoopHooks make_hooks(const Simulation& simulation, Pipeline& pipeline, ProgressReporter& progress,
                     spdlog::logger& log, const InSituSettings& settings,
                     const std::function<bool()>& stop_requested) {
  const auto publish = [&pipeline, &log, &settings](const Publication& publication) {
    const DueOutputs& due = publication.due;
    const Snapshot& snapshot = *publication.snapshot;
    if (due.particles || due.depth || !due.frames.empty()) {
      log.info("output at t = {:.6g} s, step {}, time step {:.3g} s", snapshot.time, snapshot.step,
               snapshot.time_step);
    }
    if (settings.observer) settings.observer(publication.snapshot);
    pipeline.publish(publication);
  };
  const auto after_step = [&simulation, &pipeline, &progress, &settings, watch = Stopwatch()] {
    progress.update(progress_state(simulation, settings.end_time, watch));
    pipeline.check();
  };
  return {publish, after_step, stop_requested};
}

void put_neighbours(RunSummary& summary, const NeighbourHistory& neighbours) {
  if (neighbours.worst.particles == 0) return;
  summary.paired_fraction_max = neighbours.worst.paired_fraction;
  summary.paired_fraction_final = neighbours.last.paired_fraction;
  summary.nearest_distance_p5_min = neighbours.worst.nearest_distance_p5;
  summary.nearest_distance_p5_final = neighbours.last.nearest_distance_p5;
  summary.isolated_particles_max = neighbours.worst.isolated_particles;
  summary.isolated_particles_final = neighbours.last.isolated_particles;
  summary.isolated_fraction_max = neighbours.worst.isolated_fraction;
  summary.isolated_fraction_final = neighbours.last.isolated_fraction;
}

/// What the run itself adds to the figures of the solver.
void complete_summary(RunSummary& summary, const Scene& scene, const Pipeline& pipeline) {
  summary.scene = scene.name;
  summary.dimension = scene.dimension;
  summary.frames_written = pipeline.frames_written();
  summary.frames_dropped = pipeline.frames_dropped();
  summary.cpu_time_total = cpu_time();
  summary.peak_rss_bytes = peak_rss_bytes();
}

}  // namespace

RunSummary run_in_situ(Simulation& simulation, const Scene& scene, const RunFiles& files,
                       const InSituSettings& settings, ProgressReporter& progress, spdlog::logger& log,
                       const std::function<bool()>& stop_requested) {
  const OutputPlan plan(scene, settings.frames);
  const QueuePolicy policy = scene.output.latest_frame_only ? QueuePolicy::LatestOnly : QueuePolicy::KeepAll;
  // Set by the threads that draw and write, until the pipeline has finished.
  std::string frames_drawn_by;
  NeighbourHistory neighbours;
  Pipeline pipeline(make_stages(scene, files, plan, settings, frames_drawn_by, neighbours),
                    static_cast<std::size_t>(scene.output.queue_length), policy);

  std::string status = "finished";
  std::string message;
  Stopwatch watch;
  try {
    simulation.initialise();
    log.info("pressure at t = 0 found in {:.2f} s", simulation.summary().wall_time_initial_pressure);
    watch = Stopwatch();
    const LoopHooks hooks = make_hooks(simulation, pipeline, progress, log, settings, stop_requested);
    if (run_time_loop(simulation, plan, settings.end_time, hooks) == LoopEnd::Interrupted)
      status = "interrupted";
  } catch (const BlowUpError& error) {
    status = "blown_up";
    message = error.what();
  }
  progress.finish(progress_state(simulation, settings.end_time, watch));
  pipeline.finish();

  RunSummary summary = simulation.summary();
  summary.status = status;
  summary.message = message;
  summary.frames_drawn_by = frames_drawn_by;
  put_neighbours(summary, neighbours);
  complete_summary(summary, scene, pipeline);
  return summary;
}

}  // namespace eisph
