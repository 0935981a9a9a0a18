#pragma once

#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "render/colour_map.hpp"
#include "render/field.hpp"
#include "render/font.hpp"
#include "render/image.hpp"
#include "render/palette.hpp"

namespace eisph {

/// Scales of a depth profile: x to the right, height above the floor upwards, usually exaggerated.
struct ProfileView {
  PixelRectangle area;  ///< of the plot in the picture
  double metres_per_pixel = 0.0;
  double height_per_pixel = 0.0;  ///< m of height
};

/// Leaves room for axis labels at the left and below.
[[nodiscard]] ProfileView profile_view(const Scene& scene, int picture_width, int picture_height,
                                       const Font& font);

/// Draws the water depth of a two-dimensional scene over x, filled with the colour of the depth, with axes.
[[nodiscard]] Image draw_depth_profile(const Scene& scene, const ImageSettings& settings,
                                       const DepthGrid& depth, const ProfileView& view, int picture_width,
                                       int picture_height, const ColourMap& map, const FieldScale& scale,
                                       const Font& font);

}  // namespace eisph
