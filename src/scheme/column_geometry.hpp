#pragma once

#include "core/scene.hpp"

#include <optional>

namespace eisph {

// What a vertical line meets of the shapes of a scene. Lengths in metres, in the coordinates of the scene.

struct VerticalExtent {
  double lower = 0.0;
  double upper = 0.0;
};

/// The part of the vertical line at (x, y) inside the shape, nothing if it passes by. Points nearer than
/// `tolerance` to the outline seen from above count as outside. Dimension 2 ignores y.
[[nodiscard]] std::optional<VerticalExtent> vertical_extent(const Shape& shape, double x, double y,
                                                            int dimension, double tolerance = 0.0);

/// Water of a vertical line or of a cell, mean over its area.
struct ColumnWater {
  double depth = 0.0;        ///< m
  double discharge_x = 0.0;  ///< depth times velocity, m^2/s
  double discharge_y = 0.0;
};

/// The scene without those cut regions that are a solid of it: a bed in the place of the solid leaves no room
/// for water there, and taking parts of cells out as well would leave dents in a level lake.
[[nodiscard]] Scene without_cuts_of_solids(Scene scene);

/// Total height of the water on the line at (x, y) above `bed` (a height in the scene's coordinates): in an
/// added region and in no cut one. The last added region that contains a point gives its velocity.
[[nodiscard]] ColumnWater water_on_line(const Scene& scene, double x, double y, double bed);

/// Mean of water_on_line over the square cell of side `size` with its lower corner at (x, y): exact for
/// boxes that are not rotated, over a pattern of 8 x 8 points in cells that other shapes touch.
[[nodiscard]] ColumnWater water_in_cell(const Scene& scene, double x, double y, double size, double bed);

}  // namespace eisph
