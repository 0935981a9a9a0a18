#pragma once

#include "compare/depth_calibration.hpp"
#include "compare/photograph_depth.hpp"
#include "compare/plane_camera.hpp"
#include "core/comparison.hpp"
#include "core/grey_picture.hpp"
#include "core/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// The floor of a scene as photographs from above show it; `area` (x_min, y_min, x_max, y_max, m) restricts
/// it. Obstacles and dams count as solids wherever they stand on the floor, gates do not. Throws InputError
/// for an area that is not in the domain. `scene` is a whole tank.
[[nodiscard]] FloorMap floor_of(const Scene& scene, const std::optional<std::array<double, 4>>& area);

/// The photographs of a comparison, registered and calibrated.
struct PhotographSet {
  FloorMap floor;
  int width = 0;   ///< pixels, of all pictures
  int height = 0;  ///< pixels
  int bit_depth = 8;
  bool coloured = false;
  std::vector<ReferencePoint> points;  ///< those of the file and the corners that were found
  std::optional<double> bow;           ///< pixels, of the outline that was found
  Registration registration;
  DepthCalibration calibration;
  std::vector<GreyPicture> pictures;  ///< in the order of the comparison's photographs
  std::vector<DepthPicture> depths;   ///< the same
};

/// Reads all files that a comparison names. Throws InputError naming the file or key that is wrong.
[[nodiscard]] PhotographSet load_photographs(const Comparison& comparison, const Scene& scene);

}  // namespace eisph
