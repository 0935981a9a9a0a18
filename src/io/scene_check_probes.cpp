#include "core/scene_geometry.hpp"
#include "io/scene_check.hpp"
#include "io/schema_value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eisph {

namespace {

constexpr const char* kAxisNames = "xyz";
constexpr double kTolerance = 1e-6;  ///< lengths, over the particle spacing

/// Stops at probes that are not where water can be.
class ProbeCheck {
 public:
  ProbeCheck(const Scene& scene, const TomlSource& source) : scene_(scene), source_(source) {}

  void inside(const Vec3d& point, const std::vector<int>& axes, const std::string& path,
              const std::string& what) const {
    if (is_inside(point, axes)) return;
    source_.fail(path,
                 fmt::format("{} is outside the domain; expected a place in {}", what, domain_text(scene_)));
  }

  void range(const Band& band, const std::string& path) const {
    for (const int axis : scene_axes(scene_)) {
      const auto& ends = band.range[static_cast<std::size_t>(axis)];
      if (!ends) continue;
      if ((*ends)[0] < scene_.domain_max[axis] && (*ends)[1] > scene_.domain_min[axis]) continue;
      source_.fail(fmt::format("{}.{}_range", path, kAxisNames[axis]),
                   fmt::format("the range is outside the domain; expected part of {}", domain_text(scene_)));
    }
  }

  void sensor(const PressureSensor& sensor, const std::string& path) const {
    inside(sensor.position, scene_axes(scene_), path + ".position", "the sensor");
    const double dx = scene_.particle_spacing;
    if (!source_.given(path + ".normal")) {
      const auto face = nearest_face(scene_, sensor.position);
      if (!face || face->distance > dx) {
        source_.fail(path + ".position",
                     "no face of the domain that is not open is within a particle spacing of the sensor; "
                     "expected a place on a wall, or the direction from another surface as normal");
      }
    }
    const double reach = 0.5 * sensor.size - kTolerance * dx;
    const Vec3d direction = sensor.normal.normalized();
    for (const int axis : scene_axes(scene_)) {
      // Extent of a disc; the corners of a square may reach a little farther.
      const double extent = reach * std::sqrt(std::max(0.0, 1.0 - direction[axis] * direction[axis]));
      if (sensor.position[axis] - extent >= scene_.domain_min[axis] &&
          sensor.position[axis] + extent <= scene_.domain_max[axis]) {
        continue;
      }
      source_.fail(path + ".size",
                   fmt::format("the sensor reaches out of the domain in {}; expected it within {}",
                               kAxisNames[axis], domain_text(scene_)));
    }
  }

  /// A sensor sees the water once in an interval: what it does in between cannot be told.
  void response(const PressureSensor& sensor, const std::string& path) const {
    if (sensor.response_time <= 0.0 || sensor.response_time >= (1.0 - kTolerance) * sensor.interval) return;
    source_.fail(path + ".response_time",
                 fmt::format("is less than the {} s between two records; expected at least that, or 0",
                             sensor.interval));
  }

  void force(const ForceProbe& force, const std::string& path) const {
    if (solid_base(scene_, force.obstacle)) return;
    std::vector<std::string> names;
    for (const Obstacle& obstacle : scene_.obstacles) names.push_back(obstacle.name);
    for (const Gate& gate : scene_.gates) names.push_back(gate.name);
    source_.fail(path + ".obstacle",
                 fmt::format("there is no such solid; expected {}",
                             names.empty() ? std::string("a scene with an [[obstacle]], [[dam]] or [[gate]]")
                                           : fmt::format("one of {}", fmt::join(names, ", "))));
  }

  void discharge(const DischargeProbe& plane, const std::string& path) const {
    if (scene_.dimension == 2 && plane.axis == 1) {
      source_.fail(path + ".axis", "a 2D scene has no y; expected \"x\" or \"z\"");
    }
    Vec3d point = scene_.domain_min;
    point[plane.axis] = plane.position;
    inside(point, {plane.axis}, path + ".position", "the plane");
    range(plane.band, path);
  }

 private:
  [[nodiscard]] bool is_inside(const Vec3d& point, const std::vector<int>& axes) const {
    return std::all_of(axes.begin(), axes.end(), [&](int axis) {
      return point[axis] >= scene_.domain_min[axis] && point[axis] <= scene_.domain_max[axis];
    });
  }

  const Scene& scene_;
  const TomlSource& source_;
};

}  // namespace

void check_probes(const Scene& scene, const TomlSource& source) {
  const ProbeCheck check(scene, source);
  const auto each = [](const auto& probes, const char* section, const auto& visit) {
    for (std::size_t k = 0; k < probes.size(); ++k) visit(probes[k], fmt::format("{}.{}", section, k));
  };
  const std::vector<int> axes = scene_axes(scene);
  const std::vector<int> level = scene.dimension == 2 ? std::vector<int>{0} : std::vector<int>{0, 1};
  each(scene.gauges, "gauge", [&](const Gauge& gauge, const std::string& path) {
    check.inside(Vec3d(gauge.x, gauge.y, 0.0), level, path + ".position", "the gauge");
  });
  each(scene.probes, "probe", [&](const PointProbe& probe, const std::string& path) {
    check.inside(probe.position, axes, path + ".position", "the probe");
  });
  each(scene.pressure_sensors, "pressure_sensor", [&](const PressureSensor& sensor, const std::string& path) {
    check.sensor(sensor, path);
    check.response(sensor, path);
  });
  each(scene.fronts, "front",
       [&](const FrontProbe& front, const std::string& path) { check.range(front.band, path); });
  each(scene.lines, "line", [&](const LineProbe& line, const std::string& path) {
    check.inside(line.start, axes, path + ".start", "the line's start");
    check.inside(line.end, axes, path + ".end", "the line's end");
    if (line.start == line.end) source.fail(path + ".end", "is the start as well; expected another point");
  });
  each(scene.forces, "force",
       [&](const ForceProbe& force, const std::string& path) { check.force(force, path); });
  each(scene.discharges, "discharge",
       [&](const DischargeProbe& plane, const std::string& path) { check.discharge(plane, path); });
}

}  // namespace eisph
