#include "render/field.hpp"

#include "core/error.hpp"
#include "render/axis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kKilopascalFrom = 1e4;  ///< Pa, upper end of the scale

FieldScale automatic_scale(const Scene& scene, const std::string& field, const std::string& image_name) {
  const double depth = depth_scale(scene);
  const double gravity = scene.gravity.norm();
  const double speed = gravity > 0.0 ? round_up_nicely(2.0 * std::sqrt(gravity * depth)) : 1.0;
  if (field == "speed") return {"speed", 0.0, speed};
  if (field == "velocity_x") return {"velocity in x", -speed, speed};
  if (field == "velocity_y") return {"velocity in y", -speed, speed};
  if (field == "velocity_z") return {"velocity in z", -speed, speed};
  if (field == "pressure") {
    const double pressure = scene.density * gravity * depth;
    return {"pressure", 0.0, pressure > 0.0 ? round_up_nicely(pressure) : 1.0};
  }
  if (field == "depth") return {"water depth", 0.0, round_up_nicely(depth)};
  if (field == "kind") return {"particles", 0.0, 1.0};
  if (field == "water") return {"", 0.0, 1.0};
  throw InputError(fmt::format(
      "{}: image '{}': field = \"{}\"; accepted: speed, velocity_x, velocity_y, velocity_z, pressure, "
      "depth, kind, water",
      scene.source_file, image_name, field));
}

const char* unit_of(const std::string& field, double display_unit) {
  if (field == "pressure") return display_unit > 1.0 ? " (kPa)" : " (Pa)";
  if (field == "depth") return " (m)";
  return field == "kind" || field == "water" ? "" : " (m/s)";
}

float column_depth(const DepthGrid& grid, const Vec3f& position) {
  if (grid.columns == 0 || grid.rows == 0) return 0.0F;
  const auto index = [&](double coordinate, double origin, std::size_t count) {
    const double cell = std::floor((coordinate - origin) / grid.cell_size);
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
  };
  return grid.at(index(position.x(), grid.origin_x, grid.columns),
                 index(position.y(), grid.origin_y, grid.rows));
}

}  // namespace

double depth_scale(const Scene& scene) {
  return scene.reference_depth > 0.0 ? scene.reference_depth : scene.domain_max.z() - scene.domain_min.z();
}

FieldScale field_scale(const Scene& scene, const ImageSettings& settings) {
  const std::string field = settings.kind == ImageKind::DepthMap ? "depth" : settings.field;
  FieldScale scale = automatic_scale(scene, field, settings.name);
  if (settings.range && field != "kind") {
    scale.lower = (*settings.range)[0];
    scale.upper = (*settings.range)[1];
  }
  if (!(scale.upper > scale.lower)) {
    throw InputError(fmt::format("{}: image '{}': range = [{}, {}]: the second number must be the larger one",
                                 scene.source_file, settings.name, scale.lower, scale.upper));
  }
  if (field == "pressure" && std::max(std::abs(scale.lower), std::abs(scale.upper)) >= kKilopascalFrom) {
    scale.display_unit = 1000.0;
  }
  scale.label += unit_of(field, scale.display_unit);
  return scale;
}

std::string colour_map_name(const ImageSettings& settings) {
  if (!settings.colour_map.empty()) return settings.colour_map;
  if (settings.kind == ImageKind::DepthMap || settings.field == "depth") return "depth_blue";
  return settings.field.starts_with("velocity_") ? "blue_red" : "viridis";
}

std::vector<float> field_values(const std::string& field, const Snapshot& snapshot, const DepthGrid& depth,
                                const std::vector<std::uint32_t>& particles) {
  std::vector<float> values(particles.size());
  const auto fill = [&](auto&& value_of) {
    for (std::size_t k = 0; k < particles.size(); ++k) values[k] = value_of(particles[k]);
  };
  if (field == "speed") fill([&](std::uint32_t i) { return snapshot.velocity[i].norm(); });
  if (field == "velocity_x") fill([&](std::uint32_t i) { return snapshot.velocity[i].x(); });
  if (field == "velocity_y") fill([&](std::uint32_t i) { return snapshot.velocity[i].y(); });
  if (field == "velocity_z") fill([&](std::uint32_t i) { return snapshot.velocity[i].z(); });
  if (field == "pressure") fill([&](std::uint32_t i) { return snapshot.pressure[i]; });
  if (field == "depth") fill([&](std::uint32_t i) { return column_depth(depth, snapshot.position[i]); });
  return values;
}

}  // namespace eisph
