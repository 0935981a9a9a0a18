#pragma once

#include "core/aligned_buffer.hpp"
#include "core/thread_pool.hpp"
#include "sph/cell_grid.hpp"
#include "sph/source_table.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace eisph {

/// The neighbours of one particle: table indices in a fixed order, the particle itself not among them,
/// filled up with SourceTable::kNothing to a whole number of packs.
struct Neighbours {
  const std::uint32_t* begin = nullptr;
  const std::uint32_t* end = nullptr;
  bool near_object = false;  ///< an object particle or its image is among them
  bool near_image = false;   ///< an image of the fluid is
};

/// Neighbour lists of fluid and object particles: for the fluid every table entry within the kernel's reach,
/// for objects the fluid among them. Found through cells; the order of a list depends only on the
/// order of the table.
template <int Dim>
class NeighbourList {
 public:
  /// objects, object images, fluid, fluid images; lists are made for the fluid and for the objects that have
  /// fluid within reach.
  using Groups = std::array<SourceGroup, 4>;

  /// `reach`: how far neighbours are at most, in smoothing lengths, up to the support radius.
  /// `images_for_objects`: whether the lists of objects hold images of the fluid too.
  void build(const CellGrid<Dim>& grid, const SourceTable& table, const Groups& groups, double reach,
             ThreadPool& pool, bool images_for_objects);

  /// Takes the entries for which keep(j) is false out of the list of particle `index`. An object without any
  /// left is no longer wet. Lists of different particles may be filtered at the same time.
  template <class Keep>
  void filter(std::uint32_t index, const Keep& keep) {
    const Neighbours near = of(index);
    std::uint32_t* const list = pages_[entries_[index] >> kPageShift].data() + (near.begin - page_of(index));
    std::size_t kept = 0;
    for (const std::uint32_t* j = near.begin; j != near.end; ++j) {
      if (*j != SourceTable::kNothing && keep(*j)) list[kept++] = *j;
    }
    const std::size_t packs = (kept + kPackWidth - 1) / kPackWidth;
    for (std::size_t k = kept; k < packs * kPackWidth; ++k) list[k] = SourceTable::kNothing;
    entries_[index] = (entries_[index] & ~kCountMask) | packs;
    if (packs == 0) entries_[index] &= ~kWet;
  }

  /// Of particle `index` of the table, which must be a fluid or an object particle.
  [[nodiscard]] Neighbours of(std::uint32_t index) const {
    const std::uint64_t entry = entries_[index];
    const std::uint32_t* page = pages_[entry >> kPageShift].data();
    const std::uint32_t* begin = page + (entry >> kOffsetShift & kOffsetMask) * kPackWidth;
    return {begin, begin + (entry & kCountMask) * kPackWidth, (entry & kNearObject) != 0,
            (entry & kNearImage) != 0};
  }
  /// Whether object particle `index` has fluid within its support.
  [[nodiscard]] bool is_wet(std::uint32_t index) const { return (entries_[index] & kWet) != 0; }

  /// Indices in all lists, the fillings of their last packs included.
  [[nodiscard]] std::uint64_t total() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  float reach_squared_ = 0.0F;

  // An entry: which page, where on it (in packs), three flags and the length (in packs).
  static constexpr std::uint64_t kCountMask = 0x7FFF;
  static constexpr std::uint64_t kNearImage = 1ULL << 15;
  static constexpr std::uint64_t kNearObject = 1ULL << 16;
  static constexpr std::uint64_t kWet = 1ULL << 17;
  static constexpr int kOffsetShift = 18;
  static constexpr std::uint64_t kOffsetMask = (1ULL << 22) - 1;
  static constexpr int kPageShift = 40;
  static constexpr std::size_t kPageSize = std::size_t{1} << 16;  ///< indices

  using Page = AlignedBuffer<std::uint32_t>;

  [[nodiscard]] const std::uint32_t* page_of(std::uint32_t index) const {
    return pages_[entries_[index] >> kPageShift].data();
  }

  /// What one worker needs: the page in hand and the candidates of the cell in hand.
  struct Worker {
    std::uint32_t* page = nullptr;
    std::size_t page_index = 0;
    std::size_t page_size = 0;
    std::size_t used = 0;      ///< of the page
    std::uint64_t listed = 0;  ///< indices in its lists
    AlignedBuffer<float> x, y, z;
    AlignedBuffer<std::uint32_t> index;
    std::array<std::size_t, 5> group_start{};  ///< of the candidates of each group, and their end
  };

  void collect_candidates(const CellGrid<Dim>& grid, const SourceTable& table, const Groups& groups,
                          std::size_t cell, Worker& worker) const;
  /// The list of particle `index` from the candidates in [first, last).
  void make_list(const SourceTable& table, std::uint32_t index, std::size_t first, std::size_t last,
                 Worker& worker);
  /// Lists fill pages that the workers take from a common stock, so that memory does not depend on how the
  /// work happens to be shared out.
  void take_page(Worker& worker, std::size_t room);

  std::vector<Worker> workers_;
  std::vector<Page> pages_;
  std::size_t pages_taken_ = 0;
  std::mutex pages_mutex_;
  AlignedBuffer<std::uint64_t> entries_;
};

}  // namespace eisph
