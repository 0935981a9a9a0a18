#include "sph/cell_sort.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

std::vector<std::uint32_t> random_keys(std::size_t count, std::uint32_t cells, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<std::uint32_t> cell(0, cells);  // `cells` itself: at the end
  std::vector<std::uint32_t> keys(count);
  for (auto& key : keys) key = cell(generator);
  return keys;
}

class CellSortWithThreads : public testing::TestWithParam<int> {};

TEST_P(CellSortWithThreads, EqualsAStableSort) {
  ThreadPool pool(GetParam());
  CellSort sort;
  CellSort::Workspace workspace;
  // Used again and again for different sizes, as in a run.
  for (const std::size_t count : {0U, 1U, 2U, 17U, 5000U, 300U}) {
    constexpr std::uint32_t kCells = 37;
    const auto keys = random_keys(count, kCells, static_cast<unsigned>(count));
    sort.sort(count, kCells, pool, workspace, [&](std::size_t i) { return keys[i]; });
    std::vector<std::uint32_t> expected(count);
    std::iota(expected.begin(), expected.end(), 0U);
    std::stable_sort(expected.begin(), expected.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
    EXPECT_EQ(std::vector<std::uint32_t>(sort.order(), sort.order() + count), expected) << count;
    for (std::uint32_t cell = 0; cell <= kCells + 1; ++cell) {
      const auto below = std::count_if(keys.begin(), keys.end(), [&](auto key) { return key < cell; });
      EXPECT_EQ(sort.start()[cell], static_cast<std::uint32_t>(below)) << "cell " << cell;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, CellSortWithThreads, testing::Values(1, 2, 3));

}  // namespace
}  // namespace eisph
