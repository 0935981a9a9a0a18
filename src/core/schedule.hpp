#pragma once

#include <limits>
#include <vector>

namespace eisph {

/// Times at which something is due: a list, an interval, or both. Seconds.
struct Schedule {
  std::vector<double> times;  ///< ascending
  double interval = 0.0;      ///< 0: none. Multiples of it from t = 0 on are due.

  [[nodiscard]] bool empty() const { return times.empty() && interval <= 0.0; }
  /// The first due time after `time` (by more than `tolerance`), infinity if there is none.
  [[nodiscard]] double next_after(double time, double tolerance = 1e-9) const;
  /// Whether `time` is a due time within `tolerance`.
  [[nodiscard]] bool is_due(double time, double tolerance = 1e-9) const;

  bool operator==(const Schedule&) const = default;
};

}  // namespace eisph
