#include "compare/contour.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

GridValues sampled(std::size_t columns, std::size_t rows, double spacing, double (*value)(double, double)) {
  GridValues grid{
      .origin_x = -1.0, .origin_y = -1.0, .spacing = spacing, .columns = columns, .rows = rows, .values = {}};
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      grid.values.push_back(
          value(-1.0 + spacing * static_cast<double>(i), -1.0 + spacing * static_cast<double>(j)));
    }
  }
  return grid;
}

TEST(ContourLines, OfAPlaneAreStraight) {
  const GridValues grid{.origin_x = 10.0,
                        .origin_y = 20.0,
                        .spacing = 2.0,
                        .columns = 2,
                        .rows = 3,
                        .values = {0.0, 4.0, 0.0, 4.0, 0.0, 4.0}};
  const std::vector<Polyline> lines = contour_lines(grid, 1.0);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_THAT(lines[0].x, ElementsAre(DoubleEq(10.5), DoubleEq(10.5), DoubleEq(10.5)));
  EXPECT_THAT(lines[0].y, ElementsAre(DoubleEq(20.0), DoubleEq(22.0), DoubleEq(24.0)));
}

TEST(ContourLines, OfAConeAreACircleThatCloses) {
  const GridValues grid = sampled(81, 81, 0.025, [](double x, double y) { return std::hypot(x, y); });
  const std::vector<Polyline> lines = contour_lines(grid, 0.7);
  ASSERT_THAT(lines, SizeIs(1));
  const Polyline& circle = lines[0];
  EXPECT_EQ(circle.x.front(), circle.x.back());
  EXPECT_EQ(circle.y.front(), circle.y.back());
  double length = 0.0;
  for (std::size_t k = 0; k < circle.x.size(); ++k) {
    EXPECT_NEAR(std::hypot(circle.x[k], circle.y[k]), 0.7, 2e-4);
    if (k > 0) length += std::hypot(circle.x[k] - circle.x[k - 1], circle.y[k] - circle.y[k - 1]);
  }
  EXPECT_NEAR(length, 2.0 * M_PI * 0.7, 2e-3);
}

TEST(ContourLines, DoNotEnterSquaresWithoutAValue) {
  GridValues grid = sampled(5, 3, 1.0, [](double, double y) { return y; });
  grid.values[2] = std::nan("");  // bottom row, in the middle: splits the lower line in two
  EXPECT_THAT(contour_lines(grid, -0.5), SizeIs(2));
  EXPECT_THAT(contour_lines(grid, 0.5), SizeIs(1));
}

TEST(ContourLines, OfASaddleDoNotCross) {
  const GridValues grid{.origin_x = 0.0,
                        .origin_y = 0.0,
                        .spacing = 1.0,
                        .columns = 2,
                        .rows = 2,
                        .values = {1.0, 0.0, 0.0, 1.0}};
  // The middle has 0.5: above 0.4 the high corners are joined, so that the lines cut the low ones off.
  const std::vector<Polyline> joined = contour_lines(grid, 0.4);
  ASSERT_THAT(joined, SizeIs(2));
  for (const Polyline& line : joined) {
    ASSERT_THAT(line.x, SizeIs(2));
    const double x = 0.5 * (line.x[0] + line.x[1]);
    const double y = 0.5 * (line.y[0] + line.y[1]);
    EXPECT_GT(std::abs(x - y), 0.5);  // near (1, 0) or (0, 1)
  }
  for (const Polyline& line : contour_lines(grid, 0.6)) {
    EXPECT_LT(std::abs(0.5 * (line.x[0] + line.x[1] - line.y[0] - line.y[1])),
              1e-12);  // near (0, 0) or (1, 1)
  }
}

TEST(ContourLines, AreAbsentWhereTheLevelIsNot) {
  const GridValues grid = sampled(4, 4, 0.5, [](double x, double) { return x; });
  EXPECT_THAT(contour_lines(grid, 7.0), IsEmpty());
  EXPECT_THAT(contour_lines(GridValues{}, 0.0), IsEmpty());
}

}  // namespace
}  // namespace eisph
