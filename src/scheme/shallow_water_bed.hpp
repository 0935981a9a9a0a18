#pragma once

#include "core/aligned_buffer.hpp"
#include "core/scene.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace eisph {

/// The square cells of a shallow-water run: an array of rows with one ghost cell on every side.
struct ShallowWaterGrid {
  double origin_x = 0.0;   ///< m, lower corner of the first cell
  double origin_y = 0.0;   ///< m; a two-dimensional scene has one row centred on y = 0
  double cell_size = 0.0;  ///< m
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t stride = 0;  ///< of the arrays

  /// Throws InputError if the domain is not a whole number of cells long.
  explicit ShallowWaterGrid(const Scene& scene);

  [[nodiscard]] std::size_t row(std::size_t j) const { return (j + 1) * stride + 1; }
  [[nodiscard]] std::size_t index(std::size_t i, std::size_t j) const { return row(j) + i; }
  [[nodiscard]] std::size_t size() const { return (rows + 2) * stride; }
  [[nodiscard]] double centre_x(std::size_t i) const {
    return origin_x + (static_cast<double>(i) + 0.5) * cell_size;
  }
  [[nodiscard]] double centre_y(std::size_t j) const {
    return origin_y + (static_cast<double>(j) + 0.5) * cell_size;
  }
};

/// Bed and walls of a shallow-water run. Solids are part of the bed: a cell whose centre lies inside the
/// outline of a solid seen from above has its bed at the top of it, whatever the height of its base. A face
/// is a wall for as long as the solid behind it is dry and not lower than the water before it; water that
/// stands higher flows over it. Walls and symmetry planes of the domain are walls without friction.
///
/// A gate is such a solid until it opens and its cells go back to the bed below. An instant gate opens at its
/// start time. A lifted one opens all at once when its lower edge has risen above 4/9 of the highest water
/// level beside it, the depth at which a dam break passes the place of the dam (Ritter 1892) and which
/// therefore passes below the edge.
class ShallowWaterBed {
 public:
  ShallowWaterBed(const Scene& scene, const ShallowWaterGrid& grid);

  [[nodiscard]] const double* bed() const { return bed_.data(); }  ///< m above the floor
  /// Opens what is due at `time` (s), given the depths. Returns whether anything has changed.
  bool open_gates(double time, const double* depth);
  /// The first start time of a closed gate after `time`, infinity without one.
  [[nodiscard]] double next_gate_start(double time) const;
  /// Marks the faces at solids as walls or not, according to the present depths (m).
  void find_walls(const double* depth, double dry_depth);

  /// 0 at a wall, 1 elsewhere: the faces at the lower sides of the cells.
  [[nodiscard]] const double* open_x() const { return open_x_.data(); }
  [[nodiscard]] const double* open_y() const { return open_y_.data(); }
  [[nodiscard]] std::size_t solid_cells() const { return solid_cells_; }
  [[nodiscard]] std::size_t bytes() const { return bed_.bytes() + open_x_.bytes() + open_y_.bytes(); }

 private:
  struct ClosedGate {
    Gate gate;
    std::vector<std::size_t> cells;
    std::vector<double> bed_below;    ///< of the cells, m
    std::vector<std::size_t> beside;  ///< cells next to them
  };

  void raise(const Shape& shape, const Scene& scene, std::vector<std::size_t>* cells);
  void close_gate(const Gate& gate, const Scene& scene);
  void list_faces();
  [[nodiscard]] bool is_due(const ClosedGate& closed, double time, const double* depth) const;

  ShallowWaterGrid grid_;
  double floor_ = 0.0;
  bool plane_ = true;
  AlignedBuffer<double> bed_;
  AlignedBuffer<double> open_x_;
  AlignedBuffer<double> open_y_;
  std::vector<std::size_t> faces_x_;  ///< inner faces beside solids
  std::vector<std::size_t> faces_y_;
  std::vector<ClosedGate> gates_;
  std::size_t solid_cells_ = 0;
};

}  // namespace eisph
