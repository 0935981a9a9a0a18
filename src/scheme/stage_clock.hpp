#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <string_view>

namespace eisph {

/// Stages of a step, in order.
enum class Stage : std::size_t {
  Sort,
  Boundaries,  ///< mirror images, object particles
  NeighbourSearch,
  Acceleration,  ///< viscosity, gravity, repulsion
  Pressure,      ///< density, divergence, sweep, volume correction
  Gradient,      ///< pressure gradient and the update of velocity and position
  Diagnostics,
  Count
};

inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::Count);
inline constexpr std::array<std::string_view, kStages> kStageNames = {
    "sort", "boundaries", "neighbour_search", "acceleration", "pressure", "gradient", "diagnostics"};

/// CPU time of the calling thread so far, s.
inline double thread_cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Wall-clock time spent in each stage, s.
class StageClock {
 public:
  /// Ends the running stage and begins another.
  void start(Stage stage) {
    const auto now = Clock::now();
    if (running_)
      seconds_[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - since_).count();
    stage_ = stage;
    since_ = now;
    running_ = true;
  }
  void stop() {
    start(stage_);
    running_ = false;
  }
  void reset() { seconds_.fill(0.0); }
  [[nodiscard]] double seconds(Stage stage) const { return seconds_[static_cast<std::size_t>(stage)]; }
  [[nodiscard]] double total() const {
    double sum = 0.0;
    for (double seconds : seconds_) sum += seconds;
    return sum;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::array<double, kStages> seconds_{};
  Stage stage_ = Stage::Sort;
  Clock::time_point since_;
  bool running_ = false;
};

}  // namespace eisph
