#include "app/view/live_simulation.hpp"

#include "app/output_plan.hpp"
#include "probe/probe_set.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

namespace eisph {

namespace {

/// The first multiple of `interval` (s) after `time`; infinity without one.
double next_multiple(double interval, double time) {
  if (interval <= 0.0) return std::numeric_limits<double>::infinity();
  return interval * (std::floor(time / interval + 1e-9) + 1.0);
}

/// Times between which the figures of the run are told, s of wall clock.
constexpr double kTelling = 0.2;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

LiveSimulation::LiveSimulation(const Scene& scene, Factory make)
    : scene_(scene), make_(std::move(make)), first_(make_()) {
  thread_ = std::thread([this] { work(); });
}

LiveSimulation::~LiveSimulation() {
  {
    const std::lock_guard lock(mutex_);
    orders_.quit = true;
  }
  ordered_.notify_all();
  thread_.join();
}

std::shared_ptr<const Snapshot> LiveSimulation::latest() {
  std::deque<std::shared_ptr<const Snapshot>> recorded;
  std::shared_ptr<const Snapshot> newest;
  {
    const std::lock_guard lock(mutex_);
    recorded.swap(recorded_);
    newest = latest_;
  }
  wanted_ = true;
  ordered_.notify_all();
  for (const auto& snapshot : recorded) {
    if (recorder_) recorder_(*snapshot);
  }
  return newest;
}

SourceStatus LiveSimulation::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::shared_ptr<const std::vector<ProbePlot>> LiveSimulation::plots() const {
  std::shared_ptr<PlotTables> tables;
  {
    const std::lock_guard lock(mutex_);
    tables = tables_;
  }
  return tables->plots();
}

void LiveSimulation::play() { run_to(std::numeric_limits<double>::infinity()); }

void LiveSimulation::run_to(double time) {
  {
    const std::lock_guard lock(mutex_);
    orders_.play = true;
    orders_.until = time;
  }
  ordered_.notify_all();
}

void LiveSimulation::pause() {
  const std::lock_guard lock(mutex_);
  orders_.play = false;
}

void LiveSimulation::step() {
  {
    const std::lock_guard lock(mutex_);
    orders_.play = false;
    orders_.step = true;
  }
  ordered_.notify_all();
}

void LiveSimulation::restart() {
  {
    const std::lock_guard lock(mutex_);
    orders_.restart = true;
    orders_.play = false;
    orders_.step = false;
  }
  ordered_.notify_all();
}

void LiveSimulation::set_parameters(const RunningParameters& parameters) {
  {
    const std::lock_guard lock(mutex_);
    orders_.parameters = parameters;
  }
  ordered_.notify_all();
}

void LiveSimulation::record(double interval, Recorder take) {
  recorder_ = std::move(take);
  {
    const std::lock_guard lock(mutex_);
    orders_.record_interval = recorder_ ? interval : 0.0;
    if (!recorder_) recorded_.clear();
  }
  ordered_.notify_all();
}

void LiveSimulation::pause_if_reached(double time) {
  const std::lock_guard lock(mutex_);
  if (time >= std::min(orders_.until, scene_.end_time)) orders_.play = false;
}

void LiveSimulation::work() {
  bool going_on = true;
  while (going_on) {
    try {
      going_on = run_once();
    } catch (const std::exception& error) {
      fail(error.what());
      // Only a restart or the end of all leads out of here.
      std::unique_lock lock(mutex_);
      ordered_.wait(lock, [this] { return orders_.quit || orders_.restart; });
      going_on = !orders_.quit;
      orders_.restart = false;
    }
  }
}

void LiveSimulation::fail(const std::string& message) {
  const std::lock_guard lock(mutex_);
  orders_.play = false;
  orders_.step = false;
  status_.playing = false;
  status_.message = message;
}

bool LiveSimulation::run_once() {
  const std::unique_ptr<Simulation> simulation = first_ ? std::move(first_) : make_();
  const auto tables = std::make_shared<PlotTables>();
  ProbeSet probes(scene_, *tables);
  const OutputPlan plan(scene_, true);
  RunningParameters parameters = running_parameters(scene_);
  {
    const std::lock_guard lock(mutex_);
    tables_ = tables;
    status_ = {};
    if (orders_.parameters) parameters = *orders_.parameters;
  }
  simulation->set_parameters(parameters);
  simulation->initialise();
  probes.record(*simulation->snapshot());
  publish(*simulation);
  tell(*simulation, 0.0);

  double wall_time = 0.0;
  Clock::time_point told = Clock::now();
  while (true) {
    const bool at_end = simulation->time() >= scene_.end_time;
    const std::optional<Orders> orders = next_orders(at_end, *simulation);
    if (!orders) {
      const std::lock_guard lock(mutex_);
      return !orders_.quit;
    }
    if (orders->parameters && !(*orders->parameters == parameters)) {
      parameters = *orders->parameters;
      simulation->set_parameters(parameters);
    }
    const double time = simulation->time();
    const double record_at = next_multiple(orders->record_interval, time);
    double target = std::min({plan.next_after(time), record_at, scene_.end_time});
    if (orders->until > time) target = std::min(target, orders->until);
    const Clock::time_point start = Clock::now();
    simulation->step(target);
    wall_time += seconds_since(start);

    const bool met = simulation->time() == target;
    const bool recorded = met && target == record_at;
    const bool probed = met && plan.due_at(target).any();
    std::shared_ptr<const Snapshot> snapshot;
    if (recorded || probed) snapshot = simulation->snapshot();
    if (probed) probes.record(*snapshot);
    const bool stops = orders->step || simulation->time() >= std::min(orders->until, scene_.end_time);
    if (stops) pause_if_reached(simulation->time());
    if (stops || wanted_.exchange(false)) publish(*simulation);
    if (stops || seconds_since(told) > kTelling) {
      tell(*simulation, wall_time);
      told = Clock::now();
    }
    if (recorded) hand_to_recorder(std::move(snapshot));
  }
}

std::optional<LiveSimulation::Orders> LiveSimulation::next_orders(bool at_end, const Simulation& simulation) {
  std::unique_lock lock(mutex_);
  const auto something = [this, at_end] {
    return orders_.quit || orders_.restart || (!at_end && (orders_.play || orders_.step));
  };
  if (!something()) {
    status_.playing = false;
    status_.at_end = at_end;
    orders_.play = orders_.play && !at_end;
    // Whoever looks at a simulation that stands still sees its last state.
    if (latest_->step != simulation.steps()) {
      lock.unlock();
      publish(simulation);
      lock.lock();
    }
    ordered_.wait(lock, something);
  }
  if (orders_.quit || orders_.restart) {
    orders_.restart = false;
    return std::nullopt;
  }
  status_.playing = orders_.play;
  Orders taken = orders_;
  orders_.step = false;
  return taken;
}

void LiveSimulation::publish(const Simulation& simulation) {
  auto snapshot = simulation.snapshot();
  const std::lock_guard lock(mutex_);
  latest_ = std::move(snapshot);
}

void LiveSimulation::hand_to_recorder(std::shared_ptr<const Snapshot> snapshot) {
  std::unique_lock lock(mutex_);
  ordered_.wait(lock, [this] {
    return orders_.quit || orders_.record_interval <= 0.0 || recorded_.size() < kRecordedAhead;
  });
  if (orders_.record_interval > 0.0) recorded_.push_back(std::move(snapshot));
}

void LiveSimulation::tell(const Simulation& simulation, double wall_time) {
  const RunSummary summary = simulation.summary();
  const std::lock_guard lock(mutex_);
  status_.time = simulation.time();
  status_.time_step = simulation.time_step();
  status_.steps = simulation.steps();
  status_.carriers = simulation.fluid_particles();
  const double carrier_steps = static_cast<double>(status_.carriers) * static_cast<double>(status_.steps);
  status_.carrier_steps_per_second = wall_time > 0.0 ? carrier_steps / wall_time : 0.0;
  status_.stage_times.assign(summary.stage_ns_per_particle_step.begin(),
                             summary.stage_ns_per_particle_step.end());
}

}  // namespace eisph
