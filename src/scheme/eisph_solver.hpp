#pragma once

#include "boundary/mirror_particles.hpp"
#include "boundary/mirror_planes.hpp"
#include "boundary/solid_particles.hpp"
#include "boundary/virtual_particles.hpp"
#include "core/thread_pool.hpp"
#include "scheme/simulation.hpp"
#include "scheme/stage_clock.hpp"
#include "sph/lattice_constants.hpp"
#include "sph/neighbour_list.hpp"
#include "sph/pair_operators.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace eisph {

/// The explicit incompressible SPH scheme (De Castro 2019, section 3.3): one Jacobi sweep per step of the
/// pressure equation, started from the pressures of the step before. All operators use the positions at the
/// beginning of the step.
///
/// The default stepping is symplectic: x += dt u^{n+1}, so that positions are half a step ahead of the
/// velocities and are brought back for every snapshot; the divergence that drives the pressure is that of
/// omega u^n + dt a with omega = 3, which raises the speed of sound of the sweep by sqrt(3). The thesis's
/// stepping is x += dt (u^n + u^{n+1})/2 with omega = 1.
template <int Dim>
class EisphSolver final : public Simulation {
 public:
  EisphSolver(const Scene& scene, int threads);

  [[nodiscard]] SimulationPlan plan() const override;
  void initialise() override;
  void step(double until) override;
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] double time_step() const override { return time_step_; }
  [[nodiscard]] std::uint64_t steps() const override { return steps_; }
  [[nodiscard]] std::uint64_t fluid_particles() const override { return fluid_; }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot() const override;
  [[nodiscard]] RunSummary summary() const override;

  // The stages of a step, public for the benchmarks and tests; step() calls them in this order.
  void sort_fluid();
  void place_boundaries();
  void find_neighbours();
  void accelerate(double time_step);
  void relax_pressure(double time_step);
  void apply_gradient(double time_step);

  [[nodiscard]] const SourceTable& table() const { return table_; }
  [[nodiscard]] const NeighbourList<Dim>& neighbours() const { return neighbours_; }
  [[nodiscard]] const LatticeConstants& lattice() const { return lattice_; }

 private:
  /// Sums of one block of particles, added up in the order of the blocks.
  struct BlockSums {
    double kinetic = 0.0;    ///< sum of u^2 / 2
    double potential = 0.0;  ///< sum of -g . x
    double speed_squared_max = 0.0;
    double number_density_max = 0.0;
    std::uint64_t penetrations = 0;
    std::uint32_t bad_row = kNoRow;  ///< first particle whose velocity is unusable, and that velocity
    std::array<double, Dim> bad_velocity{};
    std::array<double, Dim> bad_position{};
  };
  static constexpr std::uint32_t kNoRow = 0xFFFFFFFFU;

  void place_particles();
  void fill_objects();
  void solve_initial_pressure();
  void set_hydrostatic_pressure();

  /// What the pressure equation needs to know of particle `row`.
  struct PressureSums {
    double number_density;
    double coefficient;  ///< -sum A_ij rho0 h^2 / (2 alpha), positive
    double pressure;     ///< the same sum weighted with P_j, Pa
    double divergence;   ///< of the source vector, 1/s x s
  };
  template <bool WithDensity>
  PressureSums pressure_sums(std::uint32_t row) const;
  double coefficient_pressure_sum(std::uint32_t row) const;
  [[nodiscard]] bool is_pressureless(const PressureSums& sums, bool object) const;
  double relaxed_pressure(const PressureSums& sums, double time_step) const;

  void mirror_pressure();
  void publish_pressure(bool with_correction);
  void sweep_again();
  void correct_volume(double time_step);
  template <bool NearObject>
  Vector<Dim, double> pressure_acceleration(std::uint32_t row, const Neighbours& near) const;
  Vector<Dim, double> viscous_acceleration(std::uint32_t row) const;
  void update_particle(std::uint32_t i, double time_step, bool near_object,
                       const Vector<Dim, double>& acceleration, BlockSums& sums);
  void contain(std::array<double, Dim>& position, std::array<double, Dim>& velocity, bool near_object,
               BlockSums& sums) const;
  void add_up(const std::vector<BlockSums>& blocks);
  void record_compression();
  [[nodiscard]] std::uint64_t lost_particles() const;
  [[noreturn]] void throw_blow_up(const BlockSums& block) const;
  void set_object_sources();
  double repulsion_scale() const;
  void add_repulsion(std::size_t i, double scale, std::array<double, Dim>& acceleration) const;

  [[nodiscard]] Float4* fluid_rows(AlignedBuffer<Float4>& rows) { return rows.data() + table_.first_fluid; }
  [[nodiscard]] double output_shift() const;
  [[nodiscard]] std::uint64_t state_bytes(std::map<std::string, double>* by_array) const;
  [[nodiscard]] Vec3d scene_vector(const std::array<double, Dim>& components) const;

  Scene scene_;
  ThreadPool pool_;
  LatticeConstants lattice_;
  CellGrid<Dim> grid_;
  MirrorPlanes<Dim> planes_;
  VirtualParticles<Dim> virtual_particles_;
  SolidParticles solids_;

  // Constants of the run.
  double h_ = 0.0;            ///< smoothing length, m
  double alpha_ = 0.0;        ///< kernel normalisation, m^-Dim
  double volume_ = 0.0;       ///< of a fluid particle
  double viscosity_ = 0.0;    ///< laminar and artificial, m^2/s
  double speed_limit_ = 0.0;  ///< beyond it the run has blown up, m/s
  std::array<double, Dim> gravity_{};
  std::array<double, Dim> extent_{};

  // State of the fluid, in the order of the last sort.
  std::uint32_t fluid_ = 0;
  std::array<AlignedBuffer<double>, Dim> position_;  ///< m from the domain's lower corner
  std::array<AlignedBuffer<float>, Dim> velocity_;   ///< m/s
  AlignedBuffer<float> pressure_;                    ///< persistent, without the volume correction, Pa
  AlignedBuffer<std::uint32_t> id_;
  double time_ = 0.0;
  double time_step_ = 0.0;
  double attempted_step_ = 0.0;  ///< of the step in hand, s
  std::uint64_t steps_ = 0;
  double speed_max_ = 0.0;

  // Work space of a step.
  AlignedBuffer<double> scratch_;
  AlignedBuffer<std::uint32_t> scratch_id_;
  CellSort::Workspace sort_workspace_;
  CellSort fluid_sort_;
  MirrorParticles<Dim> fluid_images_;
  CellSort object_sort_;
  MirrorParticles<Dim> object_images_;
  std::vector<Float4> object_rows_[2];  ///< positions and velocities in the order of object_sort_
  SourceTable table_;
  NeighbourList<Dim> neighbours_;
  AlignedBuffer<float> number_density_;   ///< normalised by the lattice's, per fluid particle
  AlignedBuffer<float> coefficient_;      ///< PressureSums::coefficient
  AlignedBuffer<float> total_pressure_;   ///< with the volume correction, Pa
  AlignedBuffer<float> source_term_;      ///< of further sweeps: right side of the pressure equation, Pa
  AlignedBuffer<float> object_pressure_;  ///< new pressure of the objects, in table order
  AlignedBuffer<float> object_coefficient_;
  std::vector<BlockSums> blocks_;

  // Figures of the run.
  mutable StageClock clock_;
  double wall_time_loop_ = 0.0;
  double wall_time_initial_pressure_ = 0.0;
  std::uint64_t initial_fluid_ = 0;
  std::uint64_t outflow_ = 0;
  std::uint64_t penetrations_ = 0;
  std::uint64_t ghost_particles_max_ = 0;
  double compression_max_ = 0.0;
  double compression_p95_ = 0.0;
  std::vector<std::array<std::uint32_t, 1024>> histograms_;
  double energy_ = 0.0;
  double energy_initial_ = 0.0;
  double energy_lowest_ = 0.0;
  double energy_gain_max_ = 0.0;
};

}  // namespace eisph
