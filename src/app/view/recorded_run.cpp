#include "app/view/recorded_run.hpp"

#include <algorithm>
#include <exception>

namespace eisph {

RecordedRun::RecordedRun(const std::filesystem::path& folder)
    : states_(saved_states(RunFiles{folder})), tables_(read_plot_tables(folder)) {
  times_.reserve(states_.size());
  for (const SavedState& state : states_) times_.push_back(state.time);
  last_ = states_.size() - 1;
  show(0);
}

void RecordedRun::show(std::size_t state) {
  shown_ = std::min(state, states_.size() - 1);
  play_time_ = times_[shown_];
  plots_ = std::make_shared<const std::vector<ProbePlot>>(plots_of(tables_, times_[shown_]));
  try {
    snapshot_ = std::make_shared<const Snapshot>(read_state(states_[shown_]));
    message_.clear();
    if (recorder_) recorder_(*snapshot_);
  } catch (const std::exception& error) {
    message_ = error.what();
    playing_ = false;
  }
}

/// While playing: the clock decides which state it is time for. A recorder gets every state.
void RecordedRun::advance() {
  if (!playing_) return;
  const Clock::time_point now = Clock::now();
  const double played = play_time_ + std::chrono::duration<double>(now - played_at_).count();
  played_at_ = now;
  std::size_t due = shown_;
  while (due < last_ && times_[due + 1] <= played) ++due;
  if (recorder_ && due > shown_) due = shown_ + 1;
  if (due != shown_) show(due);
  play_time_ = recorder_ ? times_[shown_] : played;
  if (recorder_ && shown_ < last_) play_time_ = std::max(play_time_, std::min(played, times_[shown_ + 1]));
  if (shown_ >= last_) playing_ = false;
}

std::shared_ptr<const Snapshot> RecordedRun::latest() {
  advance();
  return snapshot_;
}

SourceStatus RecordedRun::status() const {
  SourceStatus status;
  status.playing = playing_;
  status.at_end = shown_ + 1 == states_.size();
  status.message = message_;
  status.time = times_[shown_];
  if (snapshot_) {
    status.time_step = snapshot_->time_step;
    status.steps = snapshot_->step;
    status.carriers = snapshot_->size();
  }
  return status;
}

void RecordedRun::play() {
  last_ = states_.size() - 1;
  if (shown_ == last_) show(0);
  playing_ = true;
  played_at_ = Clock::now();
}

void RecordedRun::pause() { playing_ = false; }

void RecordedRun::step() {
  playing_ = false;
  show(shown_ + 1);
}

void RecordedRun::restart() {
  playing_ = false;
  show(0);
}

void RecordedRun::run_to(double time) {
  if (time < times_[shown_]) show(0);
  last_ = shown_;
  while (last_ + 1 < states_.size() && times_[last_ + 1] <= time + kStateTimeTolerance) ++last_;
  playing_ = last_ > shown_;
  played_at_ = Clock::now();
}

void RecordedRun::record(double, Recorder take) { recorder_ = std::move(take); }

}  // namespace eisph
