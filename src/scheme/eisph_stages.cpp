#include "scheme/eisph_solver.hpp"
#include "scheme/time_step.hpp"
#include "sph/pair_operators.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 512;
/// A particle whose sum of coefficients is below this part of the lattice's has no pressure.
constexpr double kCoefficientThreshold = 0.25;

template <int Dim>
Vector<Dim, Pack> components(const PackRows& rows) {
  if constexpr (Dim == 2) {
    return {{rows.x, rows.y}};
  } else {
    return {{rows.x, rows.y, rows.z}};
  }
}

template <int Dim>
Vector<Dim, Pack> splat_row(const Float4& row) {
  if constexpr (Dim == 2) {
    return {{splat<Pack>(row.x), splat<Pack>(row.y)}};
  } else {
    return {{splat<Pack>(row.x), splat<Pack>(row.y), splat<Pack>(row.z)}};
  }
}

}  // namespace

/// Repulsion grows with the square of the largest speed, as the step shrinks with that speed: a push stays
/// the same fraction of dx per step (thesis (3.40): c^2 is of the scale of the square of the largest
/// velocity).
template <int Dim>
double EisphSolver<Dim>::repulsion_scale() const {
  const double reference = scene_.reference_speed();
  if (!(speed_max_ > reference) || reference <= 0.0) return 1.0;
  return speed_max_ * speed_max_ / (reference * reference);
}

/// a = g + viscosity + repulsion, and the vector whose divergence drives the pressure, s = omega u^n + dt a.
template <int Dim>
void EisphSolver<Dim>::accelerate(double time_step) {
  const double omega = scene_.scheme.source_factor;
  const bool viscous = viscosity_ > 0.0;
  const double scale = repulsion_scale();
  pool_.run_blocks(fluid_, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const auto row = static_cast<std::uint32_t>(table_.first_fluid + i);
      std::array<double, Dim> acceleration = gravity_;
      if (viscous) {
        const Vector<Dim, double> drag = viscous_acceleration(row);
        for (int d = 0; d < Dim; ++d) acceleration[d] += drag.x[d];
      }
      add_repulsion(i, scale, acceleration);
      const float* u = &table_.velocity[row].x;
      Float4 source{};
      for (int d = 0; d < Dim; ++d) {
        (&source.x)[d] = static_cast<float>(omega * u[d] + time_step * acceleration[d]);
      }
      source.w = static_cast<float>(volume_);
      table_.source[row] = source;
    }
  });
  fluid_images_.mirror_vectors(planes_, fluid_rows(table_.source), table_.source.data() + table_.first_image,
                               pool_);
}

template <int Dim>
void EisphSolver<Dim>::add_repulsion(std::size_t i, double scale,
                                     std::array<double, Dim>& acceleration) const {
  const bool near_object = neighbours_.of(static_cast<std::uint32_t>(table_.first_fluid + i)).near_object;
  if (virtual_particles_.empty() && !near_object) return;
  std::array<double, Dim> at;
  for (int d = 0; d < Dim; ++d) at[d] = position_[d][i];
  std::array<double, Dim> push{};
  virtual_particles_.add_acceleration(at, push);
  if (near_object) {
    Vec3d from_objects = Vec3d::Zero();
    solids_.add_repulsion(scene_.domain_min + scene_vector(at), from_objects);
    for (int d = 0; d < Dim; ++d) push[d] += from_objects[scene_axis<Dim>(d)];
  }
  for (int d = 0; d < Dim; ++d) acceleration[d] += scale * push[d];
}

template <int Dim>
Vector<Dim, double> EisphSolver<Dim>::viscous_acceleration(std::uint32_t row) const {
  const Neighbours near = neighbours_.of(row);
  const auto xi = splat_row<Dim>(table_.position[row]);
  const auto u = splat_row<Dim>(table_.velocity[row]);
  ViscousSum<Dim, Pack> sum;
  for (const std::uint32_t* j = near.begin; j != near.end; j += kPackWidth) {
    const PackRows velocities = gather_rows(table_.velocity.data(), j);
    const auto pair = pair_geometry<Dim, Pack>(xi, components<Dim>(gather_rows(table_.position.data(), j)));
    sum.add(pair, laplacian_weight(pair), velocities.w, u, components<Dim>(velocities));
  }
  const double factor = 2.0 * (Dim + 2) * viscosity_ * alpha_ / (h_ * h_);
  Vector<Dim, double> acceleration;
  for (int d = 0; d < Dim; ++d) acceleration.x[d] = factor * horizontal_sum(sum.value.x[d]);
  return acceleration;
}

template <int Dim>
template <bool WithDensity>
typename EisphSolver<Dim>::PressureSums EisphSolver<Dim>::pressure_sums(std::uint32_t row) const {
  const Neighbours near = neighbours_.of(row);
  const auto xi = splat_row<Dim>(table_.position[row]);
  const auto s = splat_row<Dim>(table_.source[row]);
  DensitySum<Pack> density;
  LaplacianSums<Pack> laplacian;
  DivergenceSum<Pack> divergence;
  for (const std::uint32_t* j = near.begin; j != near.end; j += kPackWidth) {
    const PackRows positions = gather_rows(table_.position.data(), j);
    const PackRows sources = gather_rows(table_.source.data(), j);
    const auto pair = pair_geometry<Dim, Pack>(xi, components<Dim>(positions));
    if constexpr (WithDensity) density.add(pair, sources.w);
    laplacian.add(pair, laplacian_weight(pair), sources.w, positions.w);
    divergence.add(pair, sources.w, s, components<Dim>(sources));
  }
  const double normalise = 1.0 / (lattice_.number_density);
  return {alpha_ * horizontal_sum(density.value) * normalise, -horizontal_sum(laplacian.coefficient),
          -horizontal_sum(laplacian.pressure), alpha_ / h_ * horizontal_sum(divergence.value)};
}

/// Free surface, or too few neighbours for a pressure. Solids have no free surface.
template <int Dim>
bool EisphSolver<Dim>::is_pressureless(const PressureSums& sums, bool object) const {
  const double lattice_coefficient = lattice_.laplacian / (2.0 * alpha_);
  return sums.coefficient < kCoefficientThreshold * lattice_coefficient ||
         (!object && sums.number_density < scene_.scheme.free_surface_threshold);
}

/// P_i = (B_i + sum A_ij P_j) / sum A_ij with B_i = div s / dt (thesis (3.38)); A is negative.
template <int Dim>
double EisphSolver<Dim>::relaxed_pressure(const PressureSums& sums, double time_step) const {
  const double right_side = scene_.density * h_ * h_ / (2.0 * alpha_) * sums.divergence / time_step;
  const double pressure = (sums.pressure - right_side) / sums.coefficient;
  return scene_.scheme.clamp_pressure ? std::max(0.0, pressure) : pressure;
}

template <int Dim>
void EisphSolver<Dim>::relax_pressure(double time_step) {
  const bool again = scene_.scheme.pressure_sweeps > 1;
  if (again) source_term_.resize(fluid_ + solids_.size());
  const double right_side = scene_.density * h_ * h_ / (2.0 * alpha_) / time_step;
  pool_.run_blocks(fluid_, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const PressureSums sums = pressure_sums<true>(static_cast<std::uint32_t>(table_.first_fluid + i));
      const bool free = is_pressureless(sums, false);
      pressure_[i] = free ? 0.0F : static_cast<float>(relaxed_pressure(sums, time_step));
      number_density_[i] = static_cast<float>(sums.number_density);
      coefficient_[i] = free ? 0.0F : static_cast<float>(sums.coefficient);
      if (again) source_term_[i] = static_cast<float>(right_side * sums.divergence);
    }
  });
  pool_.run_blocks(solids_.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const auto row = static_cast<std::uint32_t>(table_.first_object + k);
      object_pressure_[k] = 0.0F;
      object_coefficient_[k] = 0.0F;
      if (!neighbours_.is_wet(row)) continue;
      const PressureSums sums = pressure_sums<false>(row);
      if (is_pressureless(sums, true)) continue;
      object_pressure_[k] = static_cast<float>(relaxed_pressure(sums, time_step));
      object_coefficient_[k] = static_cast<float>(sums.coefficient);
      if (again) source_term_[fluid_ + k] = static_cast<float>(right_side * sums.divergence);
    }
  });
  for (int sweep = 1; sweep < scene_.scheme.pressure_sweeps; ++sweep) {
    publish_pressure(false);
    sweep_again();
  }
  correct_volume(time_step);
  publish_pressure(true);
}

/// -sum A_ij P_j rho0 h^2 / (2 alpha) with the pressures of the table.
template <int Dim>
double EisphSolver<Dim>::coefficient_pressure_sum(std::uint32_t row) const {
  const Neighbours near = neighbours_.of(row);
  const auto xi = splat_row<Dim>(table_.position[row]);
  LaplacianSums<Pack> laplacian;
  for (const std::uint32_t* j = near.begin; j != near.end; j += kPackWidth) {
    const PackRows positions = gather_rows(table_.position.data(), j);
    const Pack volume = near.near_object ? gather_rows(table_.source.data(), j).w : splat<Pack>(volume_);
    const auto pair = pair_geometry<Dim, Pack>(xi, components<Dim>(positions));
    laplacian.add(pair, laplacian_weight(pair), volume, positions.w);
  }
  return -horizontal_sum(laplacian.pressure);
}

/// A further Jacobi sweep with unchanged coefficients and right side.
template <int Dim>
void EisphSolver<Dim>::sweep_again() {
  const auto relax = [&](std::uint32_t row, float coefficient, float right_side) {
    if (coefficient == 0.0F) return 0.0F;
    const auto pressure = static_cast<float>((coefficient_pressure_sum(row) - right_side) / coefficient);
    return scene_.scheme.clamp_pressure ? std::max(0.0F, pressure) : pressure;
  };
  pool_.run_blocks(fluid_, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      pressure_[i] =
          relax(static_cast<std::uint32_t>(table_.first_fluid + i), coefficient_[i], source_term_[i]);
    }
  });
  pool_.run_blocks(solids_.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      object_pressure_[k] = relax(static_cast<std::uint32_t>(table_.first_object + k), object_coefficient_[k],
                                  source_term_[fluid_ + k]);
    }
  });
}

/// Pc_i = kappa max(0, n_i - 1) / (|sum A| dt^2): counts in the gradient and in the output, never in the next
/// sweep; not on the free surface and not on solids.
template <int Dim>
void EisphSolver<Dim>::correct_volume(double time_step) {
  const double kappa = volume_correction_factor(scene_, time_step, speed_max_);
  const double factor = kappa * scene_.density * h_ * h_ / (2.0 * alpha_ * time_step * time_step);
  pool_.run_blocks(fluid_, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      double pressure = pressure_[i];
      if (kappa > 0.0 && coefficient_[i] > 0.0F) {
        pressure += factor * std::max(0.0F, number_density_[i] - 1.0F) / coefficient_[i];
      }
      total_pressure_[i] = static_cast<float>(pressure);
    }
  });
}

/// Puts the new pressures into the table, for the images too.
template <int Dim>
void EisphSolver<Dim>::publish_pressure(bool with_correction) {
  const AlignedBuffer<float>& fluid = with_correction ? total_pressure_ : pressure_;
  Float4* rows = fluid_rows(table_.position);
  pool_.run_blocks(fluid_, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) rows[i].w = fluid[i];
  });
  pool_.run_blocks(solids_.size(), 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      table_.position[table_.first_object + k].w = object_pressure_[k];
      solids_.pressure(object_sort_.order()[k]) = object_pressure_[k];
    }
  });
  mirror_pressure();
}

template <int Dim>
void EisphSolver<Dim>::mirror_pressure() {
  object_images_.mirror_pressure(table_.position.data() + table_.first_object,
                                 table_.position.data() + table_.first_object_image, pool_);
  fluid_images_.mirror_pressure(fluid_rows(table_.position), table_.position.data() + table_.first_image,
                                pool_);
}

template <int Dim>
template <bool NearObject>
Vector<Dim, double> EisphSolver<Dim>::pressure_acceleration(std::uint32_t row, const Neighbours& near) const {
  const auto xi = splat_row<Dim>(table_.position[row]);
  const Pack pressure = splat<Pack>(table_.position[row].w);
  PressureGradientSum<Dim, Pack> sum;
  for (const std::uint32_t* j = near.begin; j != near.end; j += kPackWidth) {
    const PackRows positions = gather_rows(table_.position.data(), j);
    const auto pair = pair_geometry<Dim, Pack>(xi, components<Dim>(positions));
    // All volumes are equal but those of objects.
    const Pack volume = NearObject ? gather_rows(table_.source.data(), j).w : splat<Pack>(1.0);
    sum.add(pair, volume, pressure, positions.w);
  }
  const double factor = -alpha_ / (h_ * scene_.density) * (NearObject ? 1.0 : volume_);
  Vector<Dim, double> acceleration;
  for (int d = 0; d < Dim; ++d) acceleration.x[d] = factor * horizontal_sum(sum.value.x[d]);
  return acceleration;
}

/// u^{n+1} = u* - (dt/rho0) sum V_j (P_i + P_j) grad W_ij, and the new positions.
template <int Dim>
void EisphSolver<Dim>::apply_gradient(double time_step) {
  blocks_.assign((fluid_ + kBlock - 1) / kBlock, BlockSums{});
  pool_.run_blocks(fluid_, kBlock, [&](std::size_t first, std::size_t last, int) {
    BlockSums sums;
    for (std::size_t i = first; i < last; ++i) {
      const auto row = static_cast<std::uint32_t>(table_.first_fluid + i);
      const Neighbours near = neighbours_.of(row);
      const Vector<Dim, double> acceleration =
          near.near_object ? pressure_acceleration<true>(row, near) : pressure_acceleration<false>(row, near);
      update_particle(static_cast<std::uint32_t>(i), time_step, near.near_object, acceleration, sums);
    }
    blocks_[first / kBlock] = sums;
  });
  add_up(blocks_);
}

template <int Dim>
void EisphSolver<Dim>::update_particle(std::uint32_t i, double time_step, bool near_object,
                                       const Vector<Dim, double>& acceleration, BlockSums& sums) {
  const float* before = &table_.velocity[table_.first_fluid + i].x;
  const float* source = &table_.source[table_.first_fluid + i].x;
  const double omega = scene_.scheme.source_factor;
  const bool symplectic = scene_.scheme.stepping == Stepping::Symplectic;
  // Positions of the symplectic stepping go from half a step of the last length past its end to half a step
  // of the present length past the end of this one.
  const double drift = 1.5 * time_step - 0.5 * time_step_;
  std::array<double, Dim> velocity;
  std::array<double, Dim> position;
  double squared = 0.0;
  for (int d = 0; d < Dim; ++d) {
    const double predicted = source[d] - (omega - 1.0) * before[d];
    velocity[d] = predicted + time_step * acceleration.x[d];
    const double moved = symplectic ? drift * velocity[d] : 0.5 * time_step * (before[d] + velocity[d]);
    position[d] = position_[d][i] + moved;
    squared += velocity[d] * velocity[d];
  }
  if (!(squared < speed_limit_ * speed_limit_) && sums.bad_row == kNoRow) {
    sums.bad_row = i;
    sums.bad_velocity = velocity;
    for (int d = 0; d < Dim; ++d) sums.bad_position[d] = position_[d][i];
  }
  contain(position, velocity, near_object, sums);
  const double output_shift = symplectic ? -0.5 * time_step : 0.0;
  for (int d = 0; d < Dim; ++d) {
    position_[d][i] = position[d];
    velocity_[d][i] = static_cast<float>(velocity[d]);
    sums.kinetic += 0.5 * velocity[d] * velocity[d];
    sums.potential -= gravity_[d] * (position[d] + output_shift * velocity[d]);
  }
  sums.speed_squared_max = std::max(sums.speed_squared_max, squared);
  sums.number_density_max = std::max(sums.number_density_max, static_cast<double>(number_density_[i]));
}

/// Safety clamp: a particle beyond a wall or inside a solid is counted as a penetration and put back, without
/// the velocity that took it there. A particle that crosses a symmetry plane changes places with its mirror
/// image, which is no penetration.
template <int Dim>
void EisphSolver<Dim>::contain(std::array<double, Dim>& position, std::array<double, Dim>& velocity,
                               bool near_object, BlockSums& sums) const {
  bool penetrated = false;
  for (int d = 0; d < Dim; ++d) {
    const int axis = scene_axis<Dim>(d);
    const bool low = position[d] < 0.0;
    if (!low && !(position[d] > extent_[d])) continue;
    const FaceKind kind = scene_.faces[2 * axis + (low ? 0 : 1)].kind;
    if (kind == FaceKind::Open) continue;
    const double mirrored = (low ? 0.0 : 2.0 * extent_[d]) - position[d];
    position[d] = low ? std::min(mirrored, 0.5 * extent_[d]) : std::max(mirrored, 0.5 * extent_[d]);
    if (kind == FaceKind::Symmetry) {
      velocity[d] = -velocity[d];
      continue;
    }
    velocity[d] = low ? std::max(velocity[d], 0.0) : std::min(velocity[d], 0.0);
    penetrated = true;
  }
  if (near_object) {
    Vec3d point = scene_.domain_min + scene_vector(position);
    Vec3d normal = Vec3d::Zero();
    if (solids_.push_out(point, normal)) {
      penetrated = true;
      double inward = 0.0;
      for (int d = 0; d < Dim; ++d) inward += velocity[d] * normal[scene_axis<Dim>(d)];
      for (int d = 0; d < Dim; ++d) {
        const int axis = scene_axis<Dim>(d);
        position[d] = point[axis] - scene_.domain_min[axis];
        if (inward < 0.0) velocity[d] -= inward * normal[axis];
      }
    }
  }
  if (penetrated) ++sums.penetrations;
}

template void EisphSolver<2>::accelerate(double);
template void EisphSolver<3>::accelerate(double);
template void EisphSolver<2>::relax_pressure(double);
template void EisphSolver<3>::relax_pressure(double);
template EisphSolver<2>::PressureSums EisphSolver<2>::pressure_sums<false>(std::uint32_t) const;
template EisphSolver<3>::PressureSums EisphSolver<3>::pressure_sums<false>(std::uint32_t) const;
template void EisphSolver<2>::sweep_again();
template void EisphSolver<3>::sweep_again();
template void EisphSolver<2>::publish_pressure(bool);
template void EisphSolver<3>::publish_pressure(bool);
template void EisphSolver<2>::mirror_pressure();
template void EisphSolver<3>::mirror_pressure();
template double EisphSolver<2>::coefficient_pressure_sum(std::uint32_t) const;
template double EisphSolver<3>::coefficient_pressure_sum(std::uint32_t) const;
template void EisphSolver<2>::apply_gradient(double);
template void EisphSolver<3>::apply_gradient(double);

}  // namespace eisph
