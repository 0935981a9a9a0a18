#pragma once

#include <numbers>

namespace eisph {

// Weights of the probes. Both are the cubic spline; q is a distance over the smoothing length or the width.

/// Radial cubic spline without its normalisation, 0 <= q < 2.
inline double radial_spline(double q) {
  if (q < 1.0) return 1.0 - 1.5 * q * q + 0.75 * q * q * q;
  const double rest = 2.0 - q;
  return 0.25 * rest * rest * rest;
}

/// Factor that makes the integral of radial_spline(r / h) one, 1/m^dimension.
inline double radial_normalisation(double h, int dimension) {
  return dimension == 2 ? 10.0 / (7.0 * std::numbers::pi * h * h) : 1.0 / (std::numbers::pi * h * h * h);
}

/// The same spline in one dimension, of unit integral; any q. Sampled at steps of one, or of a half or a
/// third, it adds up to exactly one, two or three wherever the samples start: a lattice of particles weighted
/// by it along each axis shows no ripple.
inline double axis_spline(double q) {
  const double distance = q < 0.0 ? -q : q;
  if (distance >= 2.0) return 0.0;
  if (distance < 1.0) return 2.0 / 3.0 - distance * distance * (1.0 - 0.5 * distance);
  const double rest = 2.0 - distance;
  return rest * rest * rest / 6.0;
}

/// Integral of axis_spline from q to infinity.
inline double axis_spline_beyond(double q) {
  if (q < 0.0) return 1.0 - axis_spline_beyond(-q);
  if (q >= 2.0) return 0.0;
  if (q < 1.0) return 0.5 - q * (2.0 / 3.0 - q * q * (1.0 / 3.0 - 0.125 * q));
  const double rest = 2.0 - q;
  return rest * rest * rest * rest / 24.0;
}

}  // namespace eisph
