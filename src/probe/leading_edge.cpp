#include "probe/leading_edge.hpp"

#include "probe/column_probes.hpp"

#include <cmath>
#include <limits>

namespace eisph {

LeadingEdge leading_edge(const Snapshot& snapshot, double bulk_number_density) {
  if (snapshot.columns) return column_front(*snapshot.columns);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  LeadingEdge edge{kNone, kNone};
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const double x = snapshot.position[k].x();
    edge.front = std::fmax(edge.front, x);
    if (snapshot.number_density[k] >= bulk_number_density) edge.bulk_front = std::fmax(edge.bulk_front, x);
  }
  return edge;
}

}  // namespace eisph
