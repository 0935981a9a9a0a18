#pragma once

#include "core/shape.hpp"
#include "core/snapshot.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace eisph {

/// The fluid particles of a snapshot sorted into cubic cells, to find those near a point. Particles without a
/// finite position are left out.
class FluidCells {
 public:
  /// `cell_size` (m) is made larger where the particles are so scattered that most cells would be empty.
  FluidCells(const Snapshot& snapshot, double cell_size);

  /// Calls visit(k, position) for every particle that may lie in the box about `centre` that reaches `reach`
  /// (m) along each axis; k is its place in the snapshot. In two dimensions y does not count.
  template <class Visit>
  void visit_near(const Vec3d& centre, double reach, const Visit& visit) const {
    if (position_.empty()) return;
    std::array<std::size_t, 3> first{};
    std::array<std::size_t, 3> last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cells_[axis] == 1) continue;
      const double offset = centre[static_cast<Eigen::Index>(axis)] - lower_[static_cast<Eigen::Index>(axis)];
      const auto top = static_cast<double>(cells_[axis] - 1);
      if (offset + reach < 0.0 || offset - reach > cell_size_ * (top + 1.0)) return;
      first[axis] = static_cast<std::size_t>(std::clamp((offset - reach) / cell_size_, 0.0, top));
      last[axis] = static_cast<std::size_t>(std::clamp((offset + reach) / cell_size_, 0.0, top));
    }
    for (std::size_t k = first[2]; k <= last[2]; ++k) {
      for (std::size_t j = first[1]; j <= last[1]; ++j) {
        const std::size_t row = (k * cells_[1] + j) * cells_[0];
        for (std::uint32_t p = start_[row + first[0]]; p < start_[row + last[0] + 1]; ++p) {
          visit(index_[p], position_[p]);
        }
      }
    }
  }

  /// Calls visit(k, position) once for every particle, those of a cell one after the other.
  template <class Visit>
  void visit_all(const Visit& visit) const {
    for (std::size_t p = 0; p < position_.size(); ++p) visit(std::size_t{index_[p]}, position_[p]);
  }

 private:
  [[nodiscard]] std::size_t cell_of(const Vec3f& position) const;

  Vec3d lower_ = Vec3d::Zero();
  double cell_size_ = 1.0;
  std::array<std::size_t, 3> cells_{1, 1, 1};
  std::vector<std::uint32_t> start_;  ///< first particle of each cell, and the end
  std::vector<std::uint32_t> index_;
  std::vector<Vec3f> position_;
};

}  // namespace eisph
