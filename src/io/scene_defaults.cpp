#include "io/scene_defaults.hpp"

#include "core/scene_geometry.hpp"
#include "io/schema_value.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kRecordInterval = 0.01;  ///< s, of gauges and probes
constexpr double kThesisPhi = 0.06;       ///< largest dt Umax / dx at which the thesis's stepping is accurate
constexpr double kSoundOverSpeed = 10.0;  ///< c0 over the speed expected: density varies by 1 %
constexpr double kCellsPerSpacing = 1.5;  ///< gauge columns and depth cells over the particle spacing

std::string name_of_file(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char character) { return !is_name(std::string(1, character)); }, '_');
  return name;
}

/// From the highest to the lowest water, as far as it is in the domain.
double water_depth(const Scene& scene) {
  double top = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
  for (const FluidRegion& region : scene.fluid) {
    if (region.cut) continue;
    Vec3d lower;
    Vec3d upper;
    region.shape.bounds(lower, upper);
    top = std::max(top, std::min(upper.z(), scene.domain_max.z()));
    bottom = std::min(bottom, std::max(lower.z(), scene.domain_min.z()));
  }
  return std::max(0.0, top - bottom);
}

/// The largest size up to the particle spacing of which the domain is a whole number long and wide, or the
/// spacing if there is none down to half of it.
double cell_size(const Scene& scene) {
  const Vec3d size = scene.domain_max - scene.domain_min;
  const double spacing = scene.particle_spacing;
  const auto fewest = static_cast<std::int64_t>(std::max(1.0, std::ceil(size.x() / spacing * (1.0 - 1e-9))));
  for (std::int64_t columns = fewest; columns <= 2 * fewest; ++columns) {
    const double side = size.x() / static_cast<double>(columns);
    const double rows = size.y() / side;
    if (scene.dimension == 2 || (rows > 0.5 && std::abs(rows - std::round(rows)) < 1e-6 * rows)) return side;
  }
  return spacing;
}

void complete_schedules(Scene& scene, const TomlSource& source) {
  const auto given = [&](const std::string& prefix) {
    return source.given(prefix + "times") || source.given(prefix + "interval");
  };
  if (!given("output.")) scene.output.frames.times = {scene.end_time};
  if (!given("output.particles_")) scene.output.particles = scene.output.frames;
  if (!given("output.depth_")) scene.output.depth = scene.output.frames;
  for (std::size_t k = 0; k < scene.images.size(); ++k) {
    if (!given(fmt::format("image.{}.", k))) scene.images[k].schedule = scene.output.frames;
  }
}

void complete_images(Scene& scene, const TomlSource& source) {
  for (std::size_t k = 0; k < scene.images.size(); ++k) {
    ImageSettings& image = scene.images[k];
    if (image.style == WaterStyle::Surface && !source.given(fmt::format("image.{}.field", k)))
      image.field = "water";
    if (image.kind != ImageKind::DepthMap) continue;
    image.field = "depth";
    if (!source.given(fmt::format("image.{}.colour_map", k))) image.colour_map = "depth_blue";
  }
}

void complete_probes(Scene& scene) {
  const auto complete_intervals = [](auto& probes) {
    for (auto& probe : probes) {
      if (probe.interval == 0.0) probe.interval = kRecordInterval;
    }
  };
  complete_intervals(scene.gauges);
  complete_intervals(scene.probes);
  complete_intervals(scene.pressure_sensors);
  complete_intervals(scene.fronts);
  complete_intervals(scene.lines);
  complete_intervals(scene.forces);
  complete_intervals(scene.discharges);
  for (Gauge& gauge : scene.gauges) {
    if (gauge.size == 0.0) gauge.size = kCellsPerSpacing * scene.particle_spacing;
    if (gauge.height == 0.0) gauge.height = scene.domain_max.z() - scene.domain_min.z();
  }
  for (PressureSensor& sensor : scene.pressure_sensors) {
    if (sensor.normal != Vec3d::Zero()) continue;
    if (const auto face = nearest_face(scene, sensor.position)) sensor.normal = face->normal;
  }
  for (ForceProbe& force : scene.forces) {
    if (!force.moment_point) force.moment_point = solid_base(scene, force.obstacle);
  }
}

/// Of the measurements in the README, the largest that stayed accurate.
double default_courant(Stepping stepping) {
  switch (stepping) {
    case Stepping::PredictorCorrector:
      return 0.4;
    case Stepping::RungeKutta:
      return 1.25;
    case Stepping::Symplectic:
    case Stepping::Thesis:
      break;
  }
  return 0.25;
}

void complete_scheme(Scene& scene, const TomlSource& source) {
  if (!source.given("particles.smoothing_ratio")) {
    scene.smoothing_ratio = default_smoothing_ratio(scene.kernel, scene.dimension);
  }
  if (!source.given("scheme.free_surface_threshold")) {
    scene.scheme.free_surface_threshold = default_free_surface_threshold(scene.kernel, scene.dimension);
  }
  SchemeSettings& scheme = scene.scheme;
  if (scheme.stepping == Stepping::Thesis) {
    if (!source.given("scheme.phi")) scheme.phi = kThesisPhi;
    if (!scheme.volume_correction) scheme.volume_correction = 0.1;
    if (!source.given("scheme.pair_separation")) scheme.pair_separation = 0.0;
  }
  if (scheme.projects_velocity()) {
    if (!source.given("scheme.source_factor")) scheme.source_factor = 1.0;
    // What comes after the projection is left in the velocity.
    if (!source.given("scheme.viscous_source")) scheme.viscous_source = true;
  }
  if (scheme.sound_speed == 0.0) scheme.sound_speed = kSoundOverSpeed * scene.expected_speed();
  if (scheme.courant == 0.0) scheme.courant = default_courant(scheme.stepping);
}

}  // namespace

void complete_scene(Scene& scene, const TomlSource& source) {
  if (!source.given("name")) scene.name = name_of_file(source.file());
  if (!source.given("title")) scene.title = scene.name;
  if (!scene.comparison.empty()) {
    const auto folder = std::filesystem::absolute(source.file()).parent_path();
    scene.comparison = (folder / scene.comparison).lexically_normal().string();
  }
  if (!source.given("fluid.reference_depth")) scene.reference_depth = water_depth(scene);
  complete_scheme(scene, source);
  complete_probes(scene);
  if (scene.output.depth_cell_size == 0.0)
    scene.output.depth_cell_size = kCellsPerSpacing * scene.particle_spacing;
  if (scene.shallow_water.cell_size == 0.0) scene.shallow_water.cell_size = cell_size(scene);
  complete_schedules(scene, source);
  complete_images(scene, source);
}

}  // namespace eisph
