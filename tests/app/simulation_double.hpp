#pragma once

#include "core/error.hpp"
#include "scheme/simulation.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace eisph {

/// A simulation of one particle that moves along x at 1 m/s in steps of a fixed size, and counts what is
/// asked of it.
class SimulationDouble : public Simulation {
 public:
  explicit SimulationDouble(double time_step, double blow_up_time = 1e30)
      : time_step_(time_step), blow_up_time_(blow_up_time) {}

  [[nodiscard]] SimulationPlan plan() const override { return {}; }
  void initialise() override { initialised_ = true; }

  void step(double until) override {
    if (during_step_) during_step_();
    if (time_ >= blow_up_time_) throw BlowUpError("particle 0 left the range at t = 0.5 s");
    last_step_ = std::min(time_step_, until - time_);
    time_ = time_ + time_step_ >= until ? until : time_ + time_step_;
    ++steps_;
    step_ends_.push_back(time_);
  }

  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] double time_step() const override { return last_step_; }
  [[nodiscard]] std::uint64_t steps() const override { return steps_; }
  [[nodiscard]] std::uint64_t fluid_particles() const override { return 1; }

  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot() const override {
    ++snapshots_;
    auto state = std::make_shared<Snapshot>();
    state->time = time_;
    state->step = steps_;
    state->time_step = last_step_;
    state->particle_spacing = 0.1;
    state->smoothing_length = 0.132;
    state->particle_mass = 1.0;
    state->reference_density = 1000.0;
    state->id = {0};
    state->position = {Vec3f(static_cast<float>(time_), 0.0F, 0.0F)};
    state->velocity = {Vec3f::UnitX()};
    state->pressure = {0.0F};
    state->number_density = {1.0F};
    state->objects = std::make_shared<ObjectParticles>();
    return state;
  }

  [[nodiscard]] RunSummary summary() const override {
    RunSummary summary;
    summary.fluid_particles = 1;
    summary.steps = steps_;
    summary.simulated_time = time_;
    return summary;
  }

  void set_parameters(const RunningParameters& parameters) override { parameters_ = parameters; }
  [[nodiscard]] const RunningParameters& parameters() const { return parameters_; }

  /// Called in every step, by the thread that takes it.
  void set_during_step(std::function<void()> call) { during_step_ = std::move(call); }

  [[nodiscard]] bool initialised() const { return initialised_; }
  [[nodiscard]] int snapshots() const { return snapshots_; }
  [[nodiscard]] const std::vector<double>& step_ends() const { return step_ends_; }

 private:
  double time_step_;
  double blow_up_time_;
  double time_ = 0.0;
  double last_step_ = 0.0;
  std::uint64_t steps_ = 0;
  bool initialised_ = false;
  RunningParameters parameters_;
  std::function<void()> during_step_;
  mutable int snapshots_ = 0;
  std::vector<double> step_ends_;
};

}  // namespace eisph
