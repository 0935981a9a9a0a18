#pragma once

#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace eisph {

/// What a colour bar says.
struct FieldScale {
  std::string label;          ///< with the unit of the ticks
  double lower = 0.0;         ///< SI units
  double upper = 1.0;         ///< SI units
  double display_unit = 1.0;  ///< SI value of one unit of the ticks, e.g. 1000 for kPa
};

/// Scale of settings.field (of depth for a depth map). Without a range in the settings it depends on the
/// scene alone, so that all frames of a run share it: speeds up to 2 sqrt(g H), velocities symmetric,
/// pressures up to rho g H, depths up to H, each rounded up. "water" has no label. Throws InputError for an
/// unknown field or an empty range.
[[nodiscard]] FieldScale field_scale(const Scene& scene, const ImageSettings& settings);

/// Reference depth of the scene, or the domain's height where it has none, m.
[[nodiscard]] double depth_scale(const Scene& scene);

/// Colour map the settings ask for. An empty name chooses by field: blue_red for velocity components,
/// depth_blue for depths, viridis otherwise.
[[nodiscard]] std::string colour_map_name(const ImageSettings& settings);

/// Field value (SI units) of the particles listed in `particles`. Unknown fields give zero.
[[nodiscard]] std::vector<float> field_values(const std::string& field, const Snapshot& snapshot,
                                              const DepthGrid& depth,
                                              const std::vector<std::uint32_t>& particles);

}  // namespace eisph
