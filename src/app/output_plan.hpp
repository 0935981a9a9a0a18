#pragma once

#include "core/scene.hpp"

#include <cstddef>
#include <vector>

namespace eisph {

/// One frame that falls on an output time.
struct DueFrame {
  std::size_t image = 0;  ///< place in Scene::images
  std::size_t index = 0;  ///< of the frame in its sequence, from 0
};

/// Everything that falls on one output time.
struct DueOutputs {
  bool particles = false;
  bool depth = false;
  bool comparison = false;
  bool probes = false;
  std::vector<DueFrame> frames;

  [[nodiscard]] bool any() const { return particles || depth || comparison || probes || !frames.empty(); }
};

/// How much of everything a whole run writes.
struct OutputCounts {
  std::size_t particles = 0;
  std::size_t depth = 0;
  std::size_t probe_times = 0;
  std::vector<std::size_t> frames;  ///< by image
};

/// The output times of a scene, with all its schedules taken together.
class OutputPlan {
 public:
  /// Times nearer than this are one time, s.
  static constexpr double kTolerance = 1e-9;

  /// Without frames their times remain times at which a step ends, so that the result is the same.
  OutputPlan(const Scene& scene, bool frames);

  /// The first time after `time` (s) at which a step has to end, infinity if there is none.
  [[nodiscard]] double next_after(double time) const;
  [[nodiscard]] DueOutputs due_at(double time) const;
  [[nodiscard]] OutputCounts counts(double end_time) const;

  [[nodiscard]] bool has_frames() const { return draw_frames_ && !frames_.empty(); }
  /// Whether anything besides frames is written.
  [[nodiscard]] bool has_records() const;

 private:
  struct ImageSchedule {
    std::size_t image = 0;
    Schedule schedule;
  };

  Schedule particles_;
  Schedule depth_;
  Schedule comparison_;
  std::vector<Schedule> probes_;
  std::vector<ImageSchedule> frames_;
  std::size_t image_count_ = 0;  ///< of the scene, those without a schedule too
  bool draw_frames_ = true;
};

/// How many times of the schedule lie in [0, time].
[[nodiscard]] std::size_t count_due(const Schedule& schedule, double time);

}  // namespace eisph
