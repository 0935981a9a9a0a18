#pragma once

#include "core/shape.hpp"

#include <vector>

namespace eisph {

/// Particles of the boundaries that are no part of a snapshot, for pictures of them. Positions in m.
struct BoundaryParticles {
  std::vector<Vec3f> ghosts;             ///< mirror images of the fluid beyond walls and symmetry planes
  std::vector<Vec3f> virtual_particles;  ///< on walls
};

}  // namespace eisph
