#include "sph/cell_grid.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Cells next to the cell of `at`, in the order in which they are visited.
template <int Dim>
std::vector<std::size_t> visited_cells(const CellGrid<Dim>& grid, const float* at) {
  std::vector<std::size_t> cells;
  grid.for_neighbour_runs(grid.coordinates(grid.index(at)), [&](std::size_t first, std::size_t last) {
    for (std::size_t cell = first; cell <= last; ++cell) cells.push_back(cell);
  });
  return cells;
}

template <int Dim>
void expect_all_neighbours_covered() {
  std::array<double, Dim> extent{};
  for (int d = 0; d < Dim; ++d) extent[d] = 9.3 + 2.1 * d;
  const CellGrid<Dim> grid(extent);
  std::mt19937 generator(7);
  // From well below the domain to well above it.
  std::uniform_real_distribution<float> anywhere(-7.0F, 20.0F);
  std::uniform_real_distribution<float> direction(-2.0F, 2.0F);
  for (int trial = 0; trial < 20000; ++trial) {
    std::array<float, Dim> at{};
    std::array<float, Dim> other{};
    double squared = 0.0;
    for (int d = 0; d < Dim; ++d) {
      at[d] = anywhere(generator);
      other[d] = at[d] + direction(generator);
      squared += (other[d] - at[d]) * (other[d] - at[d]);
    }
    if (squared >= 4.0) continue;
    const std::uint32_t cell = grid.index(other.data());
    ASSERT_LT(cell, grid.cells());
    const auto visited = visited_cells(grid, at.data());
    ASSERT_EQ(std::count(visited.begin(), visited.end(), cell), 1) << "trial " << trial;
  }
}

TEST(CellGrid, NeighbourRunsCoverTheSupportInsideAndOutsideTheDomain) {
  expect_all_neighbours_covered<2>();
  expect_all_neighbours_covered<3>();
}

TEST(CellGrid, IndexAndCoordinatesAreInverse) {
  const CellGrid<3> grid({6.0, 10.0, 4.0});
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    const auto at = grid.coordinates(cell);
    const auto& counts = grid.counts();
    const auto index = static_cast<std::size_t>((at[0] * counts[1] + at[1]) * counts[2] + at[2]);
    ASSERT_EQ(index, cell);
  }
}

TEST(CellGrid, VisitsThreeRunsInThePlaneAndNineInSpace) {
  const auto runs = [](const auto& grid, const auto& at) {
    int count = 0;
    grid.for_neighbour_runs(at, [&](std::size_t, std::size_t) { ++count; });
    return count;
  };
  EXPECT_EQ(runs(CellGrid<2>({20.0, 20.0}), std::array<int, 2>{4, 4}), 3);
  EXPECT_EQ(runs(CellGrid<3>({20.0, 20.0, 20.0}), std::array<int, 3>{4, 4, 4}), 9);
  EXPECT_EQ(runs(CellGrid<3>({20.0, 20.0, 20.0}), std::array<int, 3>{0, 0, 0}), 4) << "corner of the grid";
}

TEST(CellGrid, TheVerticalRunsFastest) {
  const CellGrid<3> grid({20.0, 20.0, 20.0});
  const std::array<float, 3> low = {5.0F, 5.0F, 5.0F};
  const std::array<float, 3> high = {5.0F, 5.0F, 9.5F};
  const int rise = grid.coordinate(9.5F, 2) - grid.coordinate(5.0F, 2);
  EXPECT_GE(rise, 2);
  EXPECT_EQ(grid.index(high.data()) - grid.index(low.data()), static_cast<std::uint32_t>(rise));
}

TEST(CellGrid, BoundsHoldEveryPointOfTheCell) {
  const CellGrid<3> grid({9.0, 6.0, 12.0});
  std::mt19937 generator(11);
  std::uniform_real_distribution<float> anywhere(-9.0F, 20.0F);
  for (int trial = 0; trial < 20000; ++trial) {
    const std::array<float, 3> at = {anywhere(generator), anywhere(generator), anywhere(generator)};
    std::array<float, 3> lower{};
    std::array<float, 3> upper{};
    grid.bounds(grid.coordinates(grid.index(at.data())), lower, upper);
    for (std::size_t d = 0; d < 3; ++d) {
      ASSERT_GE(at[d], lower[d]) << "axis " << d;
      ASSERT_LE(at[d], upper[d]) << "axis " << d;
    }
  }
}

}  // namespace
}  // namespace eisph
