#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace eisph {

/// Fixed workers for the loops of a time step. The calling thread takes part. Every worker has a contiguous
/// share of the items, the same one in every loop of that length, so that it finds in its core's cache what
/// it wrote in the loop before; a worker that is done helps the others item by item, so a core that is busy
/// elsewhere (drawing, say) simply takes fewer. Results must not depend on which worker treats an item.
/// Starting a loop allocates nothing.
/// Denormal numbers count as zero inside a body.
class ThreadPool {
 public:
  /// `threads` in all, the caller included; at least 1.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int threads() const { return static_cast<int>(workers_.size()) + 1; }

  /// Calls body(item, worker) for every item in [0, items), worker in [0, threads()). Returns when all are
  /// done. An exception in a body ends the program: bodies report failure through their results.
  template <class Body>
  void run(std::size_t items, const Body& body) {
    if (items == 0) return;
    dispatch(items, {&body, [](const void* context, std::size_t item, int worker) {
                       (*static_cast<const Body*>(context))(item, worker);
                     }});
  }

  /// Calls body(first, last, worker) on consecutive blocks of [0, count).
  template <class Body>
  void run_blocks(std::size_t count, std::size_t block, const Body& body) {
    run((count + block - 1) / block, [&](std::size_t item, int worker) {
      const std::size_t first = item * block;
      body(first, first + block < count ? first + block : count, worker);
    });
  }

 private:
  struct Task {
    const void* context = nullptr;
    void (*call)(const void*, std::size_t, int) = nullptr;
  };

  /// Items of one worker's share of the open loop that nobody has taken. Taking one is a compare-and-swap, so
  /// whoever has one knows that the loop is still open; a worker that comes too late finds zero and need not
  /// be waited for.
  struct alignas(64) Share {
    std::atomic<std::uint32_t> untaken{0};
  };

  void dispatch(std::size_t items, Task task);
  void work(int worker);
  void take_items(int worker);
  void take_items_of(std::size_t share, int worker);
  /// First item of a share of the open loop.
  [[nodiscard]] std::uint32_t first_item(std::size_t share) const {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(items_) * share / shares_.size());
  }

  std::vector<std::thread> workers_;
  std::vector<Share> shares_;
  // Written before a loop is opened and left alone until all of its items are done.
  Task task_;
  std::uint32_t items_ = 0;
  std::atomic<std::uint32_t> unfinished_{0};
  std::atomic<std::uint32_t> generation_{0};  ///< counts the loops, to wake the workers
  std::atomic<bool> stopping_{false};
};

}  // namespace eisph
