#include "app/output_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eisph {
namespace {

/// A time before t = 0 after which t = 0 is the next multiple of any interval.
constexpr double kBeforeStart = -2.0 * OutputPlan::kTolerance;

std::size_t count_due_any(const std::vector<Schedule>& schedules, double time) {
  std::size_t count = 0;
  double last = kBeforeStart;
  while (true) {
    double next = std::numeric_limits<double>::infinity();
    for (const Schedule& schedule : schedules) next = std::min(next, schedule.next_after(last));
    if (next > time + OutputPlan::kTolerance) return count;
    ++count;
    last = next;
  }
}

}  // namespace

std::size_t count_due(const Schedule& schedule, double time) { return count_due_any({schedule}, time); }

OutputPlan::OutputPlan(const Scene& scene, bool frames)
    : particles_(scene.output.particles),
      depth_(scene.output.depth),
      comparison_(scene.output.comparison),
      image_count_(scene.images.size()),
      draw_frames_(frames) {
  const auto add_probe = [this](double interval) {
    Schedule schedule;
    schedule.interval = interval;
    if (!schedule.empty()) probes_.push_back(schedule);
  };
  add_probe(scene.output.ledger_interval);
  for (const double interval : probe_intervals(scene)) add_probe(interval);
  for (std::size_t image = 0; image < scene.images.size(); ++image) {
    const Schedule& schedule = scene.images[image].schedule;
    if (!schedule.empty()) frames_.push_back({image, schedule});
  }
}

bool OutputPlan::has_records() const {
  return !particles_.empty() || !depth_.empty() || !comparison_.empty() || !probes_.empty();
}

double OutputPlan::next_after(double time) const {
  double next = std::min(particles_.next_after(time, kTolerance), depth_.next_after(time, kTolerance));
  next = std::min(next, comparison_.next_after(time, kTolerance));
  for (const Schedule& probe : probes_) next = std::min(next, probe.next_after(time, kTolerance));
  for (const ImageSchedule& image : frames_)
    next = std::min(next, image.schedule.next_after(time, kTolerance));
  return next;
}

DueOutputs OutputPlan::due_at(double time) const {
  DueOutputs due;
  due.particles = particles_.is_due(time, kTolerance);
  due.depth = depth_.is_due(time, kTolerance);
  due.comparison = comparison_.is_due(time, kTolerance);
  due.probes = std::any_of(probes_.begin(), probes_.end(),
                           [time](const Schedule& probe) { return probe.is_due(time, kTolerance); });
  if (!draw_frames_) return due;
  for (const ImageSchedule& image : frames_) {
    if (!image.schedule.is_due(time, kTolerance)) continue;
    due.frames.push_back({image.image, count_due(image.schedule, time) - 1});
  }
  return due;
}

OutputCounts OutputPlan::counts(double end_time) const {
  OutputCounts counts;
  counts.particles = count_due(particles_, end_time);
  counts.depth = count_due(depth_, end_time);
  counts.probe_times = count_due_any(probes_, end_time);
  counts.frames.assign(image_count_, 0);
  if (!draw_frames_) return counts;
  for (const ImageSchedule& image : frames_) counts.frames[image.image] = count_due(image.schedule, end_time);
  return counts;
}

}  // namespace eisph
