#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "render/camera_view.hpp"

#include <cstdint>
#include <optional>
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

/// Whether the box, if there is one, holds the point (m).
[[nodiscard]] bool is_within(const std::optional<ClipBox>& clip, const Vec3f& point);
/// Indices of the particles with a finite position within the box, if there is one.
[[nodiscard]] std::vector<std::uint32_t> particles_within(const Snapshot& snapshot,
                                                          const std::optional<ClipBox>& clip);

}  // namespace eisph
