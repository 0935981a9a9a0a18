#pragma once

#include "core/run_summary.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace eisph {

/// What a scene amounts to before anything runs.
struct SimulationPlan {
  std::uint64_t fluid_particles = 0;
  std::uint64_t object_particles = 0;
  std::uint64_t virtual_particles = 0;  ///< of the wall lattice at dx/2; evaluated on the fly, not stored
  std::uint64_t ghost_particles = 0;    ///< at t = 0
  double time_step = 0.0;               ///< s, at t = 0
  double effective_sound_speed = 0.0;   ///< m/s, of one sweep with persistent pressure
  std::uint64_t estimated_steps = 0;    ///< to the end time
  std::uint64_t estimated_bytes = 0;    ///< solver state

  // Of shallow water, where fluid_particles counts all cells, object_particles those on solids, and the speed
  // of sound is that of long waves, sqrt(g H).
  std::uint64_t wet_cells = 0;  ///< at t = 0
  double cell_size = 0.0;       ///< m; zero for particles
  double water_volume = 0.0;    ///< m^3 (m^2 in 2D) at t = 0, of particles too
};

/// How the particles of t = 0 lie in their tank.
struct InitialFit {
  /// From a wall or solid that water touches to the nearest row of particles.
  struct Gap {
    std::string name;  ///< of the face of the domain, or of the solid in quotes
    double spacings = 0.0;
  };
  std::vector<Gap> gaps;
  double compression = 0.0;  ///< largest normalised number density less one
};

/// What may be changed while a simulation runs; a scheme heeds what it knows.
struct RunningParameters {
  double kinematic_viscosity = 0.0;   ///< m^2/s
  double artificial_viscosity = 0.0;  ///< alpha_v
  double step_factor = 0.0;           ///< of the adaptive time step: phi, or the Courant number
  int pressure_sweeps = 1;

  bool operator==(const RunningParameters&) const = default;
};

/// The parameters that a simulation of the scene starts with.
[[nodiscard]] RunningParameters running_parameters(const Scene& scene);

/// A running simulation, of either dimension. Used by one thread; starts `threads - 1` workers of its own.
class Simulation {
 public:
  /// Places the particles, or fills the cells. Throws InputError when the scene cannot be simulated.
  static std::unique_ptr<Simulation> create(const Scene& scene, int threads);
  virtual ~Simulation() = default;

  [[nodiscard]] virtual SimulationPlan plan() const = 0;
  /// Asked before `initialise`; of cells nothing.
  [[nodiscard]] virtual InitialFit initial_fit() { return {}; }
  /// Finds the pressure at t = 0. Called once, before the first step.
  virtual void initialise() = 0;
  /// One time step that ends at or before `until`; the remaining time is divided into equal steps, so that
  /// `until` is met exactly (time() == until to the bit). Throws BlowUpError.
  virtual void step(double until) = 0;
  /// From the next step on.
  virtual void set_parameters(const RunningParameters&) {}

  [[nodiscard]] virtual double time() const = 0;       ///< s
  [[nodiscard]] virtual double time_step() const = 0;  ///< s, of the last step
  [[nodiscard]] virtual std::uint64_t steps() const = 0;
  /// Particles in the domain; of shallow water the cells.
  [[nodiscard]] virtual std::uint64_t fluid_particles() const = 0;
  /// What fluid_particles counts.
  [[nodiscard]] virtual const char* carriers() const { return "particles"; }
  /// The present state, positions brought to time().
  [[nodiscard]] virtual std::shared_ptr<const Snapshot> snapshot() const = 0;
  /// Figures known to the solver: counts, stage times, memory, compression, energy, penetrations. The wall
  /// clock of the loop covers step() only.
  [[nodiscard]] virtual RunSummary summary() const = 0;
};

}  // namespace eisph
