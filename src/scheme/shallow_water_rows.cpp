// Compiled without errno and floating-point traps, so that the compiler can treat several cells at a time.

#include "scheme/shallow_water_rows.hpp"

#include "scheme/hllc_flux.hpp"
#include "scheme/manning_friction.hpp"
#include "scheme/slope_limiter.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

/// Limited differences of a cell along one axis.
struct Slopes {
  double depth = 0.0;
  double level = 0.0;
  double normal = 0.0;      ///< velocity along the axis
  double tangential = 0.0;  ///< velocity across it
};

/// Values of a cell or of a neighbour of it.
struct CellValues {
  double depth;
  double level;
  double normal;
  double tangential;
};

/// Beyond a wall the neighbour is the mirror image of the cell; a dry cell has no slopes.
template <SlopeLimiter Limiter>
inline Slopes limited_slopes(const CellValues& lower, const CellValues& cell, const CellValues& upper,
                             double open_lower, double open_upper, double wet) {
  const double reflected = 2.0 * cell.normal;
  const double from_lower = open_lower > 0.0 ? cell.normal - lower.normal : reflected;
  const double to_upper = open_upper > 0.0 ? upper.normal - cell.normal : -reflected;
  return {wet * limited_difference<Limiter>(open_lower * (cell.depth - lower.depth),
                                            open_upper * (upper.depth - cell.depth)),
          wet * limited_difference<Limiter>(open_lower * (cell.level - lower.level),
                                            open_upper * (upper.level - cell.level)),
          wet * limited_difference<Limiter>(from_lower, to_upper),
          wet * limited_difference<Limiter>(open_lower * (cell.tangential - lower.tangential),
                                            open_upper * (upper.tangential - cell.tangential))};
}

template <SlopeLimiter Limiter, bool Plane>
void reconstruct(const ShallowWaterStep& step, const StateRow& row, std::ptrdiff_t stride,
                 const double* __restrict open_x, const double* __restrict open_y, std::ptrdiff_t cells,
                 RowSides& sides, double* __restrict source_x, double* __restrict source_y) {
  const double* __restrict h = row.depth;
  const double* __restrict u = row.velocity_x;
  const double* __restrict v = row.velocity_y;
  const double* __restrict b = row.bed;
  double* __restrict depth[kSides];
  double* __restrict along_x[kSides];
  double* __restrict along_y[kSides];
  double* __restrict bed[kSides];
  for (std::size_t side = 0; side < kSides; ++side) {
    depth[side] = sides[side].depth();
    along_x[side] = sides[side].velocity_x();
    along_y[side] = sides[side].velocity_y();
    bed[side] = sides[side].bed();
  }
  const double half = 0.5 * step.time_step / step.cell_size;
  const double g = step.gravity;
  const double dry = step.dry_depth;
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < cells; ++i) {
    const auto x_values = [&](std::ptrdiff_t k) { return CellValues{h[k], h[k] + b[k], u[k], v[k]}; };
    const double wet = h[i] > dry ? 1.0 : 0.0;
    const Slopes x =
        limited_slopes<Limiter>(x_values(i - 1), x_values(i), x_values(i + 1), open_x[i], open_x[i + 1], wet);
    Slopes y;
    if constexpr (Plane) {
      const auto y_values = [&](std::ptrdiff_t k) { return CellValues{h[k], h[k] + b[k], v[k], u[k]}; };
      y = limited_slopes<Limiter>(y_values(i - stride), y_values(i), y_values(i + stride), open_y[i],
                                  open_y[i + stride], wet);
    }
    const double h_half = h[i] - half * (u[i] * x.depth + h[i] * x.normal + v[i] * y.depth + h[i] * y.normal);
    const double u_half = u[i] - half * (u[i] * x.normal + v[i] * y.tangential + g * x.level);
    const double v_half = v[i] - half * (u[i] * x.tangential + v[i] * y.normal + g * y.level);

    const double h_west = std::max(h_half - 0.5 * x.depth, 0.0);
    const double h_east = std::max(h_half + 0.5 * x.depth, 0.0);
    const double rise_x = x.level - x.depth;
    depth[kWest][i] = h_west;
    depth[kEast][i] = h_east;
    along_x[kWest][i] = u_half - 0.5 * x.normal;
    along_x[kEast][i] = u_half + 0.5 * x.normal;
    along_y[kWest][i] = v_half - 0.5 * x.tangential;
    along_y[kEast][i] = v_half + 0.5 * x.tangential;
    bed[kWest][i] = b[i] - 0.5 * rise_x;
    bed[kEast][i] = b[i] + 0.5 * rise_x;
    source_x[i] = -0.5 * g * (h_west + h_east) * rise_x;
    if constexpr (Plane) {
      const double h_south = std::max(h_half - 0.5 * y.depth, 0.0);
      const double h_north = std::max(h_half + 0.5 * y.depth, 0.0);
      const double rise_y = y.level - y.depth;
      depth[kSouth][i] = h_south;
      depth[kNorth][i] = h_north;
      along_y[kSouth][i] = v_half - 0.5 * y.normal;
      along_y[kNorth][i] = v_half + 0.5 * y.normal;
      along_x[kSouth][i] = u_half - 0.5 * y.tangential;
      along_x[kNorth][i] = u_half + 0.5 * y.tangential;
      bed[kSouth][i] = b[i] - 0.5 * rise_y;
      bed[kNorth][i] = b[i] + 0.5 * rise_y;
      source_y[i] = -0.5 * g * (h_south + h_north) * rise_y;
    } else {
      source_y[i] = 0.0;
    }
  }
}

void flux_row(double g, const StateRow& lower, const StateRow& upper, const double* lower_normal,
              const double* lower_tangential, const double* upper_normal, const double* upper_tangential,
              const double* __restrict open, std::size_t faces, const FluxRow& flux) {
  double* __restrict mass = flux.mass;
  double* __restrict momentum_lower = flux.momentum_lower;
  double* __restrict momentum_upper = flux.momentum_upper;
  double* __restrict tangential = flux.tangential;
  const double* __restrict h_lower = lower.depth;
  const double* __restrict z_lower = lower.bed;
  const double* __restrict h_upper = upper.depth;
  const double* __restrict z_upper = upper.bed;
#pragma GCC ivdep
  for (std::size_t i = 0; i < faces; ++i) {
    const FaceFlux through =
        face_flux(g, open[i], h_lower[i], lower_normal[i], lower_tangential[i], z_lower[i], h_upper[i],
                  upper_normal[i], upper_tangential[i], z_upper[i]);
    mass[i] = through.mass;
    momentum_lower[i] = through.momentum_left;
    momentum_upper[i] = through.momentum_right;
    tangential[i] = through.tangential;
  }
}

template <bool Plane>
void update(const ShallowWaterStep& step, const UpdateRow& row, std::ptrdiff_t stride, std::ptrdiff_t cells,
            double* __restrict depth, double* __restrict velocity_x, double* __restrict velocity_y) {
  const double* __restrict h = row.old.depth;
  const double* __restrict u = row.old.velocity_x;
  const double* __restrict v = row.old.velocity_y;
  const double* __restrict share = row.share;
  const double* __restrict mass_x = row.mass_x;
  const double* __restrict mass_y = row.flux_y.mass;
  const double* __restrict momentum_lower = row.flux_y.momentum_lower;
  const double* __restrict momentum_upper = row.flux_y.momentum_upper;
  const double* __restrict tangential = row.flux_y.tangential;
  const double* __restrict gain_x = row.gain_x;
  const double* __restrict gain_y = row.gain_y;
  const double ratio = step.time_step / step.cell_size;
  const double dry = step.dry_depth;
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < cells; ++i) {
    double q_x = h[i] * u[i] + gain_x[i];
    double q_y = h[i] * v[i] + gain_y[i];
    double outflow = 0.0;
    // `sign` is 1 for faces at the upper sides of the cell, where a positive flux leaves.
    const auto pass = [&](double flux, std::ptrdiff_t before, std::ptrdiff_t behind, double sign) {
      const bool forwards = flux > 0.0;
      const double passing = flux * (forwards ? share[before] : share[behind]);
      const double held = sign * (flux - passing);
      outflow += sign * passing;
      q_x += ratio * held * (forwards ? u[before] : u[behind]);
      q_y += ratio * held * (forwards ? v[before] : v[behind]);
    };
    pass(mass_x[i + 1], i, i + 1, 1.0);
    pass(mass_x[i], i - 1, i, -1.0);
    if constexpr (Plane) {
      pass(mass_y[i + stride], i, i + stride, 1.0);
      pass(mass_y[i], i - stride, i, -1.0);
      q_x -= ratio * (tangential[i + stride] - tangential[i]);
      q_y -= ratio * (momentum_lower[i + stride] - momentum_upper[i]);
    }
    const double h_new = std::max(h[i] - ratio * outflow, 0.0);
    const bool wet = h_new > dry;
    const double inverse = wet ? 1.0 / (wet ? h_new : 1.0) : 0.0;
    depth[i] = h_new;
    velocity_x[i] = q_x * inverse;
    velocity_y[i] = q_y * inverse;
  }
  if (step.manning == 0.0) return;
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < cells; ++i) {
    const double speed = std::sqrt(velocity_x[i] * velocity_x[i] + velocity_y[i] * velocity_y[i]);
    const double divisor =
        manning_divisor(step.gravity, step.manning, step.time_step, std::max(depth[i], dry), speed);
    velocity_x[i] /= divisor;
    velocity_y[i] /= divisor;
  }
}

}  // namespace

void reconstruct_row(const ShallowWaterStep& step, const StateRow& row, std::ptrdiff_t stride,
                     const double* open_x, const double* open_y, std::size_t cells, RowSides& sides,
                     double* source_x, double* source_y) {
  const auto count = static_cast<std::ptrdiff_t>(cells);
  const auto with = [&](auto function) {
    function(step, row, stride, open_x, open_y, count, sides, source_x, source_y);
  };
  constexpr auto kMinmod = SlopeLimiter::Minmod;
  constexpr auto kCentral = SlopeLimiter::MonotonisedCentral;
  if (step.limiter == kMinmod) {
    with(step.plane ? reconstruct<kMinmod, true> : reconstruct<kMinmod, false>);
  } else {
    with(step.plane ? reconstruct<kCentral, true> : reconstruct<kCentral, false>);
  }
}

void flux_row_x(const ShallowWaterStep& step, const StateRow& lower, const StateRow& upper,
                const double* open, std::size_t faces, const FluxRow& flux) {
  flux_row(step.gravity, lower, upper, lower.velocity_x, lower.velocity_y, upper.velocity_x, upper.velocity_y,
           open, faces, flux);
}

void flux_row_y(const ShallowWaterStep& step, const StateRow& lower, const StateRow& upper,
                const double* open, std::size_t faces, const FluxRow& flux) {
  flux_row(step.gravity, lower, upper, lower.velocity_y, lower.velocity_x, upper.velocity_y, upper.velocity_x,
           open, faces, flux);
}

void add_x_fluxes(const ShallowWaterStep& step, const FluxRow& flux, std::size_t cells,
                  double* __restrict gain_x, double* __restrict gain_y) {
  const double ratio = step.time_step / step.cell_size;
  const double* __restrict lower = flux.momentum_lower;
  const double* __restrict upper = flux.momentum_upper;
  const double* __restrict tangential = flux.tangential;
  for (std::size_t i = 0; i < cells; ++i) {
    gain_x[i] = ratio * (gain_x[i] - (lower[i + 1] - upper[i]));
    gain_y[i] = ratio * (gain_y[i] - (tangential[i + 1] - tangential[i]));
  }
}

void limit_outflow_row(const ShallowWaterStep& step, const double* __restrict depth,
                       const double* __restrict mass_x, const double* __restrict mass_y,
                       std::ptrdiff_t stride, std::size_t cells, double* __restrict share) {
  const double ratio = step.time_step / step.cell_size;
  const auto count = static_cast<std::ptrdiff_t>(cells);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    double leaving = std::max(mass_x[i + 1], 0.0) + std::max(-mass_x[i], 0.0);
    if (mass_y != nullptr) leaving += std::max(mass_y[i + stride], 0.0) + std::max(-mass_y[i], 0.0);
    leaving *= ratio;
    const bool drained = leaving > depth[i];
    share[i] = drained ? depth[i] / (drained ? leaving : 1.0) : 1.0;
  }
}

void update_row(const ShallowWaterStep& step, const UpdateRow& row, std::ptrdiff_t stride, std::size_t cells,
                double* depth, double* velocity_x, double* velocity_y) {
  const auto count = static_cast<std::ptrdiff_t>(cells);
  if (step.plane) {
    update<true>(step, row, stride, count, depth, velocity_x, velocity_y);
  } else {
    update<false>(step, row, stride, count, depth, velocity_x, velocity_y);
  }
}

RowSums sum_row(const ShallowWaterStep& step, const StateRow& row, std::size_t cells) {
  constexpr std::size_t kLanes = 8;
  double speed[kLanes] = {};
  double volume[kLanes] = {};
  double kinetic[kLanes] = {};
  double potential[kLanes] = {};
  double invalid[kLanes] = {};
  const double axes = step.plane ? 2.0 : 1.0;
  const double g = step.gravity;
  const auto add = [&](std::size_t i, std::size_t lane) {
    const double h = row.depth[i];
    const double u = row.velocity_x[i];
    const double v = row.velocity_y[i];
    const double wave = std::abs(u) + std::abs(v) + axes * std::sqrt(g * h);
    speed[lane] = wave > speed[lane] ? wave : speed[lane];
    volume[lane] += h;
    kinetic[lane] += 0.5 * h * (u * u + v * v);
    potential[lane] += g * h * (row.bed[i] + 0.5 * h);
    invalid[lane] += wave - wave;  // not zero for infinity and not-a-number
  };
  std::size_t i = 0;
  for (; i + kLanes <= cells; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) add(i + lane, lane);
  }
  for (std::size_t lane = 0; i < cells; ++i, ++lane) add(i, lane);
  RowSums sums;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    sums.wave_speed = std::max(sums.wave_speed, speed[lane]);
    sums.volume += volume[lane];
    sums.kinetic += kinetic[lane];
    sums.potential += potential[lane];
    sums.invalid += invalid[lane];
  }
  return sums;
}

}  // namespace eisph
