#pragma once

#include "scheme/particle_motion.hpp"
#include "scheme/particle_system.hpp"
#include "scheme/simulation.hpp"
#include "scheme/stage_clock.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace eisph {

/// The frame that all particle schemes fill in: time loop, snapshots, figures. A scheme is a class that
/// derives from this one and says how the pressure of t = 0 is found and which stages make a step.
template <int Dim>
class ParticleScheme : public Simulation {
 public:
  ParticleScheme(const Scene& scene, int threads) : particles_(scene, threads), motion_(particles_) {}

  [[nodiscard]] SimulationPlan plan() const final;
  [[nodiscard]] InitialFit initial_fit() final;
  void initialise() final;
  void step(double until) final;
  void set_parameters(const RunningParameters& parameters) override;
  [[nodiscard]] double time() const final { return time_; }
  [[nodiscard]] double time_step() const final { return time_step_; }
  [[nodiscard]] std::uint64_t steps() const final { return steps_; }
  [[nodiscard]] std::uint64_t fluid_particles() const final { return particles_.fluid; }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot() const final;
  [[nodiscard]] RunSummary summary() const final;

 protected:
  /// Finds what the scheme carries and the pressure at t = 0; particles are sorted, neighbours known.
  virtual void find_initial_state() = 0;
  /// One step: starts the clock's stages, ends with the new positions and velocities in place.
  virtual void take_step(const StepInHand& step) = 0;
  /// Largest admissible time step of the present state, s.
  [[nodiscard]] virtual double admissible_time_step() const = 0;
  /// At which pressure travels with steps of this length, m/s.
  [[nodiscard]] virtual double sound_speed(double time_step) const = 0;
  /// Adds the sizes of the scheme's own arrays, bytes.
  virtual void add_bytes(std::map<std::string, double>& by_array) const = 0;
  /// Adds the scheme's own figures.
  virtual void report(RunSummary&) const {}
  /// Bytes per fluid particle of those arrays and of the carried scalar, as planned.
  [[nodiscard]] virtual double planned_bytes() const = 0;

  /// The first stages of every step: sorting, boundaries, neighbour search.
  void find_neighbourhood(const StepInHand& step);
  /// Whether positions are half a step ahead of the velocities (leap-frog).
  [[nodiscard]] bool positions_lead() const {
    return particles_.scene.scheme.stepping == Stepping::Symplectic;
  }

  ParticleSystem<Dim> particles_;
  ParticleMotion<Dim> motion_;
  StageClock clock_;

 private:
  [[nodiscard]] std::uint64_t state_bytes(std::map<std::string, double>* by_array) const;

  double time_ = 0.0;
  double time_step_ = 0.0;
  std::uint64_t steps_ = 0;
  double way_since_search_ = 0.0;  ///< of the fastest particle since the neighbour lists were made, m
  double wall_time_loop_ = 0.0;
  double cpu_time_loop_ = 0.0;
  double wall_time_initial_pressure_ = 0.0;
};

}  // namespace eisph
