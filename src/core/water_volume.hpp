#pragma once

#include "core/scene.hpp"

namespace eisph {

/// Volume of the water as the scene's shapes describe it, m^3 (m^2 in two dimensions): the added regions
/// taken together, less the cut ones, within the domain. Exact along every vertical; the quadrature across
/// them has a relative error below 1e-8 for boxes and about 1e-6 for round and rotated shapes.
[[nodiscard]] double water_volume(const Scene& scene);

}  // namespace eisph
