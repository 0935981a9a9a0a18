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
  /// Storage needed only while sorting, to be shared by sorts that follow each other.
  struct Workspace {
    AlignedBuffer<std::uint32_t> keys;
    AlignedBuffer<std::uint32_t> histogram;

    [[nodiscard]] std::size_t bytes() const { return keys.bytes() + histogram.bytes(); }
  };

  /// key(i) gives the cell of particle i, in [0, cells), or `cells`, which puts the particle at the end,
  /// beyond start()[cells].
  template <class Key>
  void sort(std::size_t count, std::size_t cells, ThreadPool& pool, Workspace& workspace, const Key& key) {
    const auto threads = static_cast<std::size_t>(pool.threads());
    AlignedBuffer<std::uint32_t>& keys = workspace.keys;
    keys.resize(count);
    order_.resize(count);
    start_.resize_exactly(cells + 2);
    workspace.histogram.resize_exactly(threads * (cells + 1));
    std::uint32_t* const histograms = workspace.histogram.data();
    const auto bounds = [&](std::size_t thread) { return count * thread / threads; };
    pool.run(threads, [&](std::size_t thread, int) {
      std::uint32_t* histogram = histograms + thread * (cells + 1);
      std::fill_n(histogram, cells + 1, 0U);
      for (std::size_t i = bounds(thread); i < bounds(thread + 1); ++i) {
        keys[i] = key(i);
        ++histogram[keys[i]];
      }
    });
    number_slots(cells, pool, histograms);
    pool.run(threads, [&](std::size_t thread, int) {
      std::uint32_t* slot = histograms + thread * (cells + 1);
      for (std::size_t i = bounds(thread); i < bounds(thread + 1); ++i) {
        order_[slot[keys[i]]++] = static_cast<std::uint32_t>(i);
      }
    });
  }

  [[nodiscard]] const std::uint32_t* order() const { return order_.data(); }
  [[nodiscard]] const std::uint32_t* start() const { return start_.data(); }
  [[nodiscard]] std::size_t bytes() const { return order_.bytes() + start_.bytes(); }

 private:
  /// Turns the counts of the threads into the place of the first particle of each cell and thread. Every
  /// thread numbers a range of the cells, from the count of all cells before it.
  void number_slots(std::size_t cells, ThreadPool& pool, std::uint32_t* histograms) {
    const auto threads = static_cast<std::size_t>(pool.threads());
    const auto bound = [&](std::size_t range) { return (cells + 1) * range / threads; };
    before_.resize(threads + 1);
    before_[0] = 0;
    pool.run(threads, [&](std::size_t range, int) {
      std::uint32_t count = 0;
      for (std::size_t thread = 0; thread < threads; ++thread) {
        const std::uint32_t* histogram = histograms + thread * (cells + 1);
        for (std::size_t cell = bound(range); cell < bound(range + 1); ++cell) count += histogram[cell];
      }
      before_[range + 1] = count;
    });
    for (std::size_t range = 0; range < threads; ++range) before_[range + 1] += before_[range];
    pool.run(threads, [&](std::size_t range, int) {
      std::uint32_t total = before_[range];
      for (std::size_t cell = bound(range); cell < bound(range + 1); ++cell) {
        start_[cell] = total;
        for (std::size_t thread = 0; thread < threads; ++thread) {
          std::uint32_t& slot = histograms[thread * (cells + 1) + cell];
          const std::uint32_t here = slot;
          slot = total;
          total += here;
        }
      }
    });
    start_[cells + 1] = before_[threads];
  }

  AlignedBuffer<std::uint32_t> before_;  ///< particles in the cells before each range
  AlignedBuffer<std::uint32_t> order_;
  AlignedBuffer<std::uint32_t> start_;
};

}  // namespace eisph
