#include "probe/depth_grid.hpp"

#include "core/error.hpp"
#include "probe/column_probes.hpp"
#include "probe/spray.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kMostCells = 1e8;

/// Cells that cover `length`. A remainder that is rounding error does not get a cell of its own.
double cells_over(double length, double cell_size) {
  return std::max(1.0, std::ceil(length / cell_size - 1e-6));
}

// Particles on a wall are stored in single precision, and may lie this part of a cell beyond it.
constexpr double kEdgeTolerance = 1e-3;

/// Cell along one axis, nothing outside the domain's `length`.
std::optional<std::size_t> cell_of(double offset, double length, double cell_size, std::size_t cells) {
  const double tolerance = kEdgeTolerance * cell_size;
  if (!(offset >= -tolerance && offset <= length + tolerance)) return std::nullopt;
  return std::min(static_cast<std::size_t>(std::max(offset, 0.0) / cell_size), cells - 1);
}

}  // namespace

DepthGridBuilder::DepthGridBuilder(const Scene& scene)
    : scene_(scene), lower_(scene.domain_min), upper_(scene.domain_max), one_row_(scene.dimension == 2) {
  const double given = scene.output.depth_cell_size;
  const double cell_size = given != 0.0 ? given : 1.5 * scene.particle_spacing;
  const double columns = cells_over(upper_.x() - lower_.x(), cell_size);
  const double rows = one_row_ ? 1.0 : cells_over(upper_.y() - lower_.y(), cell_size);
  if (!(cell_size > 0.0) || !(columns * rows <= kMostCells)) {
    throw InputError(fmt::format(
        "{}: output.depth_cell_size = {} m: must be above zero and give at most {:g} cells over the domain",
        scene.source_file, cell_size, kMostCells));
  }
  empty_.origin_x = lower_.x();
  empty_.origin_y = one_row_ ? -0.5 * cell_size : lower_.y();
  empty_.cell_size = cell_size;
  empty_.columns = static_cast<std::size_t>(columns);
  empty_.rows = static_cast<std::size_t>(rows);
  empty_.depth.assign(empty_.columns * empty_.rows, 0.0F);
  if (scene.output.depth_rule == DepthRule::Surface) surface_.emplace(scene, empty_);
}

DepthGrid DepthGridBuilder::build(const Snapshot& snapshot) const {
  DepthGrid grid = empty_;
  grid.time = snapshot.time;
  if (snapshot.columns) {
    resample_levels(*snapshot.columns, grid);
    return grid;
  }
  if (surface_) {
    surface_->fill(snapshot, grid);
  } else {
    fill_with_highest(snapshot, grid);
  }
  return grid;
}

void DepthGridBuilder::fill_with_highest(const Snapshot& snapshot, DepthGrid& grid) const {
  std::optional<SprayRule> spray;
  if (scene_.output.ignore_spray) spray.emplace(scene_, snapshot.time);
  const Vec3d length = upper_ - lower_;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const Vec3d offset = snapshot.position[k].cast<double>() - lower_;
    const auto column = cell_of(offset.x(), length.x(), grid.cell_size, grid.columns);
    const auto row =
        one_row_ ? std::optional<std::size_t>(0) : cell_of(offset.y(), length.y(), grid.cell_size, grid.rows);
    if (!column || !row) continue;
    float& depth = grid.depth[*row * grid.columns + *column];
    const auto height = static_cast<float>(offset.z());
    if (height > depth && !(spray && spray->is_spray(snapshot, k))) depth = height;
  }
}

}  // namespace eisph
