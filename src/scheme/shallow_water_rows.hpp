#pragma once

#include "core/aligned_buffer.hpp"
#include "core/scene.hpp"

#include <array>
#include <cstddef>

namespace eisph {

// The loops of the shallow-water scheme over one row of cells. Arrays are row-major with one ghost cell at
// each end; pointers are to the first inner cell of the row. Depth h (m), velocity u, v (m/s), bed b (m above
// the floor). Face i of a row lies at the lower side of cell i, and `open` is 0 where it is a wall.

/// Constants of a step.
struct ShallowWaterStep {
  double gravity = 9.81;   ///< m/s^2
  double time_step = 0.0;  ///< s
  double cell_size = 0.0;  ///< m
  double dry_depth = 0.0;  ///< m
  double manning = 0.0;    ///< s m^(-1/3)
  bool plane = true;       ///< two horizontal axes; else one
  SlopeLimiter limiter = SlopeLimiter::MonotonisedCentral;
};

/// One row of the state.
struct StateRow {
  const double* depth = nullptr;
  const double* velocity_x = nullptr;
  const double* velocity_y = nullptr;
  const double* bed = nullptr;
};

/// States at one side of the cells of a row, half a step ahead.
class SideRow {
 public:
  void resize(std::size_t stride) {
    for (AlignedBuffer<double>* values : {&depth_, &velocity_x_, &velocity_y_, &bed_}) {
      values->resize_exactly(stride);
      values->fill(0.0);
    }
  }
  [[nodiscard]] double* depth() { return depth_.data() + 1; }
  [[nodiscard]] double* velocity_x() { return velocity_x_.data() + 1; }
  [[nodiscard]] double* velocity_y() { return velocity_y_.data() + 1; }
  [[nodiscard]] double* bed() { return bed_.data() + 1; }
  [[nodiscard]] StateRow state(std::ptrdiff_t shift = 0) const {
    return {depth_.data() + 1 + shift, velocity_x_.data() + 1 + shift, velocity_y_.data() + 1 + shift,
            bed_.data() + 1 + shift};
  }
  [[nodiscard]] std::size_t bytes() const { return 4 * depth_.bytes(); }

 private:
  AlignedBuffer<double> depth_, velocity_x_, velocity_y_, bed_;
};

enum SideIndex : std::size_t { kWest = 0, kEast, kSouth, kNorth, kSides };
using RowSides = std::array<SideRow, kSides>;

/// Fluxes through the faces of a row.
struct FluxRow {
  double* mass = nullptr;            ///< m^2/s
  double* momentum_lower = nullptr;  ///< normal, out of the cell before the face, m^3/s^2
  double* momentum_upper = nullptr;  ///< normal, into the cell behind it, m^3/s^2
  double* tangential = nullptr;      ///< m^3/s^2
};

/// The reconstruction and the predictor of MUSCL-Hancock (van Leer 1984; in primitive variables, Toro 2001):
/// limited linear h, h + b, u and v in every cell, half a step ahead in time by
///
///   h_t = -(h u)_x - (h v)_y,   u_t = -u u_x - v u_y - g (h + b)_x,   v_t likewise.
///
/// The bed is what is left of h + b without h, so that still water stays still (Audusse et al. 2004). Also
/// gives the momentum (m^3/s^2) that the slope of the bed inside the cell adds: -g (h_W + h_E)(b_E - b_W)
/// / 2.
void reconstruct_row(const ShallowWaterStep& step, const StateRow& row, std::ptrdiff_t stride,
                     const double* open_x, const double* open_y, std::size_t cells, RowSides& sides,
                     double* source_x, double* source_y);

/// Fluxes along x through faces 0 to `faces` - 1: `lower` are the east sides of the cells before the faces,
/// `upper` the west sides of those behind them.
void flux_row_x(const ShallowWaterStep& step, const StateRow& lower, const StateRow& upper,
                const double* open, std::size_t faces, const FluxRow& flux);
/// Fluxes along y between two rows: the north sides of one, the south sides of the next.
void flux_row_y(const ShallowWaterStep& step, const StateRow& lower, const StateRow& upper,
                const double* open, std::size_t faces, const FluxRow& flux);

/// Gain of momentum over the step by the fluxes along x (m^2/s), sources included; source arrays are
/// replaced.
void add_x_fluxes(const ShallowWaterStep& step, const FluxRow& flux, std::size_t cells, double* gain_x,
                  double* gain_y);

/// The share of the outflow of a cell that its water allows: min(1, h dx / (dt sum of what leaves)), the
/// draining time of Bollermann, Noelle & Lukacova (2011).
void limit_outflow_row(const ShallowWaterStep& step, const double* depth, const double* mass_x,
                       const double* mass_y, std::ptrdiff_t stride, std::size_t cells, double* share);

/// What the end of a step needs of a row.
struct UpdateRow {
  StateRow old;
  const double* share = nullptr;   ///< limit_outflow_row
  const double* mass_x = nullptr;  ///< fluxes, m^2/s
  FluxRow flux_y;
  const double* gain_x = nullptr;  ///< add_x_fluxes
  const double* gain_y = nullptr;
};
/// The new state: fluxes times the share of the cell they leave (the momentum goes with the mass), then
/// friction.
void update_row(const ShallowWaterStep& step, const UpdateRow& row, std::ptrdiff_t stride, std::size_t cells,
                double* depth, double* velocity_x, double* velocity_y);

/// Sums over a row, per unit of cell area.
struct RowSums {
  double wave_speed = 0.0;  ///< largest sum over the axes of |u| + sqrt(g h), m/s
  double volume = 0.0;      ///< sum of h
  double kinetic = 0.0;     ///< sum of h (u^2 + v^2) / 2
  double potential = 0.0;   ///< sum of g h (b + h / 2)
  double invalid = 0.0;     ///< zero unless some value is no finite number
};
[[nodiscard]] RowSums sum_row(const ShallowWaterStep& step, const StateRow& row, std::size_t cells);

}  // namespace eisph
