#pragma once

#include <algorithm>
#include <cmath>

namespace eisph {

// Fluxes of the shallow-water equations through a face, per metre of its length. h is the depth (m), u the
// velocity normal to the face and v that along it (m/s), z the bed (m above the floor), g = |gravity|.

struct ShallowWaterFlux {
  double mass = 0.0;        ///< h u, m^2/s
  double momentum = 0.0;    ///< h u^2 + g h^2 / 2, m^3/s^2
  double tangential = 0.0;  ///< h u v, m^3/s^2
};

/// HLLC (Toro, Spruce & Speares 1994; for shallow water Toro 2001, chapter 10): two waves of speeds s_L and
/// s_R for depth and normal momentum, and a contact between them over which only v jumps.
///
///   F = (s_R F_L - s_L F_R + s_L s_R (U_R - U_L)) / (s_R - s_L),   s_L <= 0 <= s_R
///
/// with the speeds of Einfeldt (1988), the smaller and larger of those of the side and of the Roe average,
/// which keep depths positive and hold a single bore exactly; next to a dry side the speed of the front,
/// u -+ 2 sqrt(g h).
inline ShallowWaterFlux hllc_flux(double g, double h_left, double u_left, double v_left, double h_right,
                                  double u_right, double v_right) {
  const double root_left = std::sqrt(h_left);
  const double root_right = std::sqrt(h_right);
  const double root_gravity = std::sqrt(g);
  const double c_left = root_gravity * root_left;
  const double c_right = root_gravity * root_right;
  const double roots = root_left + root_right;
  const double u_roe = (root_left * u_left + root_right * u_right) / (roots > 0.0 ? roots : 1.0);
  const double c_roe = std::sqrt(0.5 * g * (h_left + h_right));
  const double wet_left = std::min(u_left - c_left, u_roe - c_roe);
  const double wet_right = std::max(u_right + c_right, u_roe + c_roe);
  const double speed_left =
      h_left > 0.0 ? (h_right > 0.0 ? wet_left : u_left - c_left) : u_right - 2.0 * c_right;
  const double speed_right =
      h_right > 0.0 ? (h_left > 0.0 ? wet_right : u_right + c_right) : u_left + 2.0 * c_left;
  const double s_left = std::min(speed_left, 0.0);
  const double s_right = std::max(speed_right, 0.0);
  const double width = s_right - s_left;
  const double scale = 1.0 / (width > 0.0 ? width : 1.0);

  const double q_left = h_left * u_left;
  const double q_right = h_right * u_right;
  const double p_left = q_left * u_left + 0.5 * g * h_left * h_left;
  const double p_right = q_right * u_right + 0.5 * g * h_right * h_right;
  const double product = s_left * s_right;
  ShallowWaterFlux flux;
  flux.mass = (s_right * q_left - s_left * q_right + product * (h_right - h_left)) * scale;
  flux.momentum = (s_right * p_left - s_left * p_right + product * (q_right - q_left)) * scale;
  flux.tangential = flux.mass * (flux.mass > 0.0 ? v_left : v_right);
  return flux;
}

/// Momentum flux at a wall, m^3/s^2: that of hllc_flux between the state and its mirror image, but no
/// suction. `u` is the velocity towards the wall.
inline double wall_momentum_flux(double g, double h, double u) {
  const double towards = std::max(u, 0.0);
  return std::max(0.5 * g * h * h + h * u * std::sqrt(g * h) + h * towards * towards, 0.0);
}

/// What the cells at both sides of a face lose and gain.
struct FaceFlux {
  double mass = 0.0;
  double momentum_left = 0.0;   ///< out of the cell at the left
  double momentum_right = 0.0;  ///< into the cell at the right
  double tangential = 0.0;
};

/// Flux through a face with a bed of z_left and z_right at its sides, after the hydrostatic reconstruction of
/// Audusse et al. (2004): depths above the higher bed pass the face, and what lies below
/// it presses on the step. A face with open <= 0 is a wall for both sides.
inline FaceFlux face_flux(double g, double open, double h_left, double u_left, double v_left, double z_left,
                          double h_right, double u_right, double v_right, double z_right) {
  const double z = std::max(z_left, z_right);
  const double above_left = std::max(h_left - (z - z_left), 0.0);
  const double above_right = std::max(h_right - (z - z_right), 0.0);
  const ShallowWaterFlux flux = hllc_flux(g, above_left, u_left, v_left, above_right, u_right, v_right);
  const double half = 0.5 * g;
  const double left = flux.momentum + half * (h_left * h_left - above_left * above_left);
  const double right = flux.momentum + half * (h_right * h_right - above_right * above_right);
  const double wall_left = wall_momentum_flux(g, h_left, u_left);
  const double wall_right = wall_momentum_flux(g, h_right, -u_right);
  const bool is_open = open > 0.0;
  return {is_open ? flux.mass : 0.0, is_open ? left : wall_left, is_open ? right : wall_right,
          is_open ? flux.tangential : 0.0};
}

}  // namespace eisph
