#pragma once

#include "core/scene.hpp"
#include "probe/fluid_field.hpp"

#include <vector>

namespace eisph {

/// One point of a line.
struct LineSample {
  double distance = 0.0;  ///< m from the start
  Vec3d position = Vec3d::Zero();
  PointSample sample;
};

/// Pressure and velocity at the points of a line, from start to end; each as a point probe's (sample_at).
[[nodiscard]] std::vector<LineSample> sample_line(const LineProbe& line, const FluidField& field);

}  // namespace eisph
