#pragma once

#include "compare/depth_calibration.hpp"
#include "compare/plane_camera.hpp"
#include "core/comparison.hpp"
#include "core/depth_grid.hpp"
#include "core/grey_picture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace eisph {

/// What of the floor a photograph shows. Positions in metres.
struct FloorMap {
  std::array<double, 4> area{};  ///< x_min, y_min, x_max, y_max
  /// Signed distance to the nearest solid, negative inside.
  std::function<double(double x, double y)> solid_distance;
  /// Distance to the nearest wall or solid.
  std::function<double(double x, double y)> wall_distance;

  [[nodiscard]] bool shows(double x, double y) const {
    return x >= area[0] && y >= area[1] && x <= area[2] && y <= area[3] && solid_distance(x, y) > 0.0;
  }
};

/// Pixels that show the floor: 1, others 0.
[[nodiscard]] std::vector<std::uint8_t> floor_mask(const FloorMap& floor, const PlaneCamera& camera,
                                                   int width, int height);

/// Depth in every pixel, whatever it shows; independent of the registration.
struct DepthPicture {
  int width = 0;
  int height = 0;
  std::vector<float> depth;       ///< m; not-a-number without one
  std::vector<LevelRange> range;  ///< why
};

[[nodiscard]] DepthPicture depth_picture(const GreyPicture& photograph, const DepthCalibration& calibration);

enum class CellState : std::uint8_t {
  Measured,
  Outside,     ///< not in the photograph, or a solid
  Rim,         ///< darkened by air bubbles
  Unreadable,  ///< less than half of it has a grey level that stands for a depth
};

struct PhotographDepth {
  DepthGrid grid;                      ///< as photographed, not-a-number where nothing can be read, 0 outside
  std::vector<CellState> state;        ///< by cell
  std::array<std::size_t, 4> cells{};  ///< by state
  double clamped_share = 0.0;          ///< of the samples in measured cells and rims
  double bright_share = 0.0;           ///< of the samples on the floor: brighter than calibrated
  double dark_share = 0.0;             ///< the same, darker
  double pixels_per_cell = 0.0;        ///< side of a cell in pixels, mean
};

/// Throws InputError if cells of that size (m) are smaller than pixels.
void require_readable_cells(const PlaneCamera& camera, const FloorMap& floor, double cell_size);

/// Depth on the cells of `shape` (whose depths do not matter). A cell's depth is the mean over n x n samples
/// of the nearest pixels, n the side of the cell in pixels, rounded up, at most 8. Rims are found by
/// `rims.detection`: a cell within the band is one if it is deeper than the nearest measured cell beyond the
/// band by 15 % and 3 mm. Throws InputError if the cells are smaller than pixels.
[[nodiscard]] PhotographDepth depth_on_cells(const DepthPicture& picture, const PlaneCamera& camera,
                                             const FloorMap& floor, const RimSettings& rims,
                                             const DepthGrid& shape);

/// Depth to compare with, and which cells count (1): measured ones, and rims unless they are left out.
struct ComparableDepth {
  DepthGrid grid;
  std::vector<std::uint8_t> valid;
};

/// Deals with rims as `fill` says; the nearest depth is that of the measured cell with the nearest centre.
[[nodiscard]] ComparableDepth filled(const PhotographDepth& photograph, RimFill fill);

}  // namespace eisph
