#include "probe/discharge.hpp"

#include "probe/column_probes.hpp"
#include "probe/kernel.hpp"

#include <algorithm>

namespace eisph {

namespace {

constexpr double kWidth = 2.0;  ///< w over the particle spacing

/// Part of the interval of length `length` about `middle` that lies between two ends.
double overlap(double middle, double length, double lower, double upper) {
  const double first = std::max(middle - 0.5 * length, lower);
  const double last = std::min(middle + 0.5 * length, upper);
  return std::max(0.0, last - first) / length;
}

/// Part of a particle that lies in a band. Ends of the band beyond the domain do not cut particles at a wall.
double share_in_band(const Band& band, const Vec3d& position, const Scene& scene) {
  const double dx = scene.particle_spacing;
  double share = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& range = band.range[static_cast<std::size_t>(axis)];
    if (!range) continue;
    const double lower = (*range)[0] <= scene.domain_min[axis] ? position[axis] - dx : (*range)[0];
    const double upper = (*range)[1] >= scene.domain_max[axis] ? position[axis] + dx : (*range)[1];
    share *= overlap(position[axis], dx, lower, upper);
  }
  return share;
}

}  // namespace

double discharge(const DischargeProbe& probe, const Scene& scene, const Snapshot& snapshot) {
  if (snapshot.columns) return column_discharge(probe, *snapshot.columns, scene);
  const double width = kWidth * scene.particle_spacing;
  const int axis = probe.axis;
  double sum = 0.0;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const double weight = axis_spline((snapshot.position[k][axis] - probe.position) / width);
    if (weight == 0.0) continue;
    const double share = share_in_band(probe.band, snapshot.position[k].cast<double>(), scene);
    sum += weight * share * snapshot.velocity[k][axis];
  }
  const double outside = axis_spline_beyond((probe.position - scene.domain_min[axis]) / width) +
                         axis_spline_beyond((scene.domain_max[axis] - probe.position) / width);
  const double volume = snapshot.particle_mass / snapshot.reference_density;
  return volume * sum / (width * (1.0 - outside));
}

}  // namespace eisph
