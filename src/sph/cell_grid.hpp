#pragma once

#include "core/kernel.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace eisph {

/// Cells over the domain for the linked-list search (thesis section 3.3.2), one support radius wide and half
/// as high: lower cells hold fewer candidates that are no neighbours. The last axis (the vertical) runs
/// fastest, the first slowest, so that water a few cells deep is contiguous. Coordinates are in smoothing
/// lengths relative to the domain's lower corner. What lies outside belongs to the nearest cell; since moving
/// points to the nearest cell never takes them further apart than they are, neighbours are found there too.
template <int Dim>
class CellGrid {
 public:
  CellGrid() = default;
  /// extent: edges of the domain in smoothing lengths; a margin of one support radius is added around it.
  explicit CellGrid(const std::array<double, Dim>& extent) {
    for (int d = 0; d < Dim; ++d) {
      counts_[d] = static_cast<int>(extent[d] / edge(d)) + 1 + 2 * reach(d);
    }
  }

  [[nodiscard]] std::size_t cells() const {
    std::size_t product = 1;
    for (int d = 0; d < Dim; ++d) product *= static_cast<std::size_t>(counts_[d]);
    return product;
  }
  [[nodiscard]] const std::array<int, Dim>& counts() const { return counts_; }

  [[nodiscard]] int coordinate(float xi, int axis) const {
    const float cell = xi * static_cast<float>(1.0 / edge(axis)) + static_cast<float>(reach(axis));
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

  /// Bounds of a cell, in smoothing lengths. Cells at the rim of the grid also hold what lies beyond them, so
  /// they are without bounds on that side.
  void bounds(const std::array<int, Dim>& at, std::array<float, Dim>& lower,
              std::array<float, Dim>& upper) const {
    for (int d = 0; d < Dim; ++d) {
      const double from = (at[d] - reach(d)) * edge(d);
      lower[d] = at[d] == 0 ? -kUnbounded : static_cast<float>(from - kRounding);
      upper[d] = at[d] == counts_[d] - 1 ? kUnbounded : static_cast<float>(from + edge(d) + kRounding);
    }
  }

  /// Calls body(first cell, last cell) for each run of consecutive cells that together are the cell and its
  /// neighbours: 3 runs in two dimensions, 9 in three, fewer at the rim.
  template <class Body>
  void for_neighbour_runs(const std::array<int, Dim>& at, const Body& body) const {
    const int last = Dim - 1;
    const int low = std::max(at[last] - reach(last), 0);
    const int high = std::min(at[last] + reach(last), counts_[last] - 1);
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
  static constexpr double kSupport =
      kKernelSupport * 1.0001;  ///< a little over the support radius, for rounding
  static constexpr double kRounding = 1e-3;
  static constexpr float kUnbounded = 1e9F;

  static constexpr double edge(int axis) { return axis == Dim - 1 ? 0.5 * kSupport : kSupport; }
  /// Neighbours are at most this many cells away.
  static constexpr int reach(int axis) { return axis == Dim - 1 ? 2 : 1; }

  std::array<int, Dim> counts_{};
};

}  // namespace eisph
