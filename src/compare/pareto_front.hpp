#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace eisph {

/// What a setting costs and how far off it is; both are to be small.
struct CostAndError {
  double cost = 0.0;
  double error = 0.0;
};

/// Indices of the points that no other one beats: none is as cheap and as accurate, and better in one of
/// both. In the order of rising cost; of equal points the first one. Points that are not finite take no part.
[[nodiscard]] std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

/// The cheapest point whose error is not above `level`; nothing if there is none.
[[nodiscard]] std::optional<std::size_t> cheapest_within(const std::vector<CostAndError>& points,
                                                         double level);

}  // namespace eisph
