#pragma once

#include <vector>

namespace eisph {

/// Observed order p of convergence, error ~ spacing^p.
struct ConvergenceOrder {
  double least_squares = 0.0;    ///< slope of log(error) over log(spacing) through all spacings
  std::vector<double> pairwise;  ///< between neighbours, from the coarsest pair to the finest
};

/// Spacings and errors in any order. Throws std::invalid_argument unless there are at least two of each, all
/// spacings differ, and all are positive. Without a known solution pass differences of successive solutions.
[[nodiscard]] ConvergenceOrder observed_order(const std::vector<double>& spacings,
                                              const std::vector<double>& errors);

}  // namespace eisph
