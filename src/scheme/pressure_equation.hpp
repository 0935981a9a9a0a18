#pragma once

#include "scheme/blow_bound.hpp"
#include "scheme/neighbour_sums.hpp"
#include "scheme/particle_system.hpp"
#include "scheme/solid_field.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace eisph {

/// The pressure equation of incompressible SPH (thesis (3.38), De Castro 2019, section 3.3, as corrected):
/// P_i = (B_i + sum A_ij P_j) / sum A_ij with A_ij = (2/rho0) V_j x_ij . grad W_ij / (r^2 + eta^2) and
/// B_i = div s / dt, for the fluid that is not on the free surface, and what goes with it: the vector s whose
/// divergence drives it, and the correction of the volume. The fluid's pressures are the carried scalar of
/// the particles. Solids have those of the water before them (SolidField): a sweep uses what the sweep before
/// left; solve() takes them in.
template <int Dim>
class PressureEquation {
 public:
  /// `keeps_source`: whether relax() keeps the right side for sweep_again() and solve().
  PressureEquation(ParticleSystem<Dim>& particles, bool keeps_source);
  void keep_source(bool keeps) { keeps_source_ = keeps; }
  /// Coefficients of the fluid add up to this part of the lattice's at least: neighbours that are missing
  /// count as water at zero pressure, beyond the free surface (after Nair & Tomar 2014, Computers & Fluids
  /// 102). Without that, a few particles among which none is on the surface have next to nothing that bounds
  /// their pressure.
  void count_missing_neighbours(double part) { least_coefficient_ = part * lattice_coefficient(); }

  /// The source vectors s = omega u^n + dt a of the fluid with a = g + viscosity + repulsion.
  void set_source(double time_step);

  /// Density, coefficients and right side of the step, and one Jacobi sweep. On the way, viscosity that is
  /// not in the source: see viscous().
  void relax(double time_step);
  /// Viscous acceleration of fluid particle i that the source of the last step did not have, m/s^2; null if
  /// there is none.
  [[nodiscard]] const Float4* viscous(std::size_t i) const {
    return viscous_.size() > 0 ? &viscous_[i] : nullptr;
  }
  /// A further Jacobi sweep with unchanged coefficients and right side.
  void sweep_again();
  /// Solves the equation from the present pressures on until the residual has fallen to `tolerance` of what
  /// it would be with no pressure at all, preconditioned by the diagonal: by conjugate gradients, or with
  /// solids, whose pressures depend on those of the fluid and leave the matrix without symmetry, by BiCGStab.
  /// Returns the number of iterations; ends at `most_iterations`.
  int solve(double tolerance, int most_iterations);
  /// Adds Pc_i = kappa max(0, n_i - 1) / (|sum A| dt^2) for the gradient and the output; it never enters the
  /// next sweep, and does not act on the free surface and on solids.
  void correct_volume(double time_step);
  /// Puts the pressures into the table, for the images too; the fluid's with the correction or without.
  void publish(bool with_correction);

  /// The pressure of t = 0 by the choice of the scene, with the gates as they stand then: the equation solved
  /// to convergence, hydrostatic, or zero. Puts it into the table.
  void find_initial_pressure();

  [[nodiscard]] std::size_t bytes() const {
    return coefficient_.bytes() + source_term_.bytes() + viscous_.bytes() + solids_.bytes() +
           5 * pressure_.capacity() * sizeof(double);
  }

 private:
  /// What the equation needs to know of a row.
  struct Sums {
    double number_density;
    double coefficient;  ///< -sum A_ij rho0 h^2 / (2 alpha), positive
    double pressure;     ///< the same sum weighted with P_j, Pa
    double divergence;   ///< of the source vector, 1/s x s
  };
  /// With Viscous the viscous acceleration goes to `drag`.
  template <bool WithDensity, bool Viscous = false>
  [[nodiscard]] Sums sums(std::uint32_t row, Float4* drag = nullptr) const;
  template <bool Viscous>
  void relax_fluid(double time_step);
  [[nodiscard]] double coefficient_pressure_sum(std::uint32_t row) const;
  [[nodiscard]] bool is_pressureless(const Sums& sums, double time_step) const;
  [[nodiscard]] double relaxed(const Sums& sums, double time_step) const;
  /// `pressure` within what the scheme allows: not negative where the scene clamps it, and bounded in a blow.
  [[nodiscard]] double bounded(double pressure, double number_density) const;
  /// The bound on blows with the speeds of the moment.
  void set_blow_bound();
  /// Sums::coefficient of the undisturbed lattice.
  [[nodiscard]] double lattice_coefficient() const {
    return particles_.lattice.laplacian / (2.0 * particles_.alpha);
  }
  /// Factor of B_i in the units of Sums::coefficient, Pa s.
  [[nodiscard]] double source_factor() const {
    return particles_.scene.density * particles_.h * particles_.h / (2.0 * particles_.alpha);
  }

  /// Whether nothing holds the level of the pressure: there is no particle on a free surface.
  [[nodiscard]] bool is_closed() const;
  void remove_mean_pressure();
  void remove_mean_source();
  void set_initial_source();
  void set_hydrostatic_pressure();

  /// The two ways of solve(), to the pressures in pressure_.
  int solve_symmetric(double tolerance, int most_iterations);
  int solve_with_solids(double tolerance, int most_iterations);
  void put_into_table(const std::vector<double>& pressure);

  ParticleSystem<Dim>& particles_;
  SolidField<Dim> solids_;
  bool keeps_source_;
  double least_coefficient_ = 0.0;
  double initial_head_ = 0.0;  ///< of the water of t = 0, highest above lowest along gravity, m^2/s^2
  BlowBound blow_bound_;
  bool at_start_ = false;             ///< relax() is that of find_initial_pressure()
  AlignedBuffer<float> coefficient_;  ///< Sums::coefficient of the fluid, zero where there is no pressure
  AlignedBuffer<float> source_term_;  ///< right side of the equation, Pa
  AlignedBuffer<Float4> viscous_;     ///< viscous()
  // Of solve().
  std::vector<double> diagonal_, pressure_, residual_, direction_, product_, block_sums_;
};

}  // namespace eisph
