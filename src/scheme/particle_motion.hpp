#pragma once

#include "core/run_summary.hpp"
#include "scheme/particle_system.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace eisph {

/// The step that a scheme is taking.
struct StepInHand {
  std::uint64_t number = 1;
  double time = 0.0;            ///< s, at its beginning
  double time_step = 0.0;       ///< s
  double last_time_step = 0.0;  ///< s, of the step before; of the first step its own

  /// Positions that lead go from half a step of the last length past its end to half a step of the present
  /// length past the end of this one, s.
  [[nodiscard]] double leading_drift() const { return 1.5 * time_step - 0.5 * last_time_step; }
};

/// Where the fluid goes at the end of a step, and what is recorded on the way: blow-ups, penetrations,
/// compression and energy. The same for all particle schemes.
template <int Dim>
class ParticleMotion {
 public:
  using Components = std::array<double, Dim>;

  explicit ParticleMotion(const ParticleSystem<Dim>& particles);

  /// Calls update(i, near, position, velocity) for every fluid particle: it gives the new position (m from
  /// the domain's lower corner) and velocity (m/s) of particle i with neighbours `near`, and returns whether
  /// one of these may be within the reach of separation. Takes pairs of particles apart. Keeps the particle
  /// within the walls and out of the solids and stores both. `lead` is the time by which positions are ahead
  /// of velocities, s. Throws BlowUpError when a velocity is beyond reason.
  template <class Update>
  void advance(ParticleSystem<Dim>& particles, const StepInHand& step, double lead, const Update& update) {
    const bool shifting = particles.scene.scheme.shifting > 0.0;
    if (shifting) particles.count_pass();
    blocks_.assign((particles.fluid + kBlock - 1) / kBlock, BlockSums{});
    particles.pool.run_blocks(particles.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
      BlockSums sums;
      for (std::size_t i = first; i < last; ++i) {
        const Neighbours near = particles.neighbours.of(particles.fluid_row(i));
        Components position;
        Components velocity;
        const bool crowded = update(i, near, position, velocity);
        if (crowded) separate(particles, i, near, position);
        if (shifting) shift(particles, i, near, step.time_step, position, velocity);
        settle(particles, i, lead, near.near_object, position, velocity, sums);
      }
      blocks_[first / kBlock] = sums;
    });
    add_up(particles, step);
  }

  /// Records the 95th percentile of the compression.
  void record_compression(ParticleSystem<Dim>& particles);
  /// Energy at t = 0.
  void record_initial_energy(const ParticleSystem<Dim>& particles);

  [[nodiscard]] std::uint64_t penetrations() const { return penetrations_; }
  void report(RunSummary& summary) const;

 private:
  void separate(const ParticleSystem<Dim>& particles, std::size_t i, const Neighbours& near,
                Components& position) const;
  static constexpr std::size_t kBlock = 512;
  static constexpr std::uint32_t kNoRow = 0xFFFFFFFFU;

  /// Sums of one block of particles, added up in the order of the blocks.
  struct BlockSums {
    double kinetic = 0.0;    ///< sum of u^2 / 2
    double potential = 0.0;  ///< sum of -g . x
    double speed_squared_max = 0.0;
    double number_density_max = 0.0;
    std::uint64_t penetrations = 0;
    std::uint32_t bad_row = kNoRow;  ///< first particle whose velocity is unusable, and that velocity
    Components bad_velocity{};
    Components bad_position{};
  };

  void shift(const ParticleSystem<Dim>& particles, std::size_t i, const Neighbours& near, double time_step,
             Components& position, const Components& velocity) const;
  void settle(ParticleSystem<Dim>& particles, std::size_t i, double lead, bool near_object,
              Components& position, Components& velocity, BlockSums& sums) const;
  void contain(const ParticleSystem<Dim>& particles, bool near_object, Components& position,
               Components& velocity, BlockSums& sums) const;
  void add_up(ParticleSystem<Dim>& particles, const StepInHand& step);
  [[noreturn]] void throw_blow_up(const ParticleSystem<Dim>& particles, const StepInHand& step,
                                  const BlockSums& block) const;

  double slow_ = 0.0;         ///< m/s, of pairs that are left alone
  double speed_limit_ = 0.0;  ///< beyond it the run has blown up, m/s
  std::vector<BlockSums> blocks_;
  std::uint64_t penetrations_ = 0;
  double compression_max_ = 0.0;
  double compression_p95_ = 0.0;
  std::vector<std::array<std::uint32_t, 1024>> histograms_;
  double energy_ = 0.0;
  double energy_initial_ = 0.0;
  double energy_lowest_ = 0.0;
  double energy_gain_max_ = 0.0;
};

}  // namespace eisph
