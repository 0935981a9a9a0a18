#pragma once

#include "core/boundary_particles.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

namespace eisph {

/// Those that are asked for, as they belong to the state: ghost particles within a support radius of the
/// domain (thesis section 3.3.2), virtual particles as the lattice of spacing dx/2 on the walls (3.41), also
/// where their repulsion is spread evenly.
[[nodiscard]] BoundaryParticles boundary_particles(const Scene& scene, const Snapshot& snapshot, bool ghosts,
                                                   bool virtual_particles);

}  // namespace eisph
