#include "scheme/shallow_water_solver.hpp"

#include "core/error.hpp"
#include "scheme/column_geometry.hpp"
#include "scheme/schemes.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr std::size_t kRowsPerBlock = 16;
/// Blow-up: speeds beyond this many times the largest that gravity and the initial state explain.
constexpr double kSpeedLimitFactor = 20.0;
/// The waves of a dam break are faster than anything in the state it starts from: after the start and after
/// the opening of a gate a few steps are shortened.
constexpr int kCarefulSteps = 5;
constexpr double kCarefulFactor = 0.3;

/// Adds the time since it was made to a sum.
class Timer {
 public:
  explicit Timer(double& seconds) : seconds_(seconds) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

ShallowWaterSolver::ShallowWaterSolver(const Scene& scene, int threads)
    : scene_(scene),
      pool_(threads),
      grid_(scene),
      bed_(scene, grid_),
      gravity_(std::abs(scene.gravity.z())),
      plane_(scene.dimension == 3) {
  for (AlignedBuffer<double>* values : {&state_.depth, &state_.velocity_x, &state_.velocity_y, &next_.depth,
                                        &next_.velocity_x, &next_.velocity_y, &mass_x_, &mass_y_, &lower_y_,
                                        &upper_y_, &tangential_y_, &gain_x_, &gain_y_, &share_}) {
    values->resize_exactly(grid_.size());
    values->fill(0.0);
  }
  share_.fill(1.0);
  workspaces_.resize(static_cast<std::size_t>(pool_.threads()));
  for (Workspace& work : workspaces_) {
    for (RowSides& sides : work.sides) {
      for (SideRow& side : sides) side.resize(grid_.stride);
    }
    for (AlignedBuffer<double>* values : {&work.momentum_lower, &work.momentum_upper, &work.tangential}) {
      values->resize_exactly(grid_.stride);
      values->fill(0.0);
    }
  }
  row_sums_.resize(grid_.rows);
  fill_columns();
  add_up();
  volume_initial_ = volume_;
  energy_initial_ = energy_lowest_ = energy_;
  energy_gain_max_ = 0.0;
  careful_steps_ = kCarefulSteps;
}

void ShallowWaterSolver::fill_columns() {
  const Scene scene = without_cuts_of_solids(scene_);
  double fastest = 0.0;
  for (std::size_t j = 0; j < grid_.rows; ++j) {
    for (std::size_t i = 0; i < grid_.columns; ++i) {
      const std::size_t cell = grid_.index(i, j);
      const double size = grid_.cell_size;
      const ColumnWater water = water_in_cell(scene, grid_.origin_x + static_cast<double>(i) * size,
                                              grid_.origin_y + static_cast<double>(j) * size, size,
                                              scene_.domain_min.z() + bed_.bed()[cell]);
      state_.depth[cell] = water.depth;
      if (water.depth <= scene_.shallow_water.dry_depth) continue;
      ++wet_cells_initial_;
      state_.velocity_x[cell] = water.discharge_x / water.depth;
      state_.velocity_y[cell] = plane_ ? water.discharge_y / water.depth : 0.0;
      fastest = std::max(fastest, std::hypot(state_.velocity_x[cell], state_.velocity_y[cell]));
    }
  }
  const double extent = (scene_.domain_max - scene_.domain_min).maxCoeff();
  const double fall = std::sqrt(2.0 * gravity_ * extent);
  speed_limit_ = kSpeedLimitFactor * std::max({scene_.reference_speed(), fall, fastest});
}

StateRow ShallowWaterSolver::state_row(std::size_t j) const {
  const std::size_t row = grid_.row(j);
  return {state_.depth.data() + row, state_.velocity_x.data() + row, state_.velocity_y.data() + row,
          bed_.bed() + row};
}

FluxRow ShallowWaterSolver::flux_y_row(std::size_t j) {
  const std::size_t row = grid_.row(j);
  return {mass_y_.data() + row, lower_y_.data() + row, upper_y_.data() + row, tangential_y_.data() + row};
}

double ShallowWaterSolver::cell_area() const {
  return plane_ ? grid_.cell_size * grid_.cell_size : grid_.cell_size;
}

void ShallowWaterSolver::initialise() {
  stage_seconds_.fill(0.0);
  wall_time_loop_ = 0.0;
}

double ShallowWaterSolver::admissible_step() const {
  const double speed = std::max(wave_speed_, 1e-3 * std::sqrt(gravity_ * grid_.cell_size));
  const double step = scene_.shallow_water.courant * grid_.cell_size / speed;
  return careful_steps_ > 0 ? kCarefulFactor * step : step;
}

void ShallowWaterSolver::step(double until) {
  const auto start = std::chrono::steady_clock::now();
  if (bed_.open_gates(time_, state_.depth.data())) careful_steps_ = kCarefulSteps;
  // A gate must not open late because a step goes past its time.
  const double target = std::min(until, bed_.next_gate_start(time_));
  const double remaining = target - time_;
  const double parts = std::max(1.0, std::ceil(remaining / admissible_step() * (1.0 - 1e-12)));
  attempted_step_ = remaining / parts;

  const ShallowWaterSettings& settings = scene_.shallow_water;
  const ShallowWaterStep now{.gravity = gravity_,
                             .time_step = attempted_step_,
                             .cell_size = grid_.cell_size,
                             .dry_depth = settings.dry_depth,
                             .manning = settings.manning,
                             .plane = plane_,
                             .limiter = settings.limiter};
  {
    const Timer timer(stage_seconds_[kBoundaries]);
    bed_.find_walls(state_.depth.data(), settings.dry_depth);
    fill_ghosts();
  }
  {
    const Timer timer(stage_seconds_[kFluxes]);
    find_fluxes(now);
  }
  {
    const Timer timer(stage_seconds_[kUpdate]);
    update_cells(now);
    outflow_ += attempted_step_ * outflow_rate();
    add_up();
  }
  careful_steps_ = std::max(0, careful_steps_ - 1);
  time_ = parts <= 1.0 ? target : time_ + attempted_step_;
  time_step_ = attempted_step_;
  ++steps_;
  wall_time_loop_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Beyond open ends the water goes on as it is. Elsewhere ghost cells are dry, and never looked at.
void ShallowWaterSolver::fill_ghosts() {
  for (AlignedBuffer<double>* values : {&state_.depth, &state_.velocity_x, &state_.velocity_y}) {
    double* at = values->data();
    for (std::size_t j = 0; j < grid_.rows; ++j) {
      const std::size_t row = grid_.row(j);
      if (is_open(kXMin)) at[row - 1] = at[row];
      if (is_open(kXMax)) at[row + grid_.columns] = at[row + grid_.columns - 1];
    }
    if (!plane_) continue;
    if (is_open(kYMin)) std::copy_n(at + grid_.row(0), grid_.columns, at + grid_.row(0) - grid_.stride);
    if (is_open(kYMax)) {
      std::copy_n(at + grid_.row(grid_.rows - 1), grid_.columns, at + grid_.row(grid_.rows));
    }
  }
}

void ShallowWaterSolver::find_fluxes(const ShallowWaterStep& step) {
  pool_.run_blocks(grid_.rows, kRowsPerBlock, [&](std::size_t first, std::size_t last, int worker) {
    Workspace& work = workspaces_[static_cast<std::size_t>(worker)];
    // The faces below the first row need the row before it, whose own fluxes another block finds.
    if (first > 0) {
      const std::size_t row = grid_.row(first - 1);
      reconstruct_row(step, state_row(first - 1), static_cast<std::ptrdiff_t>(grid_.stride),
                      bed_.open_x() + row, bed_.open_y() + row, grid_.columns, work.sides[(first - 1) % 2],
                      work.momentum_lower.data() + 1, work.momentum_upper.data() + 1);
    }
    for (std::size_t j = first; j < last; ++j) find_row_fluxes(step, j, work);
  });
}

void ShallowWaterSolver::find_row_fluxes(const ShallowWaterStep& step, std::size_t j, Workspace& work) {
  const std::size_t row = grid_.row(j);
  const std::size_t columns = grid_.columns;
  RowSides& sides = work.sides[j % 2];
  double* gain_x = gain_x_.data() + row;
  double* gain_y = gain_y_.data() + row;
  reconstruct_row(step, state_row(j), static_cast<std::ptrdiff_t>(grid_.stride), bed_.open_x() + row,
                  bed_.open_y() + row, columns, sides, gain_x, gain_y);

  SideRow& west = sides[kWest];
  SideRow& east = sides[kEast];
  const auto copy = [](SideRow& to, std::ptrdiff_t at, SideRow& from, std::size_t place) {
    to.depth()[at] = from.depth()[place];
    to.velocity_x()[at] = from.velocity_x()[place];
    to.velocity_y()[at] = from.velocity_y()[place];
    to.bed()[at] = from.bed()[place];
  };
  if (is_open(kXMin)) copy(east, -1, west, 0);
  if (is_open(kXMax)) copy(west, static_cast<std::ptrdiff_t>(columns), east, columns - 1);
  const FluxRow flux{mass_x_.data() + row, work.momentum_lower.data() + 1, work.momentum_upper.data() + 1,
                     work.tangential.data() + 1};
  flux_row_x(step, east.state(-1), west.state(), bed_.open_x() + row, columns + 1, flux);
  if (is_open(kXMin)) let_out_only(0, false, flux, west.depth()[0]);
  if (is_open(kXMax)) let_out_only(columns, true, flux, east.depth()[columns - 1]);
  add_x_fluxes(step, flux, columns, gain_x, gain_y);
  if (!plane_) return;

  find_faces_below(step, j, work.sides[(j + 1) % 2], sides);
  if (j + 1 < grid_.rows) return;
  const FluxRow last = flux_y_row(grid_.rows);
  SideRow& north = sides[kNorth];
  flux_row_y(step, north.state(), is_open(kYMax) ? north.state() : sides[kSouth].state(),
             bed_.open_y() + grid_.row(grid_.rows), columns, last);
  for (std::size_t i = 0; is_open(kYMax) && i < columns; ++i) let_out_only(i, true, last, north.depth()[i]);
}

/// Fluxes through the faces between row j and the one before it.
void ShallowWaterSolver::find_faces_below(const ShallowWaterStep& step, std::size_t j, RowSides& before,
                                          RowSides& behind) {
  const SideRow& south = behind[kSouth];
  // At the end of the domain there is no row before: its place is taken by the row itself, which a wall does
  // not look at and an open end continues.
  const SideRow& north = j > 0 ? before[kNorth] : south;
  const FluxRow flux = flux_y_row(j);
  flux_row_y(step, north.state(), south.state(), bed_.open_y() + grid_.row(j), grid_.columns, flux);
  if (j > 0 || !is_open(kYMin)) return;
  for (std::size_t i = 0; i < grid_.columns; ++i) let_out_only(i, false, flux, behind[kSouth].depth()[i]);
}

/// Nothing comes in through an open end: where the water moves inwards it is held by its own pressure.
void ShallowWaterSolver::let_out_only(std::size_t face, bool at_upper_end, const FluxRow& flux,
                                      double depth) const {
  if (at_upper_end ? flux.mass[face] >= 0.0 : flux.mass[face] <= 0.0) return;
  flux.mass[face] = 0.0;
  flux.tangential[face] = 0.0;
  flux.momentum_lower[face] = flux.momentum_upper[face] = 0.5 * gravity_ * depth * depth;
}

void ShallowWaterSolver::update_cells(const ShallowWaterStep& step) {
  const auto stride = static_cast<std::ptrdiff_t>(grid_.stride);
  pool_.run_blocks(grid_.rows, kRowsPerBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t j = first; j < last; ++j) {
      const std::size_t row = grid_.row(j);
      limit_outflow_row(step, state_.depth.data() + row, mass_x_.data() + row,
                        plane_ ? mass_y_.data() + row : nullptr, stride, grid_.columns, share_.data() + row);
    }
  });
  pool_.run_blocks(grid_.rows, kRowsPerBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t j = first; j < last; ++j) {
      const std::size_t row = grid_.row(j);
      const UpdateRow update{.old = state_row(j),
                             .share = share_.data() + row,
                             .mass_x = mass_x_.data() + row,
                             .flux_y = flux_y_row(j),
                             .gain_x = gain_x_.data() + row,
                             .gain_y = gain_y_.data() + row};
      update_row(step, update, stride, grid_.columns, next_.depth.data() + row, next_.velocity_x.data() + row,
                 next_.velocity_y.data() + row);
    }
  });
  state_.depth.swap(next_.depth);
  state_.velocity_x.swap(next_.velocity_x);
  state_.velocity_y.swap(next_.velocity_y);
}

/// Volume (m^3/s, in 2D m^2/s) that leaves through the open ends, after the outflow was limited.
double ShallowWaterSolver::outflow_rate() const {
  double sum = 0.0;
  const auto leaving = [&](double mass, std::size_t cell) { return mass * share_[cell]; };
  for (std::size_t j = 0; j < grid_.rows; ++j) {
    const std::size_t row = grid_.row(j);
    const std::size_t end = row + grid_.columns;
    if (is_open(kXMin)) sum -= leaving(mass_x_[row], row);
    if (is_open(kXMax)) sum += leaving(mass_x_[end], end - 1);
  }
  for (std::size_t i = 0; plane_ && i < grid_.columns; ++i) {
    const std::size_t last = grid_.index(i, grid_.rows - 1);
    if (is_open(kYMin)) sum -= leaving(mass_y_[grid_.index(i, 0)], grid_.index(i, 0));
    if (is_open(kYMax)) sum += leaving(mass_y_[last + grid_.stride], last);
  }
  return plane_ ? sum * grid_.cell_size : sum;
}

/// Sums over the state, row by row in order, so that they do not depend on the threads.
void ShallowWaterSolver::add_up() {
  ShallowWaterStep step;
  step.gravity = gravity_;
  step.plane = plane_;
  pool_.run_blocks(grid_.rows, kRowsPerBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t j = first; j < last; ++j) row_sums_[j] = sum_row(step, state_row(j), grid_.columns);
  });
  wave_speed_ = 0.0;
  double volume = 0.0;
  double energy = 0.0;
  for (std::size_t j = 0; j < grid_.rows; ++j) {
    const RowSums& sums = row_sums_[j];
    if (sums.invalid != 0.0 || !(sums.wave_speed < speed_limit_)) throw_blow_up(j);
    wave_speed_ = std::max(wave_speed_, sums.wave_speed);
    volume += sums.volume;
    energy += sums.kinetic + sums.potential;
  }
  volume_ = volume * cell_area();
  energy_ = energy * cell_area() * scene_.density;
  energy_gain_max_ = std::max(energy_gain_max_, energy_ - energy_lowest_);
  energy_lowest_ = std::min(energy_lowest_, energy_);
}

void ShallowWaterSolver::throw_blow_up(std::size_t j) const {
  std::size_t worst = 0;
  double fastest = -1.0;
  for (std::size_t i = 0; i < grid_.columns; ++i) {
    const std::size_t cell = grid_.index(i, j);
    const double speed = std::hypot(state_.velocity_x[cell], state_.velocity_y[cell]);
    const bool valid = std::isfinite(speed) && std::isfinite(state_.depth[cell]);
    if (valid && speed <= fastest) continue;
    worst = i;
    if (!valid) break;
    fastest = speed;
  }
  const std::size_t cell = grid_.index(worst, j);
  throw BlowUpError(fmt::format(
      "the run blew up at t = {:.6g} s, step {} (time step {:.4g} s): the cell at ({:.5g}, {:.5g}) m has a "
      "depth of {:.4g} m and velocity ({:.4g}, {:.4g}) m/s; speeds up to {:.4g} m/s are taken as physical. A "
      "smaller shallow_water.courant is the usual cure.",
      time_, steps_ + 1, attempted_step_, grid_.centre_x(worst), plane_ ? grid_.centre_y(j) : 0.0,
      state_.depth[cell], state_.velocity_x[cell], state_.velocity_y[cell], speed_limit_));
}

std::unique_ptr<Simulation> make_shallow_water(const Scene& scene, int threads) {
  return std::make_unique<ShallowWaterSolver>(scene, threads);
}

}  // namespace eisph
