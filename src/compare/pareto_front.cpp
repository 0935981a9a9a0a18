#include "compare/pareto_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eisph {

namespace {

bool is_usable(const CostAndError& point) { return std::isfinite(point.cost) && std::isfinite(point.error); }

}  // namespace

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_usable(points[k])) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (points[a].cost != points[b].cost) return points[a].cost < points[b].cost;
    return points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t k : order) {
    if (!(points[k].error < least)) continue;
    least = points[k].error;
    front.push_back(k);
  }
  return front;
}

std::optional<std::size_t> cheapest_within(const std::vector<CostAndError>& points, double level) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!is_usable(points[k]) || points[k].error > level) continue;
    if (!best || points[k].cost < points[*best].cost) best = k;
  }
  return best;
}

}  // namespace eisph
