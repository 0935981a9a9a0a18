#include "app/validate/validator.hpp"

#include "app/output_plan.hpp"
#include "app/progress.hpp"
#include "app/scene_run.hpp"
#include "core/assets.hpp"
#include "core/error.hpp"
#include "io/host.hpp"
#include "io/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace eisph {

namespace {

bool is_near(double a, double b) { return std::abs(a - b) < OutputPlan::kTolerance; }

/// Outputs of a run: the states asked for and the probes; frames only if asked for.
void set_outputs(Scene& scene, const RunRequest& request) {
  Schedule at_states;
  at_states.times = request.states;
  std::sort(at_states.times.begin(), at_states.times.end());
  scene.output.frames = at_states;
  scene.output.particles = at_states;
  scene.output.depth = {};
  if (!request.frames) scene.images.clear();
  for (ImageSettings& image : scene.images) image.schedule = at_states;
}

}  // namespace

NumberTable ValidationRun::table(const std::string& name) const {
  return read_number_table(files.folder / (name + ".csv"));
}

const Snapshot& ValidationRun::state(double time) const {
  const auto found = std::find_if(states.begin(), states.end(),
                                  [time](const auto& state) { return is_near(state->time, time); });
  if (found == states.end()) throw std::logic_error(fmt::format("no state was kept at {} s", time));
  return **found;
}

ReportFigure ValidationRun::frame(const std::string& image, double time, const std::string& caption) const {
  for (const ImageSettings& settings : scene.images) {
    if (settings.name != image) continue;
    const std::size_t index = count_due(settings.schedule, time) - 1;
    return {files.frames() / frame_file_name(image, index), caption};
  }
  throw std::logic_error("no image " + image);
}

Validator::Validator(Settings settings, std::ostream& progress, std::function<bool()> stop_requested)
    : settings_(std::move(settings)), progress_(progress), stop_requested_(std::move(stop_requested)) {}

void Validator::begin_case(const std::string& name) {
  case_ = name;
  figures_ = {};
  particle_steps_ = 0.0;
  std::filesystem::create_directories(settings_.folder / "figures");
}

std::filesystem::path Validator::figure_path(const std::string& name) const {
  return settings_.folder / "figures" / (case_ + "_" + name + ".png");
}

std::filesystem::path Validator::run_folder(const std::string& label) const {
  return settings_.folder / "runs" / (case_ + (label.empty() ? "" : "_" + label));
}

ValidationRun Validator::run(const RunRequest& request) {
  ValidationRun run;
  run.files = {run_folder(request.label)};
  const std::string label = run.files.folder.filename().string();
  std::vector<std::string> overrides = request.overrides;
  overrides.push_back("name=" + label);
  overrides.emplace_back("output.times=[]");  // those of the scene may lie beyond the end of this run
  run.scene = load_scene(shipped_scene(request.scene), overrides);
  set_outputs(run.scene, request);
  check_run_folder(run.files, run.scene.name);

  if (!settings_.quiet) fmt::print(progress_, "{}: {}\n", case_, label);
  ProgressReporter progress(progress_, progress_style_of_terminal(settings_.quiet), terminal_width());
  InSituSettings settings;
  settings.end_time = run.scene.end_time;
  settings.frames = request.frames;
  settings.observer = [&](const std::shared_ptr<const Snapshot>& state) {
    const bool wanted = std::any_of(request.states.begin(), request.states.end(),
                                    [&](double time) { return is_near(time, state->time); });
    if (wanted) run.states.push_back(state);
  };
  reset_peak_rss();
  run.summary = run_scene(run.scene, run.files, settings, settings_.threads, progress, stop_requested_);
  if (run.summary.status == "interrupted") throw ValidationInterrupted();
  if (run.summary.status == "blown_up") throw BlowUpError(run.summary.message);
  add_figures(run.summary);
  return run;
}

void Validator::add_figures(const RunSummary& summary) {
  figures_.wall_clock += summary.wall_time_loop + summary.wall_time_initial_pressure;
  figures_.peak_memory_bytes = std::max(figures_.peak_memory_bytes, summary.peak_rss_bytes);
  figures_.steps += summary.steps;
  figures_.particles = std::max(figures_.particles, summary.fluid_particles);
  figures_.penetrations += summary.penetrations;
  figures_.lost_particles += summary.lost_particles;
  figures_.compression_max = std::max(figures_.compression_max, summary.compression_max);
  figures_.compression_p95 = std::max(figures_.compression_p95, summary.compression_p95);
  // Runs without particles have none.
  figures_.paired_fraction = std::fmax(figures_.paired_fraction, summary.paired_fraction_max);
  figures_.isolated_fraction = std::fmax(figures_.isolated_fraction, summary.isolated_fraction_max);
  if (summary.energy_initial > 0.0) {
    figures_.energy_gain = std::max(figures_.energy_gain, summary.energy_gain_max / summary.energy_initial);
  }
  particle_steps_ += static_cast<double>(summary.fluid_particles) * static_cast<double>(summary.steps);
  if (figures_.wall_clock > 0.0) figures_.particle_steps_per_second = particle_steps_ / figures_.wall_clock;
}

}  // namespace eisph
