#include "core/thread_pool.hpp"

#include <atomic>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

class ThreadPoolOf : public testing::TestWithParam<int> {};

TEST_P(ThreadPoolOf, TreatsEveryItemOnce) {
  ThreadPool pool(GetParam());
  for (const std::size_t items : {0U, 1U, 2U, 3U, 100U, 10007U}) {
    std::vector<std::atomic<int>> visits(items);
    pool.run(items, [&](std::size_t item, int) { visits[item].fetch_add(1, std::memory_order_relaxed); });
    for (std::size_t item = 0; item < items; ++item) ASSERT_EQ(visits[item].load(), 1) << "item " << item;
  }
}

TEST_P(ThreadPoolOf, NumbersItsWorkersAndRunsNoTwoItemsOfOneAtATime) {
  ThreadPool pool(GetParam());
  EXPECT_EQ(pool.threads(), GetParam());
  std::vector<std::atomic<int>> busy(static_cast<std::size_t>(pool.threads()));
  std::atomic<int> faults{0};
  pool.run(2000, [&](std::size_t, int worker) {
    if (worker < 0 || worker >= pool.threads()) {
      faults.fetch_add(1);
      return;
    }
    auto& mine = busy[static_cast<std::size_t>(worker)];
    if (mine.fetch_add(1) != 0) faults.fetch_add(1);
    // Long enough for the other workers to join.
    for (int k = 0; k < 1000; ++k) std::atomic_signal_fence(std::memory_order_seq_cst);
    mine.fetch_sub(1);
  });
  EXPECT_EQ(faults.load(), 0);
}

TEST_P(ThreadPoolOf, CutsARangeIntoBlocksWithoutGapOrOverlap) {
  ThreadPool pool(GetParam());
  for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 1000U}) {
    std::vector<std::atomic<int>> visits(count);
    pool.run_blocks(count, 64, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) visits[k].fetch_add(1);
    });
    for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(visits[k].load(), 1) << k << " of " << count;
  }
}

TEST_P(ThreadPoolOf, FinishesEachOfManyShortLoopsBeforeTheNext) {
  ThreadPool pool(GetParam());
  std::vector<std::size_t> values(16, 0);
  constexpr std::size_t kLoops = 20000;
  for (std::size_t loop = 0; loop < kLoops; ++loop) {
    // Each item depends on its neighbour's result of the loop before: a late worker would be seen.
    std::vector<std::size_t> next(values.size());
    pool.run(values.size(), [&](std::size_t item, int) { next[item] = values[(item + 1) % 16] + 1; });
    values.swap(next);
  }
  for (const std::size_t value : values) ASSERT_EQ(value, kLoops);
}

INSTANTIATE_TEST_SUITE_P(Threads, ThreadPoolOf, testing::Values(1, 2, 3));

TEST(ThreadPool, TakesFewerThanOneThreadAsOne) {
  EXPECT_EQ(ThreadPool(0).threads(), 1);
  EXPECT_EQ(ThreadPool(-4).threads(), 1);
}

TEST(ThreadPool, StopsItsWorkersWhetherItWasUsedOrNot) {
  for (int round = 0; round < 50; ++round) {
    ThreadPool pool(3);
    if (round % 2 == 0) pool.run(8, [](std::size_t, int) {});
  }
  SUCCEED() << "no worker is left waiting";
}

}  // namespace
}  // namespace eisph
