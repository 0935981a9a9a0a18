#include "core/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

double Schedule::next_after(double time, double tolerance) const {
  double next = std::numeric_limits<double>::infinity();
  const auto listed = std::upper_bound(times.begin(), times.end(), time + tolerance);
  if (listed != times.end()) next = *listed;
  if (interval > 0.0) next = std::min(next, interval * (std::floor((time + tolerance) / interval) + 1.0));
  return next;
}

bool Schedule::is_due(double time, double tolerance) const {
  const bool listed =
      std::any_of(times.begin(), times.end(), [&](double due) { return std::abs(due - time) <= tolerance; });
  return listed || (interval > 0.0 && std::abs(time - interval * std::round(time / interval)) <= tolerance);
}

}  // namespace eisph
