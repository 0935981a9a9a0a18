#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <vector>

namespace eisph {

/// Light on the floor of the domain in rectangular cells, row 0 at the lower y.
struct GroundLight {
  int columns = 0;
  int rows = 0;
  std::vector<float> light;  ///< 1: nothing above; towards 0: dark

  [[nodiscard]] float at(int column, int row) const {
    return light[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(column)];
  }
};

/// Soft shadow of the water and, if `solids`, of obstacles, dams and gates under a wide light from above.
/// What is over the floor is taken apart into layers by height; each casts its outline, blurred over a
/// distance that grows with the height. `water_opacity` is how much of the light one layer of water takes, 0
/// to 1. Three dimensions.
[[nodiscard]] GroundLight ground_light(const Scene& scene, const Snapshot& snapshot, bool solids,
                                       double water_opacity);

}  // namespace eisph
