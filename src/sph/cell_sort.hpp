#pragma once

#include "core/aligned_buffer.hpp"
#include "core/thread_pool.hpp"

#include <cstddef>
#include <cstdint>

namespace eisph {

/// Stable counting sort by cell. After sort(), order()[k] is the old index of the particle that comes k-th,
/// and the particles of cell c are those from start()[c] to start()[c + 1]. Stability makes the order
/// independent of the number of threads.
class CellSort {
 public:
  /// key(i) gives the cell of particle i, in [0, cells). Keys of `cells` and above put particles at the end,
  /// beyond start()[cells].
  template <class Key>
  void sort(std::size_t count, std::size_t cells, ThreadPool& pool, const Key& key) {
    const auto threads = static_cast<std::size_t>(pool.threads());
    keys_.resize(count);
    order_.resize(count);
    start_.resize(cells + 2);
    histogram_.resize(threads * (cells + 1));
    const auto bounds = [&](std::size_t thread) { return count * thread / threads; };
    pool.run(threads, [&](std::size_t thread, int) {
      std::uint32_t* histogram = histogram_.data() + thread * (cells + 1);
      std::fill_n(histogram, cells + 1, 0U);
      for (std::size_t i = bounds(thread); i < bounds(thread + 1); ++i) {
        keys_[i] = key(i);
        ++histogram[keys_[i]];
      }
    });
    std::uint32_t total = 0;
    for (std::size_t cell = 0; cell <= cells; ++cell) {
      start_[cell] = total;
      for (std::size_t thread = 0; thread < threads; ++thread) {
        std::uint32_t& slot = histogram_[thread * (cells + 1) + cell];
        const std::uint32_t here = slot;
        slot = total;
        total += here;
      }
    }
    start_[cells + 1] = total;
    pool.run(threads, [&](std::size_t thread, int) {
      std::uint32_t* slot = histogram_.data() + thread * (cells + 1);
      for (std::size_t i = bounds(thread); i < bounds(thread + 1); ++i) {
        order_[slot[keys_[i]]++] = static_cast<std::uint32_t>(i);
      }
    });
  }

  [[nodiscard]] const std::uint32_t* order() const { return order_.data(); }
  [[nodiscard]] const std::uint32_t* start() const { return start_.data(); }
  [[nodiscard]] std::size_t bytes() const {
    return keys_.bytes() + order_.bytes() + start_.bytes() + histogram_.bytes();
  }

 private:
  AlignedBuffer<std::uint32_t> keys_;
  AlignedBuffer<std::uint32_t> order_;
  AlignedBuffer<std::uint32_t> start_;
  AlignedBuffer<std::uint32_t> histogram_;
};

}  // namespace eisph
