#pragma once

#include "compare/contour.hpp"
#include "compare/curve.hpp"
#include "compare/curve_difference.hpp"
#include "compare/field_plot.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <vector>

namespace eisph {

// What validation cases take from a state: curves, fields and points in a vertical plane.

/// A stretch of the x axis at one y, m.
struct Section {
  double first = 0.0;
  double last = 0.0;
  double y = 0.0;
};

/// Height (m above the floor) of the free surface along a section, at most half a particle spacing apart;
/// zero where it is dry.
[[nodiscard]] Curve surface_profile(const Scene& scene, const Snapshot& state, const Section& section);

/// Points (m) of the whole free surface in the section, those under an overturning wave included: the lines
/// on which the water fraction is one half, up to `height` above the floor.
[[nodiscard]] std::vector<PlanePoint> surface_points(const Scene& scene, const Snapshot& state,
                                                     const Section& section, double height);

/// Pressure (Pa) in the plane of the section up to `height` above the floor, interpolated with the kernel on
/// a grid of half a particle spacing; not-a-number outside the water.
[[nodiscard]] GridValues pressure_field(const Scene& scene, const Snapshot& state, const Section& section,
                                        double height);
/// Largest value of a field.
[[nodiscard]] double largest(const GridValues& field);

/// Particles whose y is within half a spacing of the section's plane, coloured by pressure, Pa.
[[nodiscard]] ScatterPlot pressure_scatter(const Snapshot& state, const Section& section, double height);

/// RMS over the particles of the difference to the hydrostatic pressure under a level (m above the floor),
/// divided by that at the floor.
[[nodiscard]] double hydrostatic_error(const Scene& scene, const Snapshot& state, double level);
/// Root mean square of the speed, m/s.
[[nodiscard]] double speed_rms(const Snapshot& state);

/// Depths of one model against another's, over as many places and times as are added.
class DepthDifference {
 public:
  /// Depths (m) up to `dry` count as none in the overlap of the wetted areas.
  explicit DepthDifference(double dry) : dry_(dry) {}

  /// Adds the depths (m) of both at one place and time.
  void add(double depth, double reference);

  /// Root mean square of the difference, m.
  [[nodiscard]] double rms() const;
  /// Mean of depth - reference, m.
  [[nodiscard]] double bias() const;
  /// Places wetted in both over those wetted in either.
  [[nodiscard]] double wetted_overlap() const;

 private:
  double dry_;
  double squares_ = 0.0;
  double sum_ = 0.0;
  double places_ = 0.0;
  double both_ = 0.0;
  double either_ = 0.0;
};

}  // namespace eisph
