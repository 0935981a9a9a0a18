#include "scheme/pressure_equation.hpp"

#include "scheme/bicgstab.hpp"
#include "scheme/time_step.hpp"
#include "sph/gradient_correction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 512;
/// A particle whose sum of coefficients is below this part of the lattice's has no pressure.
constexpr double kCoefficientThreshold = 0.25;
/// Below the free-surface threshold a particle keeps its pressure while it is being compressed, dt div s
/// below the negative of kDeadZone, down to this number density: thin sheets and jets that strike push as
/// water does. Without the dead zone the noise of water at rest lifts its surface, by 1.2 to 2.2 % in 30 s.
constexpr double kSheetThreshold = 0.5;
constexpr double kDeadZone = 0.03;
constexpr int kMostInitialIterations = 3000;
constexpr double kInitialTolerance = 1e-5;
/// Sweeps after the linear solution of t = 0, that settle where the clamp at zero acts.
constexpr int kClampedSweeps = 100;

/// tr((grad u)^2) at table row `row`, 1/s^2: what the convection of a moving fluid adds to the source of its
/// pressure. Zero without enough neighbours.
template <int Dim>
double convective_source(const ParticleSystem<Dim>& particles, std::uint32_t row) {
  const SourceTable& table = particles.table;
  const auto u = splat_row<Dim>(table.velocity[row]);
  MomentSum<Dim, Pack> moments;
  std::array<ScalarGradientSum<Dim, Pack>, Dim> sums;
  for_neighbours<Dim>(particles, row, particles.neighbours.of(row),
                      [&](const std::uint32_t* j, const auto& pair, const Pack&) {
                        const PackRows velocities = gather_rows(table.velocity.data(), j);
                        const auto others = components<Dim>(velocities);
                        moments.add(pair, velocities.w);
                        for (int d = 0; d < Dim; ++d) sums[d].add(pair, velocities.w, others.x[d] - u.x[d]);
                      });
  const GradientCorrection<Dim> correction(moments, particles.alpha);
  if (!correction.regular()) return 0.0;
  typename GradientCorrection<Dim>::Matrix gradient;
  for (int d = 0; d < Dim; ++d) gradient.col(d) = correction.gradient(sums[d]) / particles.h;
  return (gradient * gradient).trace();
}

}  // namespace

template <int Dim>
PressureEquation<Dim>::PressureEquation(ParticleSystem<Dim>& particles, bool keeps_source)
    : particles_(particles), solids_(particles), keeps_source_(keeps_source) {
  double highest = -std::numeric_limits<double>::infinity();
  double lowest = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < particles.fluid; ++i) {
    double potential = 0.0;
    for (int d = 0; d < Dim; ++d) potential -= particles.gravity[d] * particles.position[d][i];
    highest = std::max(highest, potential);
    lowest = std::min(lowest, potential);
  }
  initial_head_ = std::max(0.0, highest - lowest);
  set_blow_bound();
}

template <int Dim>
void PressureEquation<Dim>::set_blow_bound() {
  const double speed = std::max(particles_.scene.expected_speed(), particles_.speed_max);
  blow_bound_.dynamic_pressure = particles_.scene.density * std::max(speed * speed, 2.0 * initial_head_);
}

template <int Dim>
void PressureEquation<Dim>::set_source(double time_step) {
  ParticleSystem<Dim>& p = particles_;
  set_blow_bound();
  const double omega = p.scene.scheme.source_factor;
  const bool viscous = p.is_viscous() && p.scene.scheme.viscous_source;
  const double scale = repulsion_scale(p);
  solids_.find_weights();
  if (viscous) p.count_pass();
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t row = p.fluid_row(i);
      std::array<double, Dim> acceleration = p.gravity;
      if (viscous) {
        const Vector<Dim, double> drag = viscous_acceleration(p, row);
        for (int d = 0; d < Dim; ++d) acceleration[d] += drag.x[d];
      }
      add_repulsion<Dim>(p, p.position_of(i), p.neighbours.of(row).near_object, scale, acceleration);
      const float* u = &p.table.velocity[row].x;
      Float4 source{};
      for (int d = 0; d < Dim; ++d) {
        (&source.x)[d] = static_cast<float>(omega * u[d] + time_step * acceleration[d]);
      }
      source.w = static_cast<float>(p.volume);
      p.table.source[row] = source;
    }
  });
  p.mirror_source();
  solids_.set_sources(omega, time_step);
}

/// The artificial viscosity takes what a pair adds to the divergence of s = omega u + dt a, over omega: g is
/// the same at both. Beside walls and solids, where a is not, and for the viscosity of the fluid, it takes
/// the velocities.
template <int Dim>
template <bool WithDensity, bool Viscous>
[[gnu::flatten]] typename PressureEquation<Dim>::Sums PressureEquation<Dim>::sums(std::uint32_t row,
                                                                                  Float4* drag) const {
  const SourceTable& table = particles_.table;
  const Neighbours near = particles_.neighbours.of(row);
  const auto s = splat_row<Dim>(table.source[row]);
  const auto u = splat_row<Dim>(table.velocity[row]);
  const bool by_velocity =
      Viscous && (near.near_object || near.near_image || particles_.laminar_viscosity > 0.0);
  ViscousTerms<Dim> viscous(particles_);
  DensitySum<Pack> density;
  LaplacianSums<Pack> laplacian;
  DivergenceSum<Pack> divergence;
  const auto add_up = [&](auto from_velocity) {
    for_neighbours<Dim>(particles_, row, near,
                        [&](const std::uint32_t* j, const auto& pair, const Pack& pressure) {
                          const PackRows sources = gather_rows(table.source.data(), j);
                          if constexpr (WithDensity) density.add(pair, sources.w);
                          laplacian.add(pair, sources.w, pressure);
                          const Pack opening = divergence.add(pair, sources.w, s, components<Dim>(sources));
                          if constexpr (from_velocity) {
                            viscous.add(pair, gather_rows(table.velocity.data(), j), u);
                          } else if constexpr (Viscous) {
                            viscous.add_artificial(pair, opening);
                          }
                        });
  };
  if (by_velocity) {
    add_up(std::bool_constant<Viscous>{});
  } else {
    add_up(std::false_type{});
  }
  if constexpr (Viscous) {
    const Vector<Dim, double> acceleration = viscous.acceleration();
    const double scale = by_velocity ? 1.0 : 1.0 / particles_.scene.scheme.source_factor;
    for (int d = 0; d < Dim; ++d) (&drag->x)[d] = static_cast<float>(scale * acceleration.x[d]);
  }
  const double normalise = 1.0 / particles_.lattice.number_density;
  return {(particles_.own_number_density() + particles_.alpha * horizontal_sum(density.value)) * normalise,
          -horizontal_sum(laplacian.coefficient), -horizontal_sum(laplacian.pressure),
          particles_.alpha / particles_.h * horizontal_sum(divergence.value)};
}

/// Free surface that is not being compressed, or too few neighbours for a pressure.
template <int Dim>
bool PressureEquation<Dim>::is_pressureless(const Sums& sums, double time_step) const {
  if (sums.coefficient < kCoefficientThreshold * lattice_coefficient()) return true;
  if (sums.number_density >= particles_.scene.scheme.free_surface_threshold) return false;
  // At t = 0 the surface has a pressure too.
  if (at_start_) return false;
  return sums.number_density <= kSheetThreshold || sums.divergence * time_step >= -kDeadZone;
}

template <int Dim>
double PressureEquation<Dim>::bounded(double pressure, double number_density) const {
  if (!particles_.scene.scheme.clamp_pressure) return pressure;
  return std::clamp(pressure, 0.0, blow_bound_.pressure(number_density));
}

/// P_i = (B_i + sum A_ij P_j) / sum A_ij with B_i = div s / dt (thesis (3.38)); A is negative.
template <int Dim>
double PressureEquation<Dim>::relaxed(const Sums& sums, double time_step) const {
  const double right_side = source_factor() * sums.divergence / time_step;
  return bounded((sums.pressure - right_side) / sums.coefficient, sums.number_density);
}

template <int Dim>
void PressureEquation<Dim>::relax(double time_step) {
  const ParticleSystem<Dim>& p = particles_;
  if (p.is_viscous() && !p.scene.scheme.viscous_source && !at_start_) {
    viscous_.resize(p.fluid);
    relax_fluid<true>(time_step);
  } else {
    viscous_.resize(0);
    relax_fluid<false>(time_step);
  }
}

template <int Dim>
template <bool Viscous>
void PressureEquation<Dim>::relax_fluid(double time_step) {
  ParticleSystem<Dim>& p = particles_;
  coefficient_.resize(p.fluid);
  if (keeps_source_) source_term_.resize(p.fluid);
  const double right_side = source_factor() / time_step;
  p.count_pass();
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      Sums row = sums<true, Viscous>(p.fluid_row(i), Viscous ? &viscous_[i] : nullptr);
      const bool free = is_pressureless(row, time_step);
      if (at_start_ && !free && row.number_density < p.scene.scheme.free_surface_threshold) {
        row.coefficient += 2.0 * std::max(0.0, lattice_coefficient() - row.coefficient);
      }
      row.coefficient = std::max(row.coefficient, least_coefficient_);
      p.carried[i] = free ? 0.0F : static_cast<float>(relaxed(row, time_step));
      p.number_density[i] = static_cast<float>(row.number_density);
      coefficient_[i] = free ? 0.0F : static_cast<float>(row.coefficient);
      if (keeps_source_) source_term_[i] = static_cast<float>(right_side * row.divergence);
    }
  });
  if (!p.scene.scheme.clamp_pressure && is_closed()) remove_mean_pressure();
}

template <int Dim>
bool PressureEquation<Dim>::is_closed() const {
  const double threshold = particles_.scene.scheme.free_surface_threshold;
  for (std::size_t i = 0; i < particles_.fluid; ++i) {
    if (coefficient_[i] == 0.0F || particles_.number_density[i] < threshold) return false;
  }
  return true;
}

/// In a closed domain the pressure is known up to a constant: that of mean zero over the fluid.
template <int Dim>
void PressureEquation<Dim>::remove_mean_pressure() {
  double sum = 0.0;
  for (std::size_t i = 0; i < particles_.fluid; ++i) sum += particles_.carried[i];
  const auto mean = static_cast<float>(sum / particles_.fluid);
  for (std::size_t i = 0; i < particles_.fluid; ++i) particles_.carried[i] -= mean;
}

/// And it has a solution only if the sources add up to zero.
template <int Dim>
void PressureEquation<Dim>::remove_mean_source() {
  double sum = 0.0;
  for (std::size_t i = 0; i < particles_.fluid; ++i) sum += source_term_[i];
  const auto mean = static_cast<float>(sum / particles_.fluid);
  for (std::size_t i = 0; i < particles_.fluid; ++i) source_term_[i] -= mean;
}

/// -sum A_ij P_j rho0 h^2 / (2 alpha) with the pressures of the table.
template <int Dim>
[[gnu::flatten]] double PressureEquation<Dim>::coefficient_pressure_sum(std::uint32_t row) const {
  const SourceTable& table = particles_.table;
  const Neighbours near = particles_.neighbours.of(row);
  const Pack fluid_volume = splat<Pack>(particles_.volume);
  LaplacianSums<Pack> laplacian;
  for_neighbours<Dim>(
      particles_, row, near, [&](const std::uint32_t* j, const auto& pair, const Pack& pressure) {
        const Pack volume = near.near_object ? gather_rows(table.source.data(), j).w : fluid_volume;
        laplacian.add(pair, volume, pressure);
      });
  return -horizontal_sum(laplacian.pressure);
}

template <int Dim>
void PressureEquation<Dim>::sweep_again() {
  publish(false);
  particles_.count_pass();
  particles_.pool.run_blocks(particles_.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      float pressure = 0.0F;
      if (coefficient_[i] != 0.0F) {
        const double sum = coefficient_pressure_sum(particles_.fluid_row(i));
        const double value = (sum - source_term_[i]) / coefficient_[i];
        pressure = static_cast<float>(bounded(value, particles_.number_density[i]));
      }
      particles_.carried[i] = pressure;
    }
  });
}

template <int Dim>
int PressureEquation<Dim>::solve(double tolerance, int most_iterations) {
  ParticleSystem<Dim>& p = particles_;
  const bool closed = is_closed();
  if (closed) remove_mean_source();
  const int iterations = solids_.empty() ? solve_symmetric(tolerance, most_iterations)
                                         : solve_with_solids(tolerance, most_iterations);
  const bool clamp = p.scene.scheme.clamp_pressure;
  // Without a free surface the lowest pressure is the level that a clamp at zero would set.
  const double level = closed && clamp ? *std::min_element(pressure_.begin(), pressure_.end()) : 0.0;
  for (std::size_t i = 0; i < p.fluid; ++i) {
    if (coefficient_[i] == 0.0F) continue;
    const double pressure = pressure_[i] - level;
    p.carried[i] = static_cast<float>(clamp ? std::max(0.0, pressure) : pressure);
  }
  if (closed && !clamp) remove_mean_pressure();
  return iterations;
}

/// Puts `pressure` into the rows of the fluid that have one.
template <int Dim>
void PressureEquation<Dim>::put_into_table(const std::vector<double>& pressure) {
  ParticleSystem<Dim>& p = particles_;
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      p.table.position[p.fluid_row(i)].w = static_cast<float>(pressure[i]);
    }
  });
  p.mirror_pressure();
}

/// Sums over images fold back onto their particles, which keeps the matrix symmetric.
template <int Dim>
int PressureEquation<Dim>::solve_symmetric(double tolerance, int most_iterations) {
  ParticleSystem<Dim>& p = particles_;
  const std::size_t count = p.fluid;
  for (std::vector<double>* array : {&diagonal_, &pressure_, &residual_, &direction_, &product_}) {
    array->assign(count, 0.0);
  }
  const auto each = [&](const auto& body) {
    p.pool.run_blocks(count, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) {
        if (coefficient_[k] != 0.0F) body(k);
      }
    });
  };
  // Sums block by block, so that they do not depend on the number of threads.
  const auto sum = [&](const auto& term) {
    block_sums_.assign((count + kBlock - 1) / kBlock, 0.0);
    p.pool.run_blocks(count, kBlock, [&](std::size_t first, std::size_t last, int) {
      double block = 0.0;
      for (std::size_t k = first; k < last; ++k) {
        if (coefficient_[k] != 0.0F) block += term(k);
      }
      block_sums_[first / kBlock] = block;
    });
    double total = 0.0;
    for (double block : block_sums_) total += block;
    return total;
  };

  publish(false);
  p.count_pass();
  each([&](std::size_t k) {
    diagonal_[k] = coefficient_[k];
    pressure_[k] = p.carried[k];
    const double right_side = -source_term_[k];
    residual_[k] = right_side - (diagonal_[k] * pressure_[k] - coefficient_pressure_sum(p.fluid_row(k)));
    product_[k] = right_side;
  });
  const double target =
      tolerance * tolerance * sum([&](std::size_t k) { return product_[k] * product_[k] / diagonal_[k]; });
  double energy = sum([&](std::size_t k) { return residual_[k] * residual_[k] / diagonal_[k]; });
  each([&](std::size_t k) { direction_[k] = residual_[k] / diagonal_[k]; });
  int iteration = 0;
  for (; iteration < most_iterations && energy > target; ++iteration) {
    put_into_table(direction_);
    p.count_pass();
    each([&](std::size_t k) {
      product_[k] = diagonal_[k] * direction_[k] - coefficient_pressure_sum(p.fluid_row(k));
    });
    const double curvature = sum([&](std::size_t k) { return direction_[k] * product_[k]; });
    if (!(curvature > 0.0)) break;
    const double length = energy / curvature;
    each([&](std::size_t k) {
      pressure_[k] += length * direction_[k];
      residual_[k] -= length * product_[k];
    });
    const double next = sum([&](std::size_t k) { return residual_[k] * residual_[k] / diagonal_[k]; });
    const double keep = next / energy;
    each([&](std::size_t k) { direction_[k] = residual_[k] / diagonal_[k] + keep * direction_[k]; });
    energy = next;
  }
  return iteration;
}

/// The rows divided by their diagonal: P_i - sum a_ij P_j / a_i = -b_i / a_i, where the P_j of solids are
/// sums of the fluid's and a constant part, which belongs to the right side.
template <int Dim>
int PressureEquation<Dim>::solve_with_solids(double tolerance, int most_iterations) {
  ParticleSystem<Dim>& p = particles_;
  const std::size_t count = p.fluid;
  const auto rows = [&](const auto& body) {
    p.count_pass();
    p.pool.run_blocks(count, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t i = first; i < last; ++i) {
        if (coefficient_[i] != 0.0F) body(i, coefficient_pressure_sum(p.fluid_row(i)) / coefficient_[i]);
      }
    });
  };
  const auto apply = [&](const std::vector<double>& in, std::vector<double>& out) {
    put_into_table(in);
    solids_.extrapolate_linear();
    rows([&](std::size_t i, double others) { out[i] = in[i] - others; });
  };
  BiCgStab solver(p.pool);
  pressure_.assign(count, 0.0);
  residual_.assign(count, 0.0);
  put_into_table(pressure_);
  solids_.extrapolate_unclamped();
  rows([&](std::size_t i, double others) { residual_[i] = others - source_term_[i] / coefficient_[i]; });
  const double target = tolerance * std::sqrt(solver.dot(residual_, residual_));
  bool moved = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (coefficient_[i] != 0.0F) pressure_[i] = p.carried[i];
    moved = moved || pressure_[i] != 0.0;
  }
  if (moved) {
    product_.assign(count, 0.0);
    apply(pressure_, product_);
    for (std::size_t i = 0; i < count; ++i) residual_[i] -= product_[i];
  }
  return solver.solve(pressure_, residual_, target, most_iterations, apply);
}

template <int Dim>
void PressureEquation<Dim>::correct_volume(double time_step) {
  ParticleSystem<Dim>& p = particles_;
  const double kappa = volume_correction_factor(p.scene, time_step, p.speed_max);
  const double factor = kappa * source_factor() / (time_step * time_step);
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      double pressure = p.carried[i];
      if (kappa > 0.0 && coefficient_[i] > 0.0F) {
        const double correction = factor * std::max(0.0F, p.number_density[i] - 1.0F) / coefficient_[i];
        pressure += std::min(correction, blow_bound_.volume_correction());
      }
      p.pressure[i] = static_cast<float>(pressure);
    }
  });
}

template <int Dim>
void PressureEquation<Dim>::publish(bool with_correction) {
  ParticleSystem<Dim>& p = particles_;
  const AlignedBuffer<float>& fluid = with_correction ? p.pressure : p.carried;
  Float4* rows = p.fluid_rows(p.table.position);
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) rows[i].w = fluid[i];
  });
  p.mirror_pressure();
  if (with_correction) {
    solids_.extrapolate_twice();
  } else {
    solids_.extrapolate();
  }
}

/// The right side of the instant t = 0: the divergence of the acceleration without pressure, less what the
/// fluid's motion makes of it, (div Du/Dt - tr((grad u)^2)), whatever the divergence of the velocity is.
template <int Dim>
void PressureEquation<Dim>::set_initial_source() {
  ParticleSystem<Dim>& p = particles_;
  const double omega = p.scene.scheme.source_factor;
  for (std::uint32_t i = 0; i < p.fluid; ++i) {
    const float* u = &p.table.velocity[p.fluid_row(i)].x;
    for (int d = 0; d < Dim; ++d) {
      (&p.table.source[p.fluid_row(i)].x)[d] -= static_cast<float>(omega * u[d]);
    }
  }
  p.mirror_source();
  solids_.set_sources(0.0, 1.0);
  const bool moves = p.speed_max > 0.0;
  source_term_.resize(p.fluid);
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      if (coefficient_[i] == 0.0F) continue;
      double source = sums<false>(p.fluid_row(i)).divergence;
      if (moves) source -= convective_source(p, p.fluid_row(i));
      source_term_[i] = static_cast<float>(source_factor() * source);
    }
  });
}

/// P = rho0 |g| times the depth below the highest water.
template <int Dim>
void PressureEquation<Dim>::set_hydrostatic_pressure() {
  ParticleSystem<Dim>& p = particles_;
  const double top = p.highest_particle() + 0.5 * p.scene.particle_spacing;
  const double weight = p.scene.density * p.scene.gravity.norm();
  for (std::uint32_t i = 0; i < p.fluid; ++i) {
    p.carried[i] = static_cast<float>(weight * (top - p.position[Dim - 1][i]));
  }
}

/// While water flows the particles on its surface have no pressure, which puts the surface of the pressure
/// half a spacing too low: for the instant t = 0 it lies where it should. Neighbours that a particle on the
/// surface lacks count as its own image with the opposite pressure, which doubles their coefficients.
template <int Dim>
void PressureEquation<Dim>::find_initial_pressure() {
  // Density and coefficients; the pressures of this sweep are replaced.
  at_start_ = true;
  set_source(1.0);
  relax(1.0);
  at_start_ = false;
  particles_.carried.fill(0.0F);
  switch (particles_.scene.scheme.initial_pressure) {
    case InitialPressure::Solve:
      set_initial_source();
      solve(kInitialTolerance, kMostInitialIterations);
      for (int sweep = 0; sweep < kClampedSweeps && particles_.scene.scheme.clamp_pressure; ++sweep) {
        sweep_again();
      }
      break;
    case InitialPressure::Hydrostatic:
      set_hydrostatic_pressure();
      break;
    case InitialPressure::Zero:
      break;
  }
  for (std::vector<double>* array : {&diagonal_, &pressure_, &residual_, &direction_, &product_}) *array = {};
  publish(false);
  for (std::uint32_t i = 0; i < particles_.fluid; ++i) particles_.pressure[i] = particles_.carried[i];
}

template class PressureEquation<2>;
template class PressureEquation<3>;

}  // namespace eisph
