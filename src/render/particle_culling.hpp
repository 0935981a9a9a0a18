#pragma once

#include "core/snapshot.hpp"
#include "render/camera_view.hpp"

#include <cstdint>
#include <vector>

namespace eisph {

/// Indices of the fluid particles that the camera can see (three dimensions). Left out are those in cells of
/// three spacings whose 26 neighbours are all at least half full, and those without a finite position. Seen
/// from above, the floor at height `floor` (m) counts as filled. Nothing is left out when the eye is among
/// the particles. Not for cut or transparent views.
[[nodiscard]] std::vector<std::uint32_t> visible_particles(const Snapshot& snapshot, const CameraView& camera,
                                                           double floor);

/// Indices of all particles with a finite position.
[[nodiscard]] std::vector<std::uint32_t> finite_particles(const Snapshot& snapshot);

}  // namespace eisph
