#include "scheme/pressure_equation.hpp"

#include "scheme/time_step.hpp"
#include "sph/gradient_correction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
    : particles_(particles), keeps_source_(keeps_source) {
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
}

template <int Dim>
template <bool WithDensity>
typename PressureEquation<Dim>::Sums PressureEquation<Dim>::sums(std::uint32_t row) const {
  const SourceTable& table = particles_.table;
  const auto s = splat_row<Dim>(table.source[row]);
  DensitySum<Pack> density;
  LaplacianSums<Pack> laplacian;
  DivergenceSum<Pack> divergence;
  for_neighbours<Dim>(particles_, row, particles_.neighbours.of(row),
                      [&](const std::uint32_t* j, const auto& pair, const Pack& pressure) {
                        const PackRows sources = gather_rows(table.source.data(), j);
                        if constexpr (WithDensity) density.add(pair, sources.w);
                        laplacian.add(pair, laplacian_weight(pair), sources.w, pressure);
                        divergence.add(pair, sources.w, s, components<Dim>(sources));
                      });
  const double normalise = 1.0 / particles_.lattice.number_density;
  return {particles_.alpha * horizontal_sum(density.value) * normalise,
          -horizontal_sum(laplacian.coefficient), -horizontal_sum(laplacian.pressure),
          particles_.alpha / particles_.h * horizontal_sum(divergence.value)};
}

/// Free surface that is not being compressed, or too few neighbours for a pressure. Solids have no free
/// surface.
template <int Dim>
bool PressureEquation<Dim>::is_pressureless(const Sums& sums, double time_step, bool object) const {
  if (sums.coefficient < kCoefficientThreshold * lattice_coefficient()) return true;
  if (object || sums.number_density >= particles_.scene.scheme.free_surface_threshold) return false;
  return !sheets_push_ || sums.number_density <= kSheetThreshold || sums.divergence * time_step >= -kDeadZone;
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
  ParticleSystem<Dim>& p = particles_;
  const std::size_t objects = p.objects();
  coefficient_.resize(p.fluid);
  object_pressure_.resize(objects);
  object_coefficient_.resize(objects);
  if (keeps_source_) source_term_.resize(unknowns());
  const double right_side = source_factor() / time_step;
  p.count_pass();
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      Sums row = sums<true>(p.fluid_row(i));
      const bool free = is_pressureless(row, time_step, false);
      row.coefficient = std::max(row.coefficient, least_coefficient_);
      p.carried[i] = free ? 0.0F : static_cast<float>(relaxed(row, time_step));
      p.number_density[i] = static_cast<float>(row.number_density);
      coefficient_[i] = free ? 0.0F : static_cast<float>(row.coefficient);
      if (keeps_source_) source_term_[i] = static_cast<float>(right_side * row.divergence);
    }
  });
  p.pool.run_blocks(objects, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      object_pressure_[k] = 0.0F;
      object_coefficient_[k] = 0.0F;
      if (!p.neighbours.is_wet(p.object_row(k))) continue;
      const Sums row = sums<false>(p.object_row(k));
      if (is_pressureless(row, time_step, true)) continue;
      object_pressure_[k] = static_cast<float>(relaxed(row, time_step));
      object_coefficient_[k] = static_cast<float>(row.coefficient);
      if (keeps_source_) source_term_[p.fluid + k] = static_cast<float>(right_side * row.divergence);
    }
  });
  if (!p.scene.scheme.clamp_pressure && is_closed()) remove_mean_pressure();
}

template <int Dim>
bool PressureEquation<Dim>::is_closed() const {
  const float* first = coefficient_.data();
  return std::find(first, first + particles_.fluid, 0.0F) == first + particles_.fluid;
}

/// In a closed domain the pressure is known up to a constant: that of mean zero over the fluid.
template <int Dim>
void PressureEquation<Dim>::remove_mean_pressure() {
  double sum = 0.0;
  for (std::size_t i = 0; i < particles_.fluid; ++i) sum += particles_.carried[i];
  const auto mean = static_cast<float>(sum / particles_.fluid);
  for (std::size_t i = 0; i < particles_.fluid; ++i) particles_.carried[i] -= mean;
  for (std::size_t k = 0; k < particles_.objects(); ++k) {
    if (object_coefficient_[k] != 0.0F) object_pressure_[k] -= mean;
  }
}

/// And it has a solution only if the sources add up to zero.
template <int Dim>
void PressureEquation<Dim>::remove_mean_source() {
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < unknowns(); ++k) {
    if (coefficient_of(k) == 0.0F) continue;
    const double weight = particles_.table.source[unknown_row(k)].w;
    sum += weight * source_term_[k];
    weights += weight;
  }
  for (std::size_t k = 0; k < unknowns(); ++k) source_term_[k] -= static_cast<float>(sum / weights);
}

/// -sum A_ij P_j rho0 h^2 / (2 alpha) with the pressures of the table.
template <int Dim>
double PressureEquation<Dim>::coefficient_pressure_sum(std::uint32_t row) const {
  const SourceTable& table = particles_.table;
  const Neighbours near = particles_.neighbours.of(row);
  const Pack fluid_volume = splat<Pack>(particles_.volume);
  LaplacianSums<Pack> laplacian;
  for_neighbours<Dim>(
      particles_, row, near, [&](const std::uint32_t* j, const auto& pair, const Pack& pressure) {
        const Pack volume = near.near_object ? gather_rows(table.source.data(), j).w : fluid_volume;
        laplacian.add(pair, laplacian_weight(pair), volume, pressure);
      });
  return -horizontal_sum(laplacian.pressure);
}

template <int Dim>
void PressureEquation<Dim>::sweep_again() {
  publish(false);
  particles_.count_pass();
  particles_.pool.run_blocks(unknowns(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const float coefficient = coefficient_of(k);
      float pressure = 0.0F;
      if (coefficient != 0.0F) {
        const double sum = coefficient_pressure_sum(unknown_row(k));
        const double density = k < particles_.fluid ? particles_.number_density[k] : 1.0;
        pressure = static_cast<float>(bounded((sum - source_term_[k]) / coefficient, density));
      }
      pressure_of(k) = pressure;
    }
  });
}

/// Sums over images fold back onto their particles, which keeps the matrix symmetric once each row is
/// weighted with the particle's volume.
template <int Dim>
int PressureEquation<Dim>::solve(double tolerance, int most_iterations) {
  ParticleSystem<Dim>& p = particles_;
  const std::size_t count = unknowns();
  for (std::vector<double>* array : {&diagonal_, &pressure_, &residual_, &direction_, &product_}) {
    array->assign(count, 0.0);
  }
  const auto each = [&](const auto& body) {
    p.pool.run_blocks(count, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) {
        if (coefficient_of(k) != 0.0F) body(k);
      }
    });
  };
  const bool closed = is_closed();
  if (closed) remove_mean_source();
  // Sums block by block, so that they do not depend on the number of threads.
  const auto sum = [&](const auto& term) {
    block_sums_.assign((count + kBlock - 1) / kBlock, 0.0);
    p.pool.run_blocks(count, kBlock, [&](std::size_t first, std::size_t last, int) {
      double block = 0.0;
      for (std::size_t k = first; k < last; ++k) {
        if (coefficient_of(k) != 0.0F) block += term(k);
      }
      block_sums_[first / kBlock] = block;
    });
    double total = 0.0;
    for (double block : block_sums_) total += block;
    return total;
  };
  const auto weight = [&](std::size_t k) { return p.table.source[unknown_row(k)].w / p.volume; };
  const auto weighted_sum = [&](std::size_t k) {
    return weight(k) * coefficient_pressure_sum(unknown_row(k));
  };

  publish(false);
  p.count_pass();
  each([&](std::size_t k) {
    diagonal_[k] = weight(k) * coefficient_of(k);
    pressure_[k] = pressure_of(k);
    const double right_side = -weight(k) * source_term_[k];
    residual_[k] = right_side - (diagonal_[k] * pressure_[k] - weighted_sum(k));
    product_[k] = right_side;
  });
  const double target =
      tolerance * tolerance * sum([&](std::size_t k) { return product_[k] * product_[k] / diagonal_[k]; });
  double energy = sum([&](std::size_t k) { return residual_[k] * residual_[k] / diagonal_[k]; });
  each([&](std::size_t k) { direction_[k] = residual_[k] / diagonal_[k]; });
  int iteration = 0;
  for (; iteration < most_iterations && energy > target; ++iteration) {
    p.pool.run_blocks(count, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) {
        p.table.position[unknown_row(k)].w = static_cast<float>(direction_[k]);
      }
    });
    p.mirror_pressure();
    p.count_pass();
    each([&](std::size_t k) { product_[k] = diagonal_[k] * direction_[k] - weighted_sum(k); });
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
  const bool clamp = p.scene.scheme.clamp_pressure;
  // Without a free surface the lowest pressure is the level that a clamp at zero would set.
  const double level =
      closed && clamp ? *std::min_element(pressure_.begin(), pressure_.begin() + p.fluid) : 0.0;
  each([&](std::size_t k) {
    const double pressure = pressure_[k] - level;
    pressure_of(k) = static_cast<float>(clamp ? std::max(0.0, pressure) : pressure);
  });
  if (closed && !clamp) remove_mean_pressure();
  return iteration;
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
  p.pool.run_blocks(p.objects(), 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      p.table.position[p.object_row(k)].w = object_pressure_[k];
      p.kept_object_pressure(k) = object_pressure_[k];
    }
  });
  p.mirror_pressure();
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
  const bool moves = p.speed_max > 0.0;
  source_term_.resize(unknowns());
  p.pool.run_blocks(unknowns(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      if (coefficient_of(k) == 0.0F) continue;
      double source = sums<false>(unknown_row(k)).divergence;
      if (moves && k < p.fluid) source -= convective_source(p, unknown_row(k));
      source_term_[k] = static_cast<float>(source_factor() * source);
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
  for (std::size_t k = 0; k < p.objects(); ++k) {
    if (!p.neighbours.is_wet(p.object_row(k))) continue;
    const double height = p.h * (&p.table.position[p.object_row(k)].x)[Dim - 1];
    object_pressure_[k] = static_cast<float>(weight * std::max(0.0, top - height));
  }
}

template <int Dim>
void PressureEquation<Dim>::find_initial_pressure() {
  // Density and coefficients; the pressures of this sweep are replaced.
  set_source(1.0);
  sheets_push_ = false;
  relax(1.0);
  sheets_push_ = true;
  particles_.carried.fill(0.0F);
  object_pressure_.fill(0.0F);
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
