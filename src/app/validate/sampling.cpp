#include "app/validate/sampling.hpp"

#include "compare/hydrostatic.hpp"
#include "probe/fluid_field.hpp"
#include "probe/gauge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eisph {

namespace {

constexpr double kPointsPerSpacing = 2.0;

/// A grid over the section, its points 1 / kPointsPerSpacing of a particle spacing apart.
GridValues section_grid(const Scene& scene, const Section& section, double height) {
  GridValues grid;
  grid.spacing = scene.particle_spacing / kPointsPerSpacing;
  grid.origin_x = section.first;
  grid.origin_y = scene.domain_min.z();
  grid.columns = static_cast<std::size_t>(std::lround((section.last - section.first) / grid.spacing)) + 1;
  grid.rows = static_cast<std::size_t>(std::lround(height / grid.spacing)) + 1;
  grid.values.assign(grid.columns * grid.rows, std::numeric_limits<double>::quiet_NaN());
  return grid;
}

template <class Value>
void fill(GridValues& grid, double y, const Value& value) {
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      grid.values[j * grid.columns + i] =
          value(Vec3d(grid.origin_x + static_cast<double>(i) * grid.spacing, y,
                      grid.origin_y + static_cast<double>(j) * grid.spacing));
    }
  }
}

}  // namespace

Curve surface_profile(const Scene& scene, const Snapshot& state, const Section& section) {
  const double spacing = scene.particle_spacing / kPointsPerSpacing;
  const auto points = static_cast<std::size_t>(std::lround((section.last - section.first) / spacing)) + 1;
  const FluidField field(scene, state);
  Gauge gauge;
  gauge.y = section.y;
  gauge.height = scene.domain_max.z() - scene.domain_min.z();
  Curve profile;
  for (std::size_t k = 0; k < points; ++k) {
    gauge.x = std::min(section.first + static_cast<double>(k) * spacing, section.last);
    profile.add(gauge.x, surface_level(gauge, field));
  }
  return profile;
}

std::vector<PlanePoint> surface_points(const Scene& scene, const Snapshot& state, const Section& section,
                                       double height) {
  const FluidField field(scene, state);
  GridValues fraction = section_grid(scene, section, height);
  fill(fraction, section.y, [&](const Vec3d& point) { return field.water_fraction(point); });
  std::vector<PlanePoint> points;
  for (const Polyline& line : contour_lines(fraction, 0.5)) {
    for (std::size_t k = 0; k < line.x.size(); ++k) points.push_back({line.x[k], line.y[k]});
  }
  return points;
}

GridValues pressure_field(const Scene& scene, const Snapshot& state, const Section& section, double height) {
  const FluidField field(scene, state);
  GridValues pressure = section_grid(scene, section, height);
  fill(pressure, section.y, [&](const Vec3d& point) {
    return field.is_wet(point) ? field.sample_at(point).pressure : std::numeric_limits<double>::quiet_NaN();
  });
  return pressure;
}

double largest(const GridValues& field) {
  double most = std::numeric_limits<double>::quiet_NaN();
  for (const double value : field.values) most = std::fmax(most, value);
  return most;
}

ScatterPlot pressure_scatter(const Snapshot& state, const Section& section, double height) {
  ScatterPlot plot;
  plot.x_label = "x [m]";
  plot.y_label = "z [m]";
  plot.value_label = "pressure [Pa]";
  plot.point_size = state.particle_spacing;
  plot.x_range = {section.first, section.last};
  plot.y_range = {0.0, height};
  for (std::size_t k = 0; k < state.size(); ++k) {
    const Vec3f& at = state.position[k];
    if (state.dimension == 3 && std::abs(at.y() - section.y) > 0.5 * state.particle_spacing) continue;
    plot.x.push_back(at.x());
    plot.y.push_back(at.z());
    plot.value.push_back(state.pressure[k]);
  }
  return plot;
}

double hydrostatic_error(const Scene& scene, const Snapshot& state, double level) {
  const double gravity = scene.gravity.norm();
  double squares = 0.0;
  for (std::size_t k = 0; k < state.size(); ++k) {
    const double height = state.position[k].z() - scene.domain_min.z();
    const double expected = hydrostatic_pressure(level, height, scene.density, gravity);
    squares += (state.pressure[k] - expected) * (state.pressure[k] - expected);
  }
  return std::sqrt(squares / static_cast<double>(state.size())) / (scene.density * gravity * level);
}

double speed_rms(const Snapshot& state) {
  double squares = 0.0;
  for (const Vec3f& velocity : state.velocity) squares += velocity.cast<double>().squaredNorm();
  return std::sqrt(squares / static_cast<double>(state.size()));
}

void DepthDifference::add(double depth, double reference) {
  const double difference = depth - reference;
  squares_ += difference * difference;
  sum_ += difference;
  places_ += 1.0;
  const bool wet = depth > dry_;
  const bool reference_wet = reference > dry_;
  both_ += wet && reference_wet ? 1.0 : 0.0;
  either_ += wet || reference_wet ? 1.0 : 0.0;
}

double DepthDifference::rms() const { return std::sqrt(squares_ / places_); }

double DepthDifference::bias() const { return sum_ / places_; }

double DepthDifference::wetted_overlap() const { return both_ / std::max(either_, 1.0); }

}  // namespace eisph
