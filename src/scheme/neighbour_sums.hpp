#pragma once

#include "scheme/particle_system.hpp"
#include "sph/pair_operators.hpp"

namespace eisph {

// The loops over the neighbours of a particle that the schemes share. Each is written once: a scheme that
// wants another combination of operators in one pass gives for_neighbours its own body. Functions with such a
// loop are flattened: compilers leave calls in them otherwise, through which packs go by way of memory.

template <int Dim>
inline Vector<Dim, Pack> components(const PackRows& rows) {
  if constexpr (Dim == 2) {
    return {{rows.x, rows.y}};
  } else {
    return {{rows.x, rows.y, rows.z}};
  }
}

template <int Dim>
inline Vector<Dim, Pack> splat_row(const Float4& row) {
  if constexpr (Dim == 2) {
    return {{splat<Pack>(row.x), splat<Pack>(row.y)}};
  } else {
    return {{splat<Pack>(row.x), splat<Pack>(row.y), splat<Pack>(row.z)}};
  }
}

/// Calls body(j, pair, w) for every pack of neighbours `near` of table row `row`: their indices, the
/// geometry of the pairs (a PairGeometry with the kernel of the scene) and the w of their positions.
template <int Dim, class Body>
inline void for_neighbours(const ParticleSystem<Dim>& particles, std::uint32_t row, const Neighbours& near,
                           const Body& body) {
  const Float4* const table = particles.table.position.data();
  const auto xi = splat_row<Dim>(table[row]);
  with_kernel(particles.scene.kernel, [&](auto kernel) {
    for (const std::uint32_t* j = near.begin; j != near.end; j += kPackWidth) {
      const PackRows positions = gather_rows(table, j);
      body(j, pair_geometry<Dim, Pack, decltype(kernel)>(xi, components<Dim>(positions)), positions.w);
    }
  });
}

/// The viscous terms of a particle. Artificial viscosity has Monaghan's form, which acts along the line of a
/// pair and leaves rotation alone. The fluid's own has that of Morris by morris_part, which is what a shear
/// flow needs (Monaghan's alone makes films on the lattice 19 to 28 % too fast), and Monaghan's for the rest,
/// which has the right stress on a free surface (Colagrossi, Antuono, Souto-Iglesias & Le Touze 2011;
/// Morris's alone lets the front of a thick fluid run 4 to 8 % too far). Both are pairwise opposite; that of
/// Morris is not central.
template <int Dim>
class ViscousTerms {
 public:
  explicit ViscousTerms(const ParticleSystem<Dim>& particles) : particles_(particles) {}

  template <class Pair>
  void add(const Pair& pair, const PackRows& neighbour, const Vector<Dim, Pack>& u) {
    const Vector<Dim, Pack> other = components<Dim>(neighbour);
    radial_.add(pair, neighbour.w, u, other);
    if (particles_.laminar_viscosity > 0.0) morris_.add(pair, neighbour.w, u, other);
  }
  /// Artificial viscosity alone, by what a pair adds to the divergence of u.
  template <class Pair>
  void add_artificial(const Pair& pair, const Pack& opening) {
    radial_.add(pair, -opening);
  }
  /// nu lap u, m/s^2.
  [[nodiscard]] Vector<Dim, double> acceleration() const {
    const double unit = 2.0 * particles_.alpha / (particles_.h * particles_.h);
    const double morris = particles_.morris_part * particles_.laminar_viscosity;
    const double radial = particles_.artificial_viscosity + particles_.laminar_viscosity - morris;
    Vector<Dim, double> sum;
    for (int d = 0; d < Dim; ++d) {
      sum.x[d] = unit * (Dim + 2) * radial * horizontal_sum(radial_.value.x[d]);
      if (morris > 0.0) sum.x[d] += unit * morris * horizontal_sum(morris_.value.x[d]);
    }
    return sum;
  }

 private:
  const ParticleSystem<Dim>& particles_;
  ViscousSum<Dim, Pack> radial_;
  VelocityLaplacianSum<Dim, Pack> morris_;
};

/// nu lap u of table row `row`, m/s^2.
template <int Dim>
inline Vector<Dim, double> viscous_acceleration(const ParticleSystem<Dim>& particles, std::uint32_t row) {
  const SourceTable& table = particles.table;
  const auto u = splat_row<Dim>(table.velocity[row]);
  ViscousTerms<Dim> terms(particles);
  for_neighbours<Dim>(particles, row, particles.neighbours.of(row),
                      [&](const std::uint32_t* j, const auto& pair, const Pack&) {
                        terms.add(pair, gather_rows(table.velocity.data(), j), u);
                      });
  return terms.acceleration();
}

/// What the pass over the neighbours for the pressure gradient finds.
template <int Dim>
struct PressureTerms {
  Vector<Dim, double> acceleration;  ///< m/s^2
  bool crowded;                      ///< another particle, image or solid is within the reach of separation
};

/// -(1/rho0) sum V_j (P_i + P_j) grad W_ij of table row `row`.
template <int Dim>
[[gnu::flatten]] inline PressureTerms<Dim> pressure_terms(const ParticleSystem<Dim>& particles,
                                                          std::uint32_t row, const Neighbours& near) {
  const SourceTable& table = particles.table;
  const Pack pressure = splat<Pack>(table.position[row].w);
  PressureGradientSum<Dim, Pack> sum;
  Pack nearest = splat<Pack>(kKernelSupport * kKernelSupport);
  const auto add = [&](const auto& pair, const Pack& other, const Pack& volume) {
    sum.add(pair, volume, pressure, other);
    nearest = lesser(nearest, pair.squared);
  };
  double factor = -particles.alpha / (particles.h * particles.scene.density);
  if (near.near_object) {
    for_neighbours<Dim>(particles, row, near,
                        [&](const std::uint32_t* j, const auto& pair, const Pack& other) {
                          add(pair, other, gather_rows(table.source.data(), j).w);
                        });
  } else {
    // All volumes are equal but those of objects.
    for_neighbours<Dim>(particles, row, near, [&](const std::uint32_t*, const auto& pair, const Pack& other) {
      add(pair, other, splat<Pack>(1.0));
    });
    factor *= particles.volume;
  }
  PressureTerms<Dim> terms;
  terms.crowded = select_below(nearest, static_cast<float>(particles.separation_squared)).count > 0;
  for (int d = 0; d < Dim; ++d) terms.acceleration.x[d] = factor * horizontal_sum(sum.value.x[d]);
  return terms;
}

/// Number density sum V_j W_ij of the fluid particle at table row `row`, with the volumes of `table.source`;
/// dimensionless.
template <int Dim>
inline double number_density(const ParticleSystem<Dim>& particles, std::uint32_t row,
                             const Neighbours& near) {
  DensitySum<Pack> sum;
  for_neighbours<Dim>(particles, row, near, [&](const std::uint32_t* j, const auto& pair, const Pack&) {
    sum.add(pair, gather_rows(particles.table.source.data(), j).w);
  });
  return particles.own_number_density() + particles.alpha * horizontal_sum(sum.value);
}

/// Gradient of the number density at table row `row`, 1/m.
template <int Dim>
inline Vector<Dim, double> concentration_gradient(const ParticleSystem<Dim>& particles, std::uint32_t row,
                                                  const Neighbours& near) {
  const SourceTable& table = particles.table;
  ConcentrationGradientSum<Dim, Pack> sum;
  for_neighbours<Dim>(particles, row, near, [&](const std::uint32_t* j, const auto& pair, const Pack&) {
    sum.add(pair, gather_rows(table.source.data(), j).w);
  });
  Vector<Dim, double> gradient;
  for (int d = 0; d < Dim; ++d)
    gradient.x[d] = particles.alpha / particles.h * horizontal_sum(sum.value.x[d]);
  return gradient;
}

/// Factor of all repulsion in this step.
template <int Dim>
inline double repulsion_scale(const ParticleSystem<Dim>& particles) {
  return repulsion_growth(particles.scene, particles.speed_max);
}

/// Adds the repulsion of walls and solids at `at` (m from the domain's lower corner) times `scale`, m/s^2.
template <int Dim>
inline void add_repulsion(const ParticleSystem<Dim>& particles, const std::array<double, Dim>& at,
                          bool near_object, double scale, std::array<double, Dim>& acceleration) {
  if (particles.virtual_particles.empty() && !near_object) return;
  std::array<double, Dim> push{};
  particles.virtual_particles.add_acceleration(at, push);
  if (near_object) {
    Vec3d from_objects = Vec3d::Zero();
    particles.solids.add_repulsion(particles.scene.domain_min + particles.scene_vector(at), from_objects);
    for (int d = 0; d < Dim; ++d) push[d] += from_objects[scene_axis<Dim>(d)];
  }
  for (int d = 0; d < Dim; ++d) acceleration[d] += scale * push[d];
}

}  // namespace eisph
