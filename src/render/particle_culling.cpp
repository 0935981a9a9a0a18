#include "render/particle_culling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace eisph {

namespace {

constexpr float kCellSpacings = 3.0F;     ///< edge of a cell, in particle spacings
constexpr std::uint8_t kFilledFrom = 14;  ///< particles: half a full cell, more than a single layer
constexpr double kLargestGrid = 6.4e7;    ///< cells

/// Cells around the particles, with one empty layer on each side.
class CellGrid {
 public:
  CellGrid(const Vec3f& lower, const Vec3f& upper, float edge)
      : origin_(lower.array() - edge), inverse_(1.0F / edge) {
    const Vec3f span = (upper - lower) * inverse_;
    cells_ = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double count = std::floor(static_cast<double>(span[axis])) + 3.0;
      cells_ *= count;
      size_[axis] = count < 1e9 ? static_cast<std::size_t>(count) : 0;
    }
  }
  [[nodiscard]] double cells() const { return cells_; }
  [[nodiscard]] std::size_t stride(int axis) const {
    return axis == 0 ? 1 : (axis == 1 ? size_[0] : size_[0] * size_[1]);
  }
  [[nodiscard]] std::size_t cell_of(const Vec3f& position) const {
    const Vec3f place = (position - origin_) * inverse_;
    return static_cast<std::size_t>(place.x()) +
           size_[0] * (static_cast<std::size_t>(place.y()) + size_[1] * static_cast<std::size_t>(place.z()));
  }

 private:
  Vec3f origin_;
  float inverse_;
  double cells_ = 0.0;
  std::size_t size_[3] = {0, 0, 0};
};

/// Keeps a cell where it and both its neighbours along `stride` are set. The outermost cells are empty, so
/// that a neighbour over the end of a row is too.
std::vector<std::uint8_t> erode(const std::vector<std::uint8_t>& filled, std::size_t stride) {
  std::vector<std::uint8_t> result(filled.size(), 0);
  const auto at = [&](std::size_t k) { return k < filled.size() ? filled[k] : std::uint8_t{0}; };
  for (std::size_t k = 0; k < std::min(stride, filled.size()); ++k) result[k] = filled[k] & at(k + stride);
  for (std::size_t k = stride; k + stride < filled.size(); ++k) {
    result[k] = filled[k] & filled[k - stride] & filled[k + stride];
  }
  return result;
}

}  // namespace

std::vector<std::uint32_t> finite_particles(const Snapshot& snapshot) {
  std::vector<std::uint32_t> particles;
  particles.reserve(snapshot.size());
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    if (snapshot.position[i].allFinite()) particles.push_back(static_cast<std::uint32_t>(i));
  }
  return particles;
}

std::vector<std::uint32_t> visible_particles(const Snapshot& snapshot, const CameraView& camera,
                                             double floor) {
  std::vector<std::uint32_t> particles = finite_particles(snapshot);
  if (particles.empty() || !(snapshot.particle_spacing > 0.0)) return particles;
  Vec3f lower = snapshot.position[particles.front()];
  Vec3f upper = lower;
  for (const std::uint32_t i : particles) {
    lower = lower.cwiseMin(snapshot.position[i]);
    upper = upper.cwiseMax(snapshot.position[i]);
  }
  const auto spacing = static_cast<float>(snapshot.particle_spacing);
  const CellGrid grid(lower, upper, kCellSpacings * spacing);
  if (grid.cells() > kLargestGrid || camera.eye_inside(lower.cast<double>(), upper.cast<double>()))
    return particles;
  std::vector<std::uint8_t> filled(static_cast<std::size_t>(grid.cells()), 0);
  std::vector<std::uint32_t> cell(particles.size());
  for (std::size_t k = 0; k < particles.size(); ++k) {
    cell[k] = static_cast<std::uint32_t>(grid.cell_of(snapshot.position[particles[k]]));
    std::uint8_t& count = filled[cell[k]];
    count = static_cast<std::uint8_t>(std::min(count + 1, 255));
  }
  for (std::uint8_t& count : filled) count = count >= kFilledFrom ? 1 : 0;
  if (camera.looks_from_above(floor) && lower.z() < static_cast<float>(floor) + spacing) {
    // The empty layer below the lowest particles is the floor.
    std::fill_n(filled.begin(), grid.stride(2), std::uint8_t{1});
  }
  for (int axis = 0; axis < 3; ++axis) filled = erode(filled, grid.stride(axis));
  std::size_t kept = 0;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    if (filled[cell[k]] == 0) particles[kept++] = particles[k];
  }
  particles.resize(kept);
  return particles;
}

bool is_within(const std::optional<ClipBox>& clip, const Vec3f& point) {
  if (!clip) return true;
  const Vec3d at = point.cast<double>();
  return (at.array() >= clip->min.array()).all() && (at.array() <= clip->max.array()).all();
}

std::vector<std::uint32_t> particles_within(const Snapshot& snapshot, const std::optional<ClipBox>& clip) {
  std::vector<std::uint32_t> particles = finite_particles(snapshot);
  std::erase_if(particles, [&](std::uint32_t k) { return !is_within(clip, snapshot.position[k]); });
  return particles;
}

}  // namespace eisph
