#pragma once

#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "render/colour_map.hpp"
#include "render/field.hpp"
#include "render/image.hpp"
#include "render/palette.hpp"

namespace eisph {

/// Where the top view lies in its picture: x to the right, y upwards, equal scales.
struct TopView {
  double left = 0.0;  ///< x of the left edge, m
  double top = 0.0;   ///< y of the upper edge, m
  double metres_per_pixel = 0.0;
  PixelRectangle area;  ///< in the picture
};

/// Fits the domain's footprint, with its mirror images if settings.mirror says so, into the picture, leaving
/// `border` pixels on all sides.
[[nodiscard]] TopView top_view(const Scene& scene, const ImageSettings& settings, int picture_width,
                               int picture_height, int border);

/// Draws water depth, solids and walls of a three-dimensional scene into the whole picture. Depth is linear
/// between cell centres, except across solids; below settings.dry_depth there is the bare floor.
[[nodiscard]] Image draw_depth_map(const Scene& scene, const ImageSettings& settings, const DepthGrid& depth,
                                   const TopView& view, int picture_width, int picture_height,
                                   const ColourMap& map, const FieldScale& scale);

}  // namespace eisph
