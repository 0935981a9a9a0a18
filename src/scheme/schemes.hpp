#pragma once

#include "core/scheme_list.hpp"
#include "scheme/simulation.hpp"

#include <memory>

namespace eisph {

/// How each scheme is made of a checked scene: make_eisph and so on.
#define EISPH_DECLARE(name, meaning) std::unique_ptr<Simulation> make_##name(const Scene& scene, int threads);
EISPH_SCHEMES(EISPH_DECLARE)
#undef EISPH_DECLARE

/// The two- or three-dimensional form of a particle scheme, as the scene says.
template <template <int> class Scheme>
std::unique_ptr<Simulation> make_particle_scheme(const Scene& scene, int threads) {
  if (scene.dimension == 2) return std::make_unique<Scheme<2>>(scene, threads);
  return std::make_unique<Scheme<3>>(scene, threads);
}

}  // namespace eisph
