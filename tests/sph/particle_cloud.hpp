#pragma once

#include "core/thread_pool.hpp"
#include "sph/cell_sort.hpp"
#include "sph/neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace eisph {

/// A table of objects, object images, fluid and fluid images at given places, sorted by cell as in a run.
template <int Dim>
class ParticleCloud {
 public:
  using Points = std::vector<Float4>;

  ParticleCloud(const std::array<double, Dim>& extent, const std::array<Points, 4>& groups)
      : grid_(extent), pool_(1) {
    std::array<std::uint32_t, 4> counts{};
    for (std::size_t g = 0; g < 4; ++g) counts[g] = static_cast<std::uint32_t>(groups[g].size());
    table_.lay_out(counts[0], counts[1], counts[2], counts[3]);
    const std::array<std::uint32_t, 4> first = {table_.first_object, table_.first_object_image,
                                                table_.first_fluid, table_.first_image};
    for (std::size_t g = 0; g < 4; ++g) {
      const Points& points = groups[g];
      sorts_[g].sort(points.size(), grid_.cells(), pool_, workspace_,
                     [&](std::size_t k) { return grid_.index(&points[k].x); });
      for (std::uint32_t k = 0; k < counts[g]; ++k) {
        table_.position[first[g] + k] = points[sorts_[g].order()[k]];
      }
      groups_[g] = {first[g], sorts_[g].start(), points.empty()};
    }
  }

  void build(NeighbourList<Dim>& list, ThreadPool& pool, bool images_for_objects = true) const {
    list.build(grid_, table_, groups_, kKernelSupport, pool, images_for_objects);
  }
  [[nodiscard]] const SourceTable& table() const { return table_; }

  /// Squared distance of two rows of the table, in smoothing lengths.
  [[nodiscard]] double squared_distance(std::uint32_t a, std::uint32_t b) const {
    const Float4& at = table_.position[a];
    const Float4& other = table_.position[b];
    const double x = static_cast<double>(at.x) - other.x;
    const double y = static_cast<double>(at.y) - other.y;
    const double z = Dim == 3 ? static_cast<double>(at.z) - other.z : 0.0;
    return x * x + y * y + z * z;
  }

 private:
  CellGrid<Dim> grid_;
  ThreadPool pool_;
  SourceTable table_;
  CellSort::Workspace workspace_;
  std::array<CellSort, 4> sorts_;
  typename NeighbourList<Dim>::Groups groups_;
};

/// Points spread evenly over the box from `lower` to `upper` on every axis, smoothing lengths.
template <int Dim>
std::vector<Float4> random_points(std::size_t count, float lower, float upper, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> coordinate(lower, upper);
  std::vector<Float4> points(count);
  for (Float4& point : points) {
    point.x = coordinate(generator);
    point.y = coordinate(generator);
    if constexpr (Dim == 3) point.z = coordinate(generator);
  }
  return points;
}

}  // namespace eisph
