#include "probe/line_probe.hpp"

#include <algorithm>

namespace eisph {

std::vector<LineSample> sample_line(const LineProbe& line, const FluidField& field) {
  const int intervals = std::max(line.points - 1, 1);
  const double length = (line.end - line.start).norm();
  std::vector<LineSample> samples;
  for (int k = 0; k < line.points; ++k) {
    const double share = static_cast<double>(k) / intervals;
    const Vec3d position = (1.0 - share) * line.start + share * line.end;
    samples.push_back({share * length, position, field.sample_at(position)});
  }
  return samples;
}

}  // namespace eisph
