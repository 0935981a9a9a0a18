#include "compare/contour.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace eisph {

namespace {

/// An edge of the grid: 2 * point + 0 from a point to its right neighbour, 2 * point + 1 to its upper one.
using Edge = std::size_t;

/// The other ends of the line segments that end on each edge that a contour line crosses: one or two.
using Links = std::map<Edge, std::vector<Edge>>;

void link(Links& links, Edge a, Edge b) {
  links[a].push_back(b);
  links[b].push_back(a);
}

/// Adds the segments inside the square with the lower left corner (i, j).
void cross_square(const GridValues& grid, double level, std::size_t i, std::size_t j, Links& links) {
  const std::array<double, 4> corners{grid.at(i, j), grid.at(i + 1, j), grid.at(i + 1, j + 1),
                                      grid.at(i, j + 1)};
  double sum = 0.0;
  for (const double corner : corners) sum += corner;
  if (std::isnan(sum)) return;

  const std::size_t point = j * grid.columns + i;
  const std::array<Edge, 4> sides{2 * point, 2 * (point + 1) + 1, 2 * (point + grid.columns), 2 * point + 1};
  std::vector<std::size_t> crossed;
  for (std::size_t side = 0; side < 4; ++side) {
    const bool begins_above = corners[side] >= level;
    const bool ends_above = corners[(side + 1) % 4] >= level;
    if (begins_above != ends_above) crossed.push_back(side);
  }
  if (crossed.size() == 2) link(links, sides[crossed[0]], sides[crossed[1]]);
  if (crossed.size() == 4) {
    // A saddle: the mean of the corners tells which of them are joined through the middle.
    const bool first_is_cut_off = (corners[0] >= level) != (0.25 * sum >= level);
    link(links, sides[0], sides[first_is_cut_off ? 3 : 1]);
    link(links, sides[2], sides[first_is_cut_off ? 1 : 3]);
  }
}

void add_corner(const GridValues& grid, double level, Edge edge, Polyline& line) {
  const std::size_t i = edge / 2 % grid.columns;
  const std::size_t j = edge / 2 / grid.columns;
  const bool is_upright = edge % 2 == 1;
  const double begin = grid.at(i, j);
  const double end = is_upright ? grid.at(i, j + 1) : grid.at(i + 1, j);
  const double part = (level - begin) / (end - begin);
  line.x.push_back(grid.origin_x + grid.spacing * (static_cast<double>(i) + (is_upright ? 0.0 : part)));
  line.y.push_back(grid.origin_y + grid.spacing * (static_cast<double>(j) + (is_upright ? part : 0.0)));
}

void unlink(Links& links, Edge from, Edge to) {
  std::vector<Edge>& ends = links[from];
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (ends[k] != to) continue;
    ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(k));
    return;
  }
}

/// Follows the line that starts on `edge` to its end and takes its segments out of `links`.
Polyline follow(const GridValues& grid, double level, Edge edge, Links& links) {
  Polyline line;
  add_corner(grid, level, edge, line);
  while (!links[edge].empty()) {
    const Edge next = links[edge].back();
    unlink(links, edge, next);
    unlink(links, next, edge);
    add_corner(grid, level, next, line);
    edge = next;
  }
  return line;
}

}  // namespace

std::vector<Polyline> contour_lines(const GridValues& grid, double level) {
  Links links;
  for (std::size_t j = 0; j + 1 < grid.rows; ++j) {
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) cross_square(grid, level, i, j, links);
  }
  std::vector<Polyline> lines;
  for (auto& [edge, ends] : links) {
    if (ends.size() == 1) lines.push_back(follow(grid, level, edge, links));
  }
  for (auto& [edge, ends] : links) {
    if (!ends.empty()) lines.push_back(follow(grid, level, edge, links));
  }
  return lines;
}

}  // namespace eisph
