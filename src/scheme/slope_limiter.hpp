#pragma once

#include "core/scene.hpp"

#include <cmath>

namespace eisph {

// Limited differences of a cell average over one cell, from the differences to its two neighbours. Both
// limiters give zero at an extremum, and face values between the averages of the neighbours.
//
//   minmod                 the smaller of the two where they agree in sign (Roe 1986)
//   monotonised central    sign min(|a + b| / 2, 2 |a|, 2 |b|) (van Leer 1977)

template <SlopeLimiter Limiter>
inline double limited_difference(double a, double b) {
  if constexpr (Limiter == SlopeLimiter::Minmod) {
    const double smaller = std::abs(a) < std::abs(b) ? a : b;
    return a * b > 0.0 ? smaller : 0.0;
  } else {
    const double steepest = 2.0 * (std::abs(a) < std::abs(b) ? a : b);
    const double central = 0.5 * (a + b);
    const double smaller = std::abs(central) < std::abs(steepest) ? central : steepest;
    return a * b > 0.0 ? smaller : 0.0;
  }
}

}  // namespace eisph
