#pragma once

#include "core/scene.hpp"

#include <optional>

namespace eisph {

/// y of the plane of symmetry that ends the domain; nothing if neither y face is one. m.
[[nodiscard]] std::optional<double> symmetry_plane_y(const Scene& scene);

/// The scene whose half (in y) this one is: domain and solids completed by their mirror images, the symmetry
/// face replaced by the opposite one. Fluid, probes and images are left as they are: for drawing and
/// comparing, not for simulating. Without a symmetry plane in y the scene itself.
[[nodiscard]] Scene completed_by_symmetry(const Scene& scene);

}  // namespace eisph
