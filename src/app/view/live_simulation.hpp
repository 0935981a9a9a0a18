#pragma once

#include "app/view/state_source.hpp"
#include "core/scene.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

namespace eisph {

/// A simulation on a thread of its own, which a viewer drives. Its steps end on the output times of the
/// scene, so that the states are those of `eisph run` as long as nothing is changed. A state is taken only
/// when the viewer has drawn the one before: what is not looked at costs the simulation nothing.
class LiveSimulation final : public StateSource {
 public:
  using Factory = std::function<std::unique_ptr<Simulation>()>;

  /// Starts paused, with the state at t = 0 on its way. `make` makes the simulation of the scene, here for
  /// the first time and at every restart; what it throws here comes out.
  LiveSimulation(const Scene& scene, Factory make);
  LiveSimulation(const LiveSimulation&) = delete;
  LiveSimulation& operator=(const LiveSimulation&) = delete;
  ~LiveSimulation() override;

  [[nodiscard]] std::shared_ptr<const Snapshot> latest() override;
  [[nodiscard]] SourceStatus status() const override;
  [[nodiscard]] std::shared_ptr<const std::vector<ProbePlot>> plots() const override;

  void play() override;
  void pause() override;
  void step() override;
  void restart() override;
  void run_to(double time) override;

  [[nodiscard]] bool takes_parameters() const override { return true; }
  void set_parameters(const RunningParameters& parameters) override;
  void record(double interval, Recorder take) override;

 private:
  /// What the viewer wants done.
  struct Orders {
    bool play = false;
    bool step = false;
    bool restart = false;
    bool quit = false;
    double until = std::numeric_limits<double>::infinity();  ///< s, where to pause
    double record_interval = 0.0;                            ///< s; 0: none
    std::optional<RunningParameters> parameters;             ///< as far as they have changed
  };

  void work();
  /// One simulation from its start until a restart or the end of all. False at the end of all.
  bool run_once();
  /// Waits for something to do: a step, with what is to be heeded in it. Nothing at a restart or the end.
  [[nodiscard]] std::optional<Orders> next_orders(bool at_end, const Simulation& simulation);
  /// Ends the playing where the time (s) ordered last is reached: orders given during a step stand.
  void pause_if_reached(double time);
  void publish(const Simulation& simulation);
  void hand_to_recorder(std::shared_ptr<const Snapshot> snapshot);
  void tell(const Simulation& simulation, double wall_time);
  void fail(const std::string& message);

  const Scene scene_;
  const Factory make_;
  std::unique_ptr<Simulation> first_;  ///< made by the constructor, to find errors early

  mutable std::mutex mutex_;
  std::condition_variable ordered_;
  Orders orders_;
  SourceStatus status_;
  std::shared_ptr<const Snapshot> latest_;
  std::shared_ptr<PlotTables> tables_ = std::make_shared<PlotTables>();
  std::atomic<bool> wanted_ = true;  ///< the viewer has taken the newest state

  Recorder recorder_;  ///< of the viewer's thread
  std::deque<std::shared_ptr<const Snapshot>> recorded_;
  static constexpr std::size_t kRecordedAhead = 4;  ///< states; then the simulation waits for the viewer

  std::thread thread_;
};

}  // namespace eisph
