#pragma once

#include "compare/photograph_depth.hpp"
#include "compare/plane_camera.hpp"
#include "core/depth_grid.hpp"
#include "core/grey_picture.hpp"
#include "core/synthetic_camera.hpp"

#include <array>
#include <functional>

namespace eisph {

/// The camera of the settings over `area` (x_min, y_min, x_max, y_max, m), as near as it shows all of it.
[[nodiscard]] PlaneCamera synthetic_camera(const SyntheticCamera& settings,
                                           const std::array<double, 4>& area);

/// Depth of a grid between its cells' centres, m: bilinear, beyond the outermost centres constant.
[[nodiscard]] double depth_between(const DepthGrid& grid, double x, double y);

/// What the camera of the settings sees of water that is `depth(x, y)` metres deep. Levels are rounded to
/// those of the settings' bit depth. `number` tells pictures apart: their noise differs.
[[nodiscard]] GreyPicture synthetic_photograph(const SyntheticSettings& settings, const PlaneCamera& camera,
                                               const FloorMap& floor,
                                               const std::function<double(double x, double y)>& depth,
                                               unsigned number);

}  // namespace eisph
