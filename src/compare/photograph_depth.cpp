#include "compare/photograph_depth.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace eisph {

namespace {

using Eigen::Vector2d;

constexpr int kMostSamples = 8;            ///< along a side of a cell
constexpr double kUsableShare = 0.5;       ///< of a cell's samples
constexpr double kDeeperBy = 1.15;         ///< factor that makes a cell of the band a rim, and
constexpr double kDeeperByMetres = 0.003;  ///< m, margin
constexpr float kRimIncrease = 1.1F;       ///< thesis section 4.2.1
constexpr double kSmallestCell = 1.0;      ///< pixels

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

Vector2d centre_of(const DepthGrid& grid, std::size_t i, std::size_t j) {
  return {grid.origin_x + (static_cast<double>(i) + 0.5) * grid.cell_size,
          grid.origin_y + (static_cast<double>(j) + 0.5) * grid.cell_size};
}

bool in_polygon(const std::vector<PlanePoint>& polygon, const Vector2d& point) {
  bool inside = false;
  for (std::size_t k = 0, before = polygon.size() - 1; k < polygon.size(); before = k++) {
    const PlanePoint& a = polygon[k];
    const PlanePoint& b = polygon[before];
    if ((a[1] > point.y()) == (b[1] > point.y())) continue;
    if (point.x() < a[0] + (point.y() - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

/// The nearest cell in state `wanted` by the distance of the centres; nothing if there is none within `reach`
/// cells. Of equally near ones the first by rows.
std::optional<std::size_t> nearest_cell(const PhotographDepth& photograph, std::size_t i, std::size_t j,
                                        int reach, const std::function<bool(std::size_t)>& wanted) {
  const auto columns = static_cast<int>(photograph.grid.columns);
  const auto rows = static_cast<int>(photograph.grid.rows);
  std::optional<std::size_t> best;
  int best_square = std::numeric_limits<int>::max();
  for (int ring = 1; ring <= reach && ring * ring <= best_square; ++ring) {
    for (int dj = -ring; dj <= ring; ++dj) {
      const int step = std::abs(dj) == ring ? 1 : 2 * ring;
      for (int di = -ring; di <= ring; di += step) {
        const int u = static_cast<int>(i) + di;
        const int v = static_cast<int>(j) + dj;
        if (u < 0 || v < 0 || u >= columns || v >= rows) continue;
        const std::size_t cell =
            static_cast<std::size_t>(v) * photograph.grid.columns + static_cast<std::size_t>(u);
        const int square = di * di + dj * dj;
        if (square > best_square || (square == best_square && cell > *best) || !wanted(cell)) continue;
        best = cell;
        best_square = square;
      }
    }
  }
  return best;
}

/// Side of a cell in the middle of the area, pixels.
double cell_width(const PlaneCamera& camera, const FloorMap& floor, double cell_size) {
  const Vector2d middle(0.5 * (floor.area[0] + floor.area[2]), 0.5 * (floor.area[1] + floor.area[3]));
  return cell_size / camera.pixel_length(middle);
}

/// Samples of one photograph, cell by cell.
class CellSampler {
 public:
  CellSampler(const DepthPicture& picture, const PlaneCamera& camera, const FloorMap& floor,
              const DepthGrid& shape)
      : picture_(picture), shape_(shape) {
    pixels_per_cell_ = cell_width(camera, floor, shape.cell_size);
    samples_ = std::clamp(static_cast<int>(std::ceil(pixels_per_cell_)), 1, kMostSamples);
    corners_.reserve((shape.columns + 1) * (shape.rows + 1));
    for (std::size_t j = 0; j <= shape.rows; ++j) {
      for (std::size_t i = 0; i <= shape.columns; ++i) {
        corners_.push_back(camera.pixel_of({shape.origin_x + static_cast<double>(i) * shape.cell_size,
                                            shape.origin_y + static_cast<double>(j) * shape.cell_size}));
      }
    }
  }

  [[nodiscard]] double pixels_per_cell() const { return pixels_per_cell_; }

  /// Mean depth, NaN if less than half of the cell can be read.
  float sample(std::size_t i, std::size_t j) {
    const std::size_t corner = j * (shape_.columns + 1) + i;
    const Vector2d& a = corners_[corner];
    const Vector2d& b = corners_[corner + 1];
    const Vector2d& c = corners_[corner + shape_.columns + 1];
    const Vector2d& d = corners_[corner + shape_.columns + 2];
    double sum = 0.0;
    int usable = 0;
    for (int v = 0; v < samples_; ++v) {
      const double t = (v + 0.5) / samples_;
      const Vector2d left = a + t * (c - a);
      const Vector2d across = (b + t * (d - b) - left) / samples_;
      for (int u = 0; u < samples_; ++u) {
        const Vector2d pixel = left + (u + 0.5) * across;
        const auto x = static_cast<int>(std::floor(pixel.x()));
        const auto y = static_cast<int>(std::floor(pixel.y()));
        if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) continue;
        const std::size_t k = static_cast<std::size_t>(y) * picture_.width + x;
        ++counts_[static_cast<std::size_t>(picture_.range[k])];
        if (picture_.range[k] > LevelRange::Clamped) continue;
        sum += picture_.depth[k];
        ++usable;
      }
    }
    return usable < kUsableShare * samples_ * samples_ ? kNone : static_cast<float>(sum / usable);
  }

  [[nodiscard]] double share(LevelRange range) const {
    double all = 0.0;
    for (const std::size_t count : counts_) all += static_cast<double>(count);
    return all > 0.0 ? static_cast<double>(counts_[static_cast<std::size_t>(range)]) / all : 0.0;
  }

 private:
  const DepthPicture& picture_;
  const DepthGrid& shape_;
  double pixels_per_cell_ = 0.0;
  int samples_ = 1;
  std::vector<Vector2d> corners_;        ///< of the cells, pixels
  std::array<std::size_t, 5> counts_{};  ///< samples by range
};

/// Cells of the band and the polygons, by the settings: 0 none, 1 in the band, 2 in a polygon.
std::vector<std::uint8_t> rim_candidates(const PhotographDepth& photograph, const FloorMap& floor,
                                         const RimSettings& rims) {
  const DepthGrid& grid = photograph.grid;
  std::vector<std::uint8_t> candidates(grid.depth.size(), 0);
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const std::size_t cell = j * grid.columns + i;
      if (photograph.state[cell] == CellState::Outside) continue;
      const Vector2d centre = centre_of(grid, i, j);
      if (rims.detection != RimDetection::None && floor.wall_distance(centre.x(), centre.y()) < rims.band)
        candidates[cell] = 1;
      for (const auto& polygon : rims.polygons) {
        if (in_polygon(polygon, centre)) candidates[cell] = 2;
      }
    }
  }
  return candidates;
}

void find_rims(PhotographDepth& photograph, const FloorMap& floor, const RimSettings& rims) {
  const std::vector<std::uint8_t> candidates = rim_candidates(photograph, floor, rims);
  const DepthGrid& grid = photograph.grid;
  const auto beyond = [&](std::size_t cell) {
    return candidates[cell] == 0 && photograph.state[cell] == CellState::Measured;
  };
  const int reach = 2 * static_cast<int>(std::ceil(rims.band / grid.cell_size)) + 2;
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const std::size_t cell = j * grid.columns + i;
      if (candidates[cell] == 0) continue;
      bool rim = candidates[cell] == 2 || rims.detection == RimDetection::Band;
      if (!rim) {
        const auto water = nearest_cell(photograph, i, j, reach, beyond);
        const bool unreadable = photograph.state[cell] == CellState::Unreadable;
        rim = unreadable || (water && grid.depth[cell] > kDeeperBy * grid.depth[*water] + kDeeperByMetres);
      }
      if (rim) found.push_back(cell);
    }
  }
  for (const std::size_t cell : found) photograph.state[cell] = CellState::Rim;
}

}  // namespace

std::vector<std::uint8_t> floor_mask(const FloorMap& floor, const PlaneCamera& camera, int width,
                                     int height) {
  std::vector<std::uint8_t> mask(static_cast<std::size_t>(width) * height, 0);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const Vector2d plane = camera.plane_of({i + 0.5, j + 0.5});
      if (floor.shows(plane.x(), plane.y())) mask[static_cast<std::size_t>(j) * width + i] = 1;
    }
  }
  return mask;
}

DepthPicture depth_picture(const GreyPicture& photograph, const DepthCalibration& calibration) {
  DepthPicture picture{.width = photograph.width, .height = photograph.height, .depth = {}, .range = {}};
  picture.depth.resize(photograph.level.size());
  picture.range.resize(photograph.level.size());
  for (std::size_t pixel = 0; pixel < photograph.level.size(); ++pixel) {
    const CalibratedDepth found = calibration.depth_of(pixel, photograph.level[pixel]);
    picture.depth[pixel] = found.depth;
    picture.range[pixel] = found.range;
  }
  return picture;
}

void require_readable_cells(const PlaneCamera& camera, const FloorMap& floor, double cell_size) {
  const double pixels = cell_width(camera, floor, cell_size);
  if (pixels >= kSmallestCell) return;
  throw InputError(
      fmt::format("cells of {:g} m are smaller than the pixels of the photographs ({:.2g} pixels wide); "
                  "compare on larger "
                  "cells or with larger photographs",
                  cell_size, pixels));
}

PhotographDepth depth_on_cells(const DepthPicture& picture, const PlaneCamera& camera, const FloorMap& floor,
                               const RimSettings& rims, const DepthGrid& shape) {
  require_readable_cells(camera, floor, shape.cell_size);
  CellSampler sampler(picture, camera, floor, shape);
  PhotographDepth photograph;
  photograph.grid = shape;
  photograph.state.assign(shape.depth.size(), CellState::Outside);
  std::fill(photograph.grid.depth.begin(), photograph.grid.depth.end(), 0.0F);
  for (std::size_t j = 0; j < shape.rows; ++j) {
    for (std::size_t i = 0; i < shape.columns; ++i) {
      const Vector2d centre = centre_of(shape, i, j);
      if (!floor.shows(centre.x(), centre.y())) continue;
      const std::size_t cell = j * shape.columns + i;
      photograph.grid.depth[cell] = sampler.sample(i, j);
      photograph.state[cell] =
          std::isnan(photograph.grid.depth[cell]) ? CellState::Unreadable : CellState::Measured;
    }
  }
  find_rims(photograph, floor, rims);
  for (const CellState state : photograph.state) ++photograph.cells[static_cast<std::size_t>(state)];
  photograph.clamped_share = sampler.share(LevelRange::Clamped);
  photograph.bright_share = sampler.share(LevelRange::TooBright);
  photograph.dark_share = sampler.share(LevelRange::TooDark);
  photograph.pixels_per_cell = sampler.pixels_per_cell();
  return photograph;
}

ComparableDepth filled(const PhotographDepth& photograph, RimFill fill) {
  ComparableDepth comparable{.grid = photograph.grid, .valid = {}};
  comparable.valid.assign(photograph.state.size(), 0);
  const auto measured = [&](std::size_t cell) { return photograph.state[cell] == CellState::Measured; };
  const auto reach = static_cast<int>(std::max(photograph.grid.columns, photograph.grid.rows));
  for (std::size_t j = 0; j < photograph.grid.rows; ++j) {
    for (std::size_t i = 0; i < photograph.grid.columns; ++i) {
      const std::size_t cell = j * photograph.grid.columns + i;
      float& depth = comparable.grid.depth[cell];
      if (photograph.state[cell] == CellState::Rim && fill == RimFill::NearestPlus10) {
        const auto nearest = nearest_cell(photograph, i, j, reach, measured);
        depth = nearest ? kRimIncrease * photograph.grid.depth[*nearest] : kNone;
      }
      const bool counts =
          measured(cell) || (photograph.state[cell] == CellState::Rim && fill != RimFill::LeaveOut);
      comparable.valid[cell] = counts && !std::isnan(depth) ? 1 : 0;
      if (comparable.valid[cell] == 0) depth = 0.0F;
    }
  }
  return comparable;
}

}  // namespace eisph
