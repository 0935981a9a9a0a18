#pragma once

#include "app/saved_states.hpp"
#include "app/view/state_source.hpp"

#include <chrono>
#include <filesystem>

namespace eisph {

/// The saved states of a finished run. Playing shows one after the other, a second of the run in a second of
/// the clock.
class RecordedRun final : public StateSource {
 public:
  /// Throws InputError when the folder holds no states.
  explicit RecordedRun(const std::filesystem::path& folder);

  [[nodiscard]] std::shared_ptr<const Snapshot> latest() override;
  [[nodiscard]] SourceStatus status() const override;
  [[nodiscard]] std::shared_ptr<const std::vector<ProbePlot>> plots() const override { return plots_; }

  void play() override;
  void pause() override;
  void step() override;
  void restart() override;
  void run_to(double time) override;

  [[nodiscard]] const std::vector<double>& saved_times() const override { return times_; }
  void show(std::size_t state) override;
  void record(double interval, Recorder take) override;

 private:
  using Clock = std::chrono::steady_clock;
  void advance();

  std::vector<SavedState> states_;
  std::vector<double> times_;
  std::vector<PlotTable> tables_;
  std::shared_ptr<const std::vector<ProbePlot>> plots_;
  std::size_t shown_ = 0;
  std::shared_ptr<const Snapshot> snapshot_;
  std::string message_;
  bool playing_ = false;
  std::size_t last_ = 0;    ///< state at which playing ends
  double play_time_ = 0.0;  ///< s, of the run
  Clock::time_point played_at_;
  Recorder recorder_;
};

}  // namespace eisph
