#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace eisph {

/// Figures of a finished (or stopped) run: the top level of run.json, by the same names.
struct RunSummary {
  static constexpr double kNotFound = std::numeric_limits<double>::quiet_NaN();

  std::string scene;
  std::string scheme = "eisph";     ///< of "shallow_water" the particles are cells
  std::string status = "finished";  ///< finished, interrupted or blown_up
  std::string message;              ///< of a blow-up
  int dimension = 3;
  std::uint64_t fluid_particles = 0;
  std::uint64_t object_particles = 0;
  std::uint64_t ghost_particles_max = 0;  ///< most ghosts held at once
  int threads = 1;
  std::uint64_t steps = 0;
  double simulated_time = 0.0;              ///< s
  double time_step_mean = 0.0;              ///< s
  double wall_time_loop = 0.0;              ///< s, time loop alone
  double cpu_time_loop = 0.0;               ///< s, of the thread that steps; 0 of shallow water
  double wall_time_initial_pressure = 0.0;  ///< s
  double particle_steps_per_second = 0.0;   ///< fluid particles x steps / wall_time_loop
  double pair_evaluations = 0.0;  ///< neighbour-list entries read, padding included, over the whole run
  double pressure_iterations_mean = 0.0;                     ///< of isph, in a step
  double cpu_time_total = 0.0;                               ///< s, all threads of the process
  std::map<std::string, double> stage_ns_per_particle_step;  ///< wall clock ns, by stage
  double state_bytes_per_particle = 0.0;
  std::map<std::string, double> state_bytes_by_array;  ///< bytes
  std::uint64_t peak_rss_bytes = 0;
  std::uint64_t penetrations = 0;  ///< counted before any safety clamp
  std::uint64_t lost_particles = 0;
  std::uint64_t outflow_particles = 0;  ///< taken out through open faces
  double outflow_volume = 0.0;          ///< m^3 (m^2 in 2D), likewise, of shallow water
  double compression_max = 0.0;         ///< largest number density - 1 over the run
  double compression_p95 = 0.0;         ///< 95th percentile over the fluid, largest over the run
  // Distances of neighbours in the ledger: largest or smallest over the run, and in its last row that has
  // them; not-a-number where none has, as of shallow water.
  double paired_fraction_max = kNotFound;  ///< of the fluid particles, with another within 0.6 spacings
  double paired_fraction_final = kNotFound;
  double nearest_distance_p5_min = kNotFound;  ///< 5th percentile of the nearest distance over the spacing
  double nearest_distance_p5_final = kNotFound;
  std::uint64_t isolated_particles_max = 0;  ///< without another within 2 spacings
  std::uint64_t isolated_particles_final = 0;
  double isolated_fraction_max = kNotFound;  ///< the same over all fluid particles
  double isolated_fraction_final = kNotFound;
  double energy_initial = 0.0;  ///< J (J/m in 2D), potential + kinetic
  double energy_final = 0.0;
  double energy_gain_max = 0.0;  ///< largest rise above the lowest energy before it
  double mass_error = 0.0;       ///< (final + outflow - initial) / initial
  std::uint64_t frames_written = 0;
  std::uint64_t frames_dropped = 0;
  std::string frames_drawn_by;  ///< context, driver and version; empty where no particles were drawn
};

}  // namespace eisph
