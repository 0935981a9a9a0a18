#include "scheme/shallow_water_bed.hpp"

#include "core/error.hpp"
#include "scheme/column_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kLengthTolerance = 1e-6;    ///< over the cell size
constexpr double kPassingDepth = 4.0 / 9.0;  ///< of a dam break at the place of the dam, over the depth

std::size_t cells_along(const Scene& scene, int axis, double cell_size) {
  const double length = scene.domain_max[axis] - scene.domain_min[axis];
  const double cells = std::round(length / cell_size);
  if (cells >= 1.0 && std::abs(length - cells * cell_size) <= kLengthTolerance * cell_size * cells) {
    return static_cast<std::size_t>(cells);
  }
  throw InputError(
      fmt::format("{}: shallow_water.cell_size = {:.9g} m: the domain is {:.9g} m long in {}, not a whole "
                  "number of cells",
                  scene.source_file, cell_size, length, "xyz"[axis]));
}

}  // namespace

ShallowWaterGrid::ShallowWaterGrid(const Scene& scene) {
  const double wanted =
      scene.shallow_water.cell_size > 0.0 ? scene.shallow_water.cell_size : scene.particle_spacing;
  columns = cells_along(scene, 0, wanted);
  rows = scene.dimension == 2 ? 1 : cells_along(scene, 1, wanted);
  cell_size = (scene.domain_max.x() - scene.domain_min.x()) / static_cast<double>(columns);
  origin_x = scene.domain_min.x();
  origin_y = scene.dimension == 2 ? -0.5 * cell_size : scene.domain_min.y();
  constexpr std::size_t kLine = 8;  // doubles in a cache line
  stride = (columns + 2 + kLine - 1) / kLine * kLine;
}

ShallowWaterBed::ShallowWaterBed(const Scene& scene, const ShallowWaterGrid& grid)
    : grid_(grid), floor_(scene.domain_min.z()), plane_(scene.dimension == 3) {
  for (AlignedBuffer<double>* values : {&bed_, &open_x_, &open_y_}) {
    values->resize_exactly(grid_.size());
    values->fill(0.0);
  }
  for (const Obstacle& obstacle : scene.obstacles) raise(obstacle.shape, scene, nullptr);
  for (const Gate& gate : scene.gates) close_gate(gate, scene);

  // Faces between two cells are open, those at the ends of the domain if the scene says so.
  const auto is_open = [&](int face) {
    return scene.faces[static_cast<std::size_t>(face)].kind == FaceKind::Open;
  };
  for (std::size_t j = 0; j < grid_.rows; ++j) {
    std::fill_n(&open_x_[grid_.index(1, j)], grid_.columns - 1, 1.0);
    if (is_open(kXMin)) open_x_[grid_.index(0, j)] = 1.0;
    if (is_open(kXMax)) open_x_[grid_.index(grid_.columns, j)] = 1.0;
    const bool at_end = j == 0;
    if (!at_end || (plane_ && is_open(kYMin))) std::fill_n(&open_y_[grid_.row(j)], grid_.columns, 1.0);
  }
  if (plane_ && is_open(kYMax)) std::fill_n(&open_y_[grid_.row(grid_.rows)], grid_.columns, 1.0);
  list_faces();
}

void ShallowWaterBed::raise(const Shape& shape, const Scene& scene, std::vector<std::size_t>* cells) {
  const double tolerance = kLengthTolerance * grid_.cell_size;
  for (std::size_t j = 0; j < grid_.rows; ++j) {
    for (std::size_t i = 0; i < grid_.columns; ++i) {
      const auto solid =
          vertical_extent(shape, grid_.centre_x(i), grid_.centre_y(j), scene.dimension, tolerance);
      if (!solid || !(solid->upper > floor_)) continue;
      double& bed = bed_[grid_.index(i, j)];
      bed = std::max(bed, solid->upper - floor_);
      if (cells != nullptr) cells->push_back(grid_.index(i, j));
    }
  }
}

void ShallowWaterBed::close_gate(const Gate& gate, const Scene& scene) {
  if (!gate.lift(0.0)) return;
  ClosedGate closed;
  closed.gate = gate;
  std::vector<double> before(bed_.data(), bed_.data() + bed_.size());
  raise(gate.shape, scene, &closed.cells);
  for (const std::size_t cell : closed.cells) closed.bed_below.push_back(before[cell]);
  const auto belongs = [&](std::size_t cell) {
    return std::binary_search(closed.cells.begin(), closed.cells.end(), cell);
  };
  for (const std::size_t cell : closed.cells) {
    for (const std::size_t next : {cell - 1, cell + 1, cell - grid_.stride, cell + grid_.stride}) {
      if (!belongs(next)) closed.beside.push_back(next);
    }
  }
  gates_.push_back(std::move(closed));
}

void ShallowWaterBed::list_faces() {
  faces_x_.clear();
  faces_y_.clear();
  solid_cells_ = 0;
  // Beyond open ends the bed goes on as it is; walls are not looked behind.
  for (std::size_t j = 0; j < grid_.rows; ++j) {
    const std::size_t row = grid_.row(j);
    bed_[row - 1] = bed_[row];
    bed_[row + grid_.columns] = bed_[row + grid_.columns - 1];
  }
  std::copy_n(&bed_[grid_.row(0)], grid_.columns, &bed_[grid_.row(0) - grid_.stride]);
  std::copy_n(&bed_[grid_.row(grid_.rows - 1)], grid_.columns, &bed_[grid_.row(grid_.rows)]);
  for (std::size_t j = 0; j < grid_.rows; ++j) {
    for (std::size_t i = 0; i < grid_.columns; ++i) {
      const std::size_t cell = grid_.index(i, j);
      solid_cells_ += bed_[cell] > 0.0 ? 1 : 0;
      if (i > 0 && (bed_[cell] > 0.0 || bed_[cell - 1] > 0.0)) faces_x_.push_back(cell);
      if (j > 0 && (bed_[cell] > 0.0 || bed_[cell - grid_.stride] > 0.0)) faces_y_.push_back(cell);
    }
  }
}

bool ShallowWaterBed::is_due(const ClosedGate& closed, double time, const double* depth) const {
  if (time < closed.gate.start_time) return false;
  const std::optional<double> lift = closed.gate.lift(time);
  if (!lift) return true;
  double level = 0.0;
  for (const std::size_t cell : closed.beside) {
    if (depth[cell] > 0.0) level = std::max(level, bed_[cell] + depth[cell]);
  }
  double edge = std::numeric_limits<double>::infinity();
  if (closed.gate.shape.kind == ShapeKind::Box) {
    edge = closed.gate.shape.min.z();
  } else {
    const bool ball = closed.gate.shape.kind == ShapeKind::Sphere;
    edge = closed.gate.shape.centre.z() - (ball ? closed.gate.shape.radius : 0.0);
  }
  return std::max(edge - floor_, 0.0) + *lift >= kPassingDepth * level;
}

bool ShallowWaterBed::open_gates(double time, const double* depth) {
  bool changed = false;
  for (std::size_t k = 0; k < gates_.size();) {
    if (!is_due(gates_[k], time, depth)) {
      ++k;
      continue;
    }
    for (std::size_t c = 0; c < gates_[k].cells.size(); ++c)
      bed_[gates_[k].cells[c]] = gates_[k].bed_below[c];
    gates_.erase(gates_.begin() + static_cast<std::ptrdiff_t>(k));
    changed = true;
  }
  if (!changed) return false;
  for (const std::size_t face : faces_x_) open_x_[face] = 1.0;
  for (const std::size_t face : faces_y_) open_y_[face] = 1.0;
  list_faces();
  return true;
}

double ShallowWaterBed::next_gate_start(double time) const {
  double next = std::numeric_limits<double>::infinity();
  for (const ClosedGate& closed : gates_) {
    if (closed.gate.start_time > time) next = std::min(next, closed.gate.start_time);
  }
  return next;
}

void ShallowWaterBed::find_walls(const double* depth, double dry_depth) {
  const double* bed = bed_.data();
  const auto is_wall = [&](std::size_t water, std::size_t solid) {
    return depth[solid] <= dry_depth && bed[solid] > 0.0 && bed[solid] >= bed[water] + depth[water];
  };
  const auto mark = [&](const std::vector<std::size_t>& faces, std::size_t offset, double* open) {
    for (const std::size_t face : faces) {
      open[face] = is_wall(face - offset, face) || is_wall(face, face - offset) ? 0.0 : 1.0;
    }
  };
  mark(faces_x_, 1, open_x_.data());
  mark(faces_y_, grid_.stride, open_y_.data());
}

}  // namespace eisph
