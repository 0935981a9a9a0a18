#include "sph/neighbour_list.hpp"

namespace eisph {

namespace {

constexpr std::size_t kCellsPerItem = 48;

constexpr std::array<std::uint32_t, kPackWidth> kConsecutive = [] {
  std::array<std::uint32_t, kPackWidth> lanes{};
  for (std::uint32_t k = 0; k < kPackWidth; ++k) lanes[k] = k;
  return lanes;
}();

Pack load(const float* values) {
  Pack pack;
  __builtin_memcpy(&pack, values, sizeof(Pack));
  return pack;
}

/// How far the coordinate lies outside [lower, upper].
Pack excess(Pack coordinate, float lower, float upper) {
  return positive_part(splat<Pack>(lower) - coordinate) + positive_part(coordinate - splat<Pack>(upper));
}

}  // namespace

template <int Dim>
void NeighbourList<Dim>::build(const CellGrid<Dim>& grid, const SourceTable& table, const Groups& groups,
                               double reach, ThreadPool& pool, bool images_for_objects) {
  reach_squared_ = static_cast<float>(reach * reach);
  workers_.resize(static_cast<std::size_t>(pool.threads()));
  pages_taken_ = 0;
  for (Worker& worker : workers_) {
    worker.used = 0;
    worker.listed = 0;
    worker.page_size = 0;
  }
  entries_.resize(table.first_image);

  const SourceGroup& objects = groups[0];
  const SourceGroup& fluid = groups[2];
  pool.run_blocks(grid.cells(), kCellsPerItem, [&](std::size_t first, std::size_t last, int worker_index) {
    Worker& worker = workers_[static_cast<std::size_t>(worker_index)];
    for (std::size_t cell = first; cell < last; ++cell) {
      const bool has_objects = !objects.empty && objects.start[cell] != objects.start[cell + 1];
      const bool has_fluid = !fluid.empty && fluid.start[cell] != fluid.start[cell + 1];
      if (!has_objects && !has_fluid) continue;
      collect_candidates(grid, table, groups, cell, worker);
      const auto& start = worker.group_start;
      if (has_fluid) {
        for (std::uint32_t k = fluid.start[cell]; k < fluid.start[cell + 1]; ++k) {
          make_list(table, fluid.first + k, 0, start[4], worker);
        }
      }
      if (has_objects) {
        const std::size_t end = start[images_for_objects ? 4 : 3];
        for (std::uint32_t k = objects.start[cell]; k < objects.start[cell + 1]; ++k) {
          if (start[2] < end) {
            make_list(table, objects.first + k, start[2], end, worker);
          } else {
            entries_[objects.first + k] = 0;
          }
        }
      }
    }
  });
}

template <int Dim>
void NeighbourList<Dim>::collect_candidates(const CellGrid<Dim>& grid, const SourceTable& table,
                                            const Groups& groups, std::size_t cell, Worker& worker) const {
  std::size_t count = 0;
  const auto at = grid.coordinates(cell);
  std::array<float, Dim> lower;
  std::array<float, Dim> upper;
  grid.bounds(at, lower, upper);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const SourceGroup& group = groups[g];
    worker.group_start[g] = count;
    if (group.empty) continue;
    grid.for_neighbour_runs(at, [&](std::size_t low, std::size_t high) {
      const std::uint32_t first = group.first + group.start[low];
      const std::uint32_t last = group.first + group.start[high + 1];
      if (first == last) return;
      const std::size_t needed = count + (last - first) + 2 * kPackWidth;
      if (needed > worker.index.size()) {
        for (AlignedBuffer<float>* array : {&worker.x, &worker.y, &worker.z}) array->resize(2 * needed);
        worker.index.resize(2 * needed);
      }
      for (std::uint32_t row = first; row < last; row += kPackWidth) {
        // Only what is within reach of the cell's box; the last pack may hold rows of other cells, cut off
        // here.
        const PackRows columns = gather_rows(&table.position[row], kConsecutive.data());
        const Pack x = excess(columns.x, lower[0], upper[0]);
        const Pack y = excess(columns.y, lower[1], upper[1]);
        Pack squared = x * x + y * y;
        if constexpr (Dim == 3) {
          const Pack z = excess(columns.z, lower[2], upper[2]);
          squared += z * z;
        }
        const LaneSelection near = select_below(squared, reach_squared_, last - row);
        store_selected(columns.x, near, &worker.x[count]);
        store_selected(columns.y, near, &worker.y[count]);
        store_selected(columns.z, near, &worker.z[count]);
        store_selected_rows(row, near, &worker.index[count]);
        count += near.count;
      }
    });
  }
  worker.group_start[groups.size()] = count;
  for (std::size_t k = count; k < count + kPackWidth; ++k) {
    worker.x[k] = worker.y[k] = worker.z[k] = SourceTable::kFarAway;
    worker.index[k] = SourceTable::kNothing;
  }
}

template <int Dim>
void NeighbourList<Dim>::take_page(Worker& worker, std::size_t room) {
  const std::lock_guard lock(pages_mutex_);
  if (pages_taken_ == pages_.size()) pages_.emplace_back();
  Page& page = pages_[pages_taken_];
  if (page.size() < room) page.resize_exactly(std::max(room, kPageSize));
  worker.page = page.data();
  worker.page_index = pages_taken_++;
  worker.page_size = page.size();
  worker.used = 0;
}

template <int Dim>
void NeighbourList<Dim>::make_list(const SourceTable& table, std::uint32_t index, std::size_t first,
                                   std::size_t last, Worker& worker) {
  const std::size_t room = last - first + 2 * kPackWidth;
  if (worker.used + room > worker.page_size) take_page(worker, room);

  const Float4& at = table.position[index];
  const Pack x = splat<Pack>(at.x);
  const Pack y = splat<Pack>(at.y);
  const Pack z = splat<Pack>(at.z);
  std::uint32_t* const list = worker.page + worker.used;
  std::uint32_t* out = list;
  for (std::size_t k = first; k < last; k += kPackWidth) {
    const Pack dx = load(&worker.x[k]) - x;
    const Pack dy = load(&worker.y[k]) - y;
    Pack squared = dx * dx + dy * dy;
    if constexpr (Dim == 3) {
      const Pack dz = load(&worker.z[k]) - z;
      squared += dz * dz;
    }
    squared += splat<Pack>(reach_squared_) * ones_at(&worker.index[k], index);
    const LaneSelection near = select_below(squared, reach_squared_, last - k);
    store_selected(&worker.index[k], near, out);
    out += near.count;
  }
  const auto count = static_cast<std::size_t>(out - list);
  const bool near_object = count > 0 && list[0] < table.first_fluid;
  const bool near_image = count > 0 && out[-1] >= table.first_image;
  // A fluid particle may have no fluid about it.
  const bool wet = index >= table.first_fluid || (count > 0 && out[-1] >= table.first_fluid);
  std::uint64_t packs = (count + kPackWidth - 1) / kPackWidth;
  for (std::size_t k = count; k < packs * kPackWidth; ++k) list[k] = SourceTable::kNothing;
  if (!wet) packs = 0;
  entries_[index] = static_cast<std::uint64_t>(worker.page_index) << kPageShift |
                    static_cast<std::uint64_t>(worker.used / kPackWidth) << kOffsetShift | (wet ? kWet : 0) |
                    (near_object ? kNearObject : 0) | (near_image ? kNearImage : 0) | packs;
  worker.used += packs * kPackWidth;
  worker.listed += packs * kPackWidth;
}

template <int Dim>
std::uint64_t NeighbourList<Dim>::total() const {
  std::uint64_t sum = 0;
  for (const Worker& worker : workers_) sum += worker.listed;
  return sum;
}

template <int Dim>
std::size_t NeighbourList<Dim>::bytes() const {
  std::size_t sum = entries_.bytes();
  for (const Page& page : pages_) sum += page.bytes();
  for (const Worker& worker : workers_) {
    sum += worker.x.bytes() + worker.y.bytes() + worker.z.bytes() + worker.index.bytes();
  }
  return sum;
}

template class NeighbourList<2>;
template class NeighbourList<3>;

}  // namespace eisph
