#include "scheme/eisph_solver.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 512;
constexpr int kMostIterations = 3000;
constexpr double kResidualReduction = 1e-5;
/// Sweeps after the linear solution, that settle where the clamp at zero acts.
constexpr int kClampedSweeps = 100;

}  // namespace

/// The pressure equation of the instant t = 0 solved to convergence, with the gates as they stand then: the
/// divergence is that of the acceleration without pressure. Conjugate gradients over the particles that have
/// a pressure (sums over images fold back onto their particles, which keeps the matrix symmetric once each
/// row is weighted with the particle's volume), then clamped sweeps.
template <int Dim>
void EisphSolver<Dim>::solve_initial_pressure() {
  const auto objects = static_cast<std::uint32_t>(solids_.size());
  const std::size_t unknowns = fluid_ + objects;
  source_term_.resize(unknowns);
  // Source of a unit time step without the initial velocities: dt a alone.
  const double omega = scene_.scheme.source_factor;
  for (std::uint32_t i = 0; i < fluid_; ++i) {
    const float* u = &table_.velocity[table_.first_fluid + i].x;
    for (int d = 0; d < Dim; ++d) {
      (&table_.source[table_.first_fluid + i].x)[d] -= static_cast<float>(omega * u[d]);
    }
  }
  fluid_images_.mirror_vectors(planes_, fluid_rows(table_.source), table_.source.data() + table_.first_image,
                               pool_);
  const auto row_of = [&](std::size_t k) {
    return static_cast<std::uint32_t>(k < fluid_ ? table_.first_fluid + k
                                                 : table_.first_object + (k - fluid_));
  };
  std::vector<double> weight(unknowns, 0.0);
  std::vector<double> diagonal(unknowns, 0.0);
  std::vector<double> residual(unknowns, 0.0);
  const double right_side = scene_.density * h_ * h_ / (2.0 * alpha_);
  pool_.run_blocks(unknowns, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t row = row_of(k);
      const float coefficient = k < fluid_ ? coefficient_[k] : object_coefficient_[k - fluid_];
      if (coefficient == 0.0F) continue;
      const double divergence = pressure_sums<false>(row).divergence;
      source_term_[k] = static_cast<float>(right_side * divergence);
      weight[k] = table_.source[row].w / volume_;
      diagonal[k] = weight[k] * coefficient;
      residual[k] = -weight[k] * right_side * divergence;
    }
  });

  const auto dot = [&](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < unknowns; ++k) sum += a[k] * b[k];
    return sum;
  };
  std::vector<double> pressure(unknowns, 0.0);
  std::vector<double> direction(unknowns, 0.0);
  std::vector<double> product(unknowns, 0.0);
  std::vector<double> preconditioned(unknowns, 0.0);
  const auto precondition = [&] {
    for (std::size_t k = 0; k < unknowns; ++k) {
      preconditioned[k] = diagonal[k] > 0.0 ? residual[k] / diagonal[k] : 0.0;
    }
  };
  precondition();
  direction = preconditioned;
  double energy = dot(residual, preconditioned);
  const double target = energy * kResidualReduction * kResidualReduction;
  for (int iteration = 0; iteration < kMostIterations && energy > target; ++iteration) {
    for (std::size_t k = 0; k < unknowns; ++k) {
      table_.position[row_of(k)].w = static_cast<float>(direction[k]);
    }
    mirror_pressure();
    pool_.run_blocks(unknowns, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) {
        if (diagonal[k] > 0.0) {
          product[k] = diagonal[k] * direction[k] - weight[k] * coefficient_pressure_sum(row_of(k));
        }
      }
    });
    const double curvature = dot(direction, product);
    if (!(curvature > 0.0)) break;
    const double length = energy / curvature;
    for (std::size_t k = 0; k < unknowns; ++k) {
      pressure[k] += length * direction[k];
      residual[k] -= length * product[k];
    }
    precondition();
    const double next = dot(residual, preconditioned);
    const double keep = next / energy;
    for (std::size_t k = 0; k < unknowns; ++k) direction[k] = preconditioned[k] + keep * direction[k];
    energy = next;
  }

  const auto store = [&](std::size_t k) {
    const double value = scene_.scheme.clamp_pressure ? std::max(0.0, pressure[k]) : pressure[k];
    return static_cast<float>(value);
  };
  for (std::size_t k = 0; k < fluid_; ++k) pressure_[k] = store(k);
  for (std::size_t k = fluid_; k < unknowns; ++k) object_pressure_[k - fluid_] = store(k);
  for (int sweep = 0; sweep < kClampedSweeps && scene_.scheme.clamp_pressure; ++sweep) {
    publish_pressure(false);
    sweep_again();
  }
  publish_pressure(false);
}

/// P = rho0 |g| times the depth below the highest water.
template <int Dim>
void EisphSolver<Dim>::set_hydrostatic_pressure() {
  double top = 0.0;
  for (std::uint32_t i = 0; i < fluid_; ++i) top = std::max(top, position_[Dim - 1][i]);
  top += 0.5 * scene_.particle_spacing;
  const double weight = scene_.density * scene_.gravity.norm();
  for (std::uint32_t i = 0; i < fluid_; ++i) {
    pressure_[i] = static_cast<float>(weight * (top - position_[Dim - 1][i]));
  }
  for (std::size_t k = 0; k < solids_.size(); ++k) {
    const float* xi = &table_.position[table_.first_object + k].x;
    const bool wet = neighbours_.is_wet(static_cast<std::uint32_t>(table_.first_object + k));
    object_pressure_[k] = wet ? static_cast<float>(weight * std::max(0.0, top - h_ * xi[Dim - 1])) : 0.0F;
  }
  publish_pressure(false);
}

template void EisphSolver<2>::solve_initial_pressure();
template void EisphSolver<3>::solve_initial_pressure();
template void EisphSolver<2>::set_hydrostatic_pressure();
template void EisphSolver<3>::set_hydrostatic_pressure();

}  // namespace eisph
