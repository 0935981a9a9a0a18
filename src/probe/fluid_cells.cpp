#include "probe/fluid_cells.hpp"

#include <cmath>
#include <limits>

namespace eisph {

namespace {

constexpr double kCellsPerParticle = 2.0;

}  // namespace

FluidCells::FluidCells(const Snapshot& snapshot, double cell_size) : cell_size_(cell_size) {
  Vec3d lower = Vec3d::Constant(std::numeric_limits<double>::max());
  Vec3d upper = -lower;
  std::size_t count = 0;
  for (const Vec3f& position : snapshot.position) {
    if (!position.allFinite()) continue;
    lower = lower.cwiseMin(position.cast<double>());
    upper = upper.cwiseMax(position.cast<double>());
    ++count;
  }
  if (count == 0) return;
  lower_ = lower;
  if (snapshot.dimension == 2) upper.y() = lower.y();
  const double most = kCellsPerParticle * static_cast<double>(count) + 64.0;
  const auto cells_along = [&](Eigen::Index axis) {
    return std::floor((upper[axis] - lower[axis]) / cell_size_) + 1.0;
  };
  while (cells_along(0) * cells_along(1) * cells_along(2) > most) cell_size_ *= 1.25;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cells_[axis] = static_cast<std::size_t>(cells_along(static_cast<Eigen::Index>(axis)));
  }

  // Counting sort.
  start_.assign(cells_[0] * cells_[1] * cells_[2] + 1, 0);
  for (const Vec3f& position : snapshot.position) {
    if (position.allFinite()) ++start_[cell_of(position) + 1];
  }
  for (std::size_t cell = 1; cell < start_.size(); ++cell) start_[cell] += start_[cell - 1];
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  index_.resize(count);
  position_.resize(count);
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const Vec3f& position = snapshot.position[k];
    if (!position.allFinite()) continue;
    const std::uint32_t place = next[cell_of(position)]++;
    index_[place] = static_cast<std::uint32_t>(k);
    position_[place] = position;
  }
}

std::size_t FluidCells::cell_of(const Vec3f& position) const {
  std::array<std::size_t, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cells_[axis] == 1) continue;
    const auto component = static_cast<Eigen::Index>(axis);
    const double offset = static_cast<double>(position[component]) - lower_[component];
    cell[axis] = std::min(static_cast<std::size_t>(offset / cell_size_), cells_[axis] - 1);
  }
  return (cell[2] * cells_[1] + cell[1]) * cells_[0] + cell[0];
}

}  // namespace eisph
