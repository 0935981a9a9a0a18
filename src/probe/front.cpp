#include "probe/front.hpp"

#include <cmath>
#include <limits>

namespace eisph {

LeadingEdge front_position(const FrontProbe& probe, const Snapshot& snapshot, double bulk_number_density) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  LeadingEdge edge{kNone, kNone};
  const auto farther = [&](double present, double other) {
    return probe.upwards ? std::fmax(present, other) : std::fmin(present, other);
  };
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const Vec3d position = snapshot.position[k].cast<double>();
    if (!probe.band.contains(position)) continue;
    const double coordinate = position[probe.axis];
    edge.front = farther(edge.front, coordinate);
    if (snapshot.number_density[k] >= bulk_number_density) {
      edge.bulk_front = farther(edge.bulk_front, coordinate);
    }
  }
  return edge;
}

}  // namespace eisph
