#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace eisph {

/// Cells of edge one support radius over the domain, for the linked-list search (thesis section 3.3.2). The
/// last axis (the vertical) runs fastest, the first slowest, so that water a few cells deep is contiguous.
/// Coordinates are in smoothing lengths relative to the domain's lower corner. What lies outside belongs to
/// the nearest cell; since moving points to the nearest cell never takes them further apart than they are,
/// neighbours are found there too.
template <int Dim>
class CellGrid {
 public:
  CellGrid() = default;
  /// extent: edges of the domain in smoothing lengths; a margin of one support radius is added around it.
  explicit CellGrid(const std::array<double, Dim>& extent) {
    for (int d = 0; d < Dim; ++d) {
      counts_[d] = static_cast<int>(extent[d] / kEdge) + 3;
    }
  }

  [[nodiscard]] std::size_t cells() const {
    std::size_t product = 1;
    for (int d = 0; d < Dim; ++d) product *= static_cast<std::size_t>(counts_[d]);
    return product;
  }
  [[nodiscard]] const std::array<int, Dim>& counts() const { return counts_; }

  [[nodiscard]] int coordinate(float xi, int axis) const {
    const float cell = xi * static_cast<float>(1.0 / kEdge) + 1.0F;
    return static_cast<int>(std::clamp(cell, 0.0F, static_cast<float>(counts_[axis] - 1)));
  }
  [[nodiscard]] std::uint32_t index(const float* xi) const {
    std::uint32_t cell = 0;
    for (int d = 0; d < Dim; ++d) {
      cell = cell * static_cast<std::uint32_t>(counts_[d]) + static_cast<std::uint32_t>(coordinate(xi[d], d));
    }
    return cell;
  }
  [[nodiscard]] std::array<int, Dim> coordinates(std::size_t cell) const {
    std::array<int, Dim> at{};
    for (int d = Dim - 1; d >= 0; --d) {
      at[d] = static_cast<int>(cell % static_cast<std::size_t>(counts_[d]));
      cell /= static_cast<std::size_t>(counts_[d]);
    }
    return at;
  }

  /// Calls body(first cell, last cell) for each run of consecutive cells that together are the cell and its
  /// neighbours: 3 runs in two dimensions, 9 in three, fewer at the rim.
  template <class Body>
  void for_neighbour_runs(const std::array<int, Dim>& at, const Body& body) const {
    const int last = Dim - 1;
    const int low = std::max(at[last] - 1, 0);
    const int high = std::min(at[last] + 1, counts_[last] - 1);
    for (int i = std::max(at[0] - 1, 0); i <= std::min(at[0] + 1, counts_[0] - 1); ++i) {
      if constexpr (Dim == 2) {
        const std::size_t row = static_cast<std::size_t>(i) * counts_[last];
        body(row + low, row + high);
      } else {
        for (int j = std::max(at[1] - 1, 0); j <= std::min(at[1] + 1, counts_[1] - 1); ++j) {
          const std::size_t row = (static_cast<std::size_t>(i) * counts_[1] + j) * counts_[last];
          body(row + low, row + high);
        }
      }
    }
  }

 private:
  static constexpr double kEdge = 2.0 * 1.0001;  ///< of a cell; a little over the support, for rounding

  std::array<int, Dim> counts_{};
};

}  // namespace eisph
