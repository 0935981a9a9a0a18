#pragma once

#include "core/scene.hpp"

namespace eisph {

/// Volume of the water as the scene's shapes describe it, m^3 (m^2 in two dimensions): the added regions
/// taken together, less the cut ones. A numerical estimate, within about 0.1 % unless the water is very thin.
[[nodiscard]] double fluid_volume(const Scene& scene);

}  // namespace eisph
