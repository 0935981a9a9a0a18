#pragma once

#include "core/scene.hpp"

namespace eisph {

// How a hand moves a camera. The target stays in view; z stays upwards unless the camera looks straight down.

/// Turns the eye about the target: `azimuth` about the vertical, `elevation` upwards, degrees. The elevation
/// stays within 89 degrees of the horizontal.
void orbit(Camera& camera, double azimuth, double elevation);
/// Moves eye and target by pixels to the right and upwards on the screen, at the scale of the target.
void pan(Camera& camera, double right, double up, double pixels_per_metre);
/// Brings the eye to `factor` times its distance, or the orthographic height likewise.
void zoom(Camera& camera, double factor);
/// Changes the projection; what is at the target keeps its size.
void set_projection(Camera& camera, Projection projection);

enum class PresetView { Oblique, Front, Side, Top, AlongFlow };
[[nodiscard]] const char* preset_name(PresetView view);
/// A camera that shows the scene from there: front towards +y, side towards -x, along the flow towards +x
/// from above and behind. Sizes in pixels.
[[nodiscard]] Camera preset_camera(const Scene& scene, PresetView view, Projection projection,
                                   int frame_height, int picture_width, int picture_height);

}  // namespace eisph
