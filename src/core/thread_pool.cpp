#include "core/thread_pool.hpp"

#include <algorithm>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace eisph {

namespace {

// Loops follow each other within microseconds; sleeping in between would cost more than a short wait.
constexpr int kSpins = 2000;

/// Numbers too small for full precision (pressures that die away in spray) count as zero: they slow the
/// processor down a hundredfold and mean nothing here. In force for the lifetime of the object.
class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040U); }
  ~FlushDenormals() { _mm_setcsr(before_); }

 private:
  unsigned before_;
#else
  FlushDenormals() = default;
#endif
 public:
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;
};

template <class Value>
void wait_while(const std::atomic<Value>& variable, Value unwanted) {
  for (int spin = 0; spin < kSpins; ++spin) {
    if (variable.load(std::memory_order_acquire) != unwanted) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  while (variable.load(std::memory_order_acquire) == unwanted) variable.wait(unwanted);
}

}  // namespace

ThreadPool::ThreadPool(int threads) : shares_(static_cast<std::size_t>(std::max(threads, 1))) {
  for (int worker = 1; worker < std::max(threads, 1); ++worker) {
    workers_.emplace_back([this, worker] { work(worker); });
  }
}

ThreadPool::~ThreadPool() {
  stopping_.store(true, std::memory_order_release);
  generation_.fetch_add(1, std::memory_order_release);
  generation_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::dispatch(std::size_t items, Task task) {
  task_ = task;
  items_ = static_cast<std::uint32_t>(items);
  unfinished_.store(items_, std::memory_order_relaxed);
  for (std::size_t share = 0; share < shares_.size(); ++share) {
    shares_[share].untaken.store(first_item(share + 1) - first_item(share), std::memory_order_release);
  }
  if (!workers_.empty() && items > 1) {
    generation_.fetch_add(1, std::memory_order_release);
    generation_.notify_all();
  }
  take_items(0);
  for (std::uint32_t left = unfinished_.load(std::memory_order_acquire); left != 0;
       left = unfinished_.load(std::memory_order_acquire)) {
    wait_while(unfinished_, left);
  }
}

void ThreadPool::work(int worker) {
  std::uint32_t seen = 0;
  for (;;) {
    wait_while(generation_, seen);
    seen = generation_.load(std::memory_order_acquire);
    if (stopping_.load(std::memory_order_acquire)) return;
    take_items(worker);
  }
}

void ThreadPool::take_items(int worker) {
  const FlushDenormals flush;
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    take_items_of((static_cast<std::size_t>(worker) + k) % shares_.size(), worker);
  }
}

void ThreadPool::take_items_of(std::size_t share, int worker) {
  std::atomic<std::uint32_t>& shared = shares_[share].untaken;
  std::uint32_t untaken = shared.load(std::memory_order_acquire);
  while (untaken != 0) {
    if (!shared.compare_exchange_weak(untaken, untaken - 1, std::memory_order_acq_rel)) continue;
    task_.call(task_.context, first_item(share + 1) - untaken, worker);
    if (unfinished_.fetch_sub(1, std::memory_order_acq_rel) == 1) unfinished_.notify_one();
    untaken = shared.load(std::memory_order_acquire);
  }
}

}  // namespace eisph
