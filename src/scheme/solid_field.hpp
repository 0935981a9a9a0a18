#pragma once

#include "core/aligned_buffer.hpp"
#include "scheme/particle_system.hpp"

#include <cstddef>

namespace eisph {

/// What the particles of solids carry in the sums over the water before them, so that the surface half a
/// layer before the first of them acts as a wall: nothing flows through it, and water rests on it as it would
/// on a mirror. All of it is extrapolated from the fluid that the particle sees, with the kernel as weight
/// w_f (after Adami et al. 2012, J. Comput. Phys. 231), n being the outward normal of its surface:
///
///   u_j = U - 2 [(U - v_w) . n] n,  U = sum w_f u_f / sum w_f,  v_w the velocity of the solid,
///   P_j = the value at x_j of the plane in the directions along the surface that fits
///         P_f + rho0 (g . n) n . (x_j - x_f) best.
///
/// Gravity goes on inside the solid. Along the surface the fit finds the gradient that there is, hydrostatic
/// or not; across it the pressure rises as the part of gravity that the wall bears demands. Where the
/// particles do not spread along the surface the mean takes the place of the fit. In the sums of a row these
/// values are given; they have no equation of their own.
template <int Dim>
class SolidField {
 public:
  explicit SolidField(ParticleSystem<Dim>& particles) : particles_(particles) {}

  [[nodiscard]] bool empty() const { return particles_.objects() == 0; }

  /// The weights of the extrapolation and the means U, from the positions and velocities in the table. Comes
  /// before all others when these have changed.
  void find_weights();
  /// Puts u_j into the table. Not if water sticks to solids: then they have their own velocity there.
  void set_velocities();
  /// Puts s_j = omega u_j + time_step g into the table as the vector whose divergence drives the pressure.
  void set_sources(double omega, double time_step);

  /// P_j into the table, from the fluid's pressures in the table, and kept; clamped at zero if the scene has
  /// the clamp.
  void extrapolate();
  /// The same, but those kept, with which the next sweep starts, from the carried pressures of the fluid,
  /// which the volume correction is no part of.
  void extrapolate_twice();
  /// P_j without the clamp, and the part of it that depends on the fluid's pressures; into the table alone.
  void extrapolate_unclamped();
  void extrapolate_linear();

  [[nodiscard]] std::size_t bytes() const {
    return weights_.bytes() + rise_.bytes() + mean_velocity_.bytes();
  }

 private:
  /// u_j, m/s
  [[nodiscard]] Float4 mirrored_velocity(std::size_t k) const;
  void find_weights(std::size_t k);
  /// sum w_f (c - b . r_f) P_f / sum w_f of the pressures in the table, and of the carried ones if asked, Pa.
  template <bool Carried>
  [[nodiscard]] std::array<double, 2> extrapolated(std::size_t k) const;
  [[nodiscard]] Pack carried_pressures(const std::uint32_t* j) const;
  template <class Body>
  void for_wet(const Body& body);
  template <class Pressures>
  void put(const Pressures& pressures);
  /// What pressure(k) returns, unclamped and not kept.
  template <class Pressure>
  void put_into_table(const Pressure& pressure);
  [[nodiscard]] float clamped(double pressure) const;

  ParticleSystem<Dim>& particles_;
  // By object, in the order of the table.
  AlignedBuffer<Float4> weights_;        ///< b (per smoothing length) and c as w, over sum w_f
  AlignedBuffer<float> rise_;            ///< part of P_j that does not depend on the fluid's pressures, Pa
  AlignedBuffer<Float4> mean_velocity_;  ///< U, m/s
};

}  // namespace eisph
