#pragma once

#include "core/thread_pool.hpp"
#include "scheme/shallow_water_bed.hpp"
#include "scheme/shallow_water_rows.hpp"
#include "scheme/simulation.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace eisph {

/// The shallow-water equations on square cells, as Aureli et al. (2008) computed their tests: explicit finite
/// volumes of second order in space and time (MUSCL-Hancock) with HLLC fluxes, balanced with the bed (lakes
/// at rest stay at rest), depths that cannot become negative, and Manning friction. A two-dimensional scene
/// is one row of cells.
///
///   h_t + (h u)_x + (h v)_y = 0
///   (h u)_t + (h u^2 + g h^2 / 2)_x + (h u v)_y = -g h b_x - g n^2 |u| u / h^(1/3),   and likewise for v
///
/// Snapshots carry the columns, and particles made of them to be drawn: every column is cut into equal layers
/// of at most a cell size, each a particle with the velocity of the column and hydrostatic pressure; in three
/// dimensions only the layers that can be seen from outside the water.
class ShallowWaterSolver final : public Simulation {
 public:
  ShallowWaterSolver(const Scene& scene, int threads);

  [[nodiscard]] SimulationPlan plan() const override;
  void initialise() override;
  void step(double until) override;
  void set_parameters(const RunningParameters& parameters) override {
    scene_.shallow_water.courant = parameters.step_factor;
  }
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] double time_step() const override { return time_step_; }
  [[nodiscard]] std::uint64_t steps() const override { return steps_; }
  /// Cells, dry ones included: what a step costs goes by them.
  [[nodiscard]] std::uint64_t fluid_particles() const override { return grid_.columns * grid_.rows; }
  [[nodiscard]] const char* carriers() const override { return "cells"; }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot() const override;
  [[nodiscard]] RunSummary summary() const override;

 private:
  /// h, u and v of all cells.
  struct State {
    AlignedBuffer<double> depth;       ///< m
    AlignedBuffer<double> velocity_x;  ///< m/s
    AlignedBuffer<double> velocity_y;
  };
  /// What one thread works with.
  struct Workspace {
    std::array<RowSides, 2> sides;  ///< of a row and of the one before it
    AlignedBuffer<double> momentum_lower, momentum_upper, tangential;
  };
  enum Stage : std::size_t { kBoundaries = 0, kFluxes, kUpdate, kStages };

  void fill_columns();
  [[nodiscard]] double admissible_step() const;
  void fill_ghosts();
  void find_fluxes(const ShallowWaterStep& step);
  void find_row_fluxes(const ShallowWaterStep& step, std::size_t j, Workspace& work);
  void find_faces_below(const ShallowWaterStep& step, std::size_t j, RowSides& before, RowSides& behind);
  void let_out_only(std::size_t face, bool at_upper_end, const FluxRow& flux, double depth) const;
  void update_cells(const ShallowWaterStep& step);
  void add_up();
  [[noreturn]] void throw_blow_up(std::size_t j) const;

  [[nodiscard]] StateRow state_row(std::size_t j) const;
  [[nodiscard]] FluxRow flux_y_row(std::size_t j);
  [[nodiscard]] bool is_open(int face) const {
    return scene_.faces[static_cast<std::size_t>(face)].kind == FaceKind::Open;
  }
  [[nodiscard]] double cell_area() const;
  [[nodiscard]] double outflow_rate() const;
  [[nodiscard]] std::shared_ptr<const ColumnField> column_field() const;
  [[nodiscard]] std::uint64_t state_bytes(std::map<std::string, double>* by_array) const;

  Scene scene_;
  ThreadPool pool_;
  ShallowWaterGrid grid_;
  ShallowWaterBed bed_;
  double gravity_ = 0.0;      ///< m/s^2
  double speed_limit_ = 0.0;  ///< beyond it the run has blown up, m/s
  bool plane_ = true;

  State state_;
  State next_;
  double time_ = 0.0;
  double time_step_ = 0.0;
  double attempted_step_ = 0.0;  ///< of the step in hand, s
  std::uint64_t steps_ = 0;
  double wave_speed_ = 0.0;  ///< RowSums::wave_speed of the state
  int careful_steps_ = 0;    ///< small steps that are left after a sudden start

  // Of a step: fluxes of mass, momentum gained, what the outflow of a cell is multiplied with.
  AlignedBuffer<double> mass_x_, mass_y_;
  AlignedBuffer<double> lower_y_, upper_y_, tangential_y_;
  AlignedBuffer<double> gain_x_, gain_y_;
  AlignedBuffer<double> share_;
  std::vector<Workspace> workspaces_;
  std::vector<RowSums> row_sums_;

  // Figures of the run.
  std::array<double, kStages> stage_seconds_{};
  double wall_time_loop_ = 0.0;
  double volume_ = 0.0;  ///< m^3 (m^2 in 2D)
  double volume_initial_ = 0.0;
  double outflow_ = 0.0;  ///< volume that has left through open faces
  double energy_ = 0.0;   ///< J (J/m)
  double energy_initial_ = 0.0;
  double energy_lowest_ = 0.0;
  double energy_gain_max_ = 0.0;
  std::uint64_t wet_cells_initial_ = 0;
};

}  // namespace eisph
