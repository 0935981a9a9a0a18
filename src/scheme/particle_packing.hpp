#pragma once

#include "core/lattice.hpp"
#include "core/scene.hpp"

namespace eisph {

/// The water at t = 0 as particle schemes start with it: that of fluid_lattice, moved so that its number
/// density is even where it lies against a round or rotated solid, or where the pieces of its lattice have
/// cells of different volume. Elsewhere it stays in place, and a scene that has neither pays nothing. The
/// same for any number of threads.
[[nodiscard]] FluidLattice packed_fluid(const Scene& scene, int threads);

}  // namespace eisph
