#pragma once

#include "core/scene.hpp"
#include "io/schema_table.hpp"

namespace eisph {

/// All keys of a scene file.
[[nodiscard]] KeyTable<Scene> scene_keys();

// Parts of it.
[[nodiscard]] KeyTable<std::array<Face, kFaceCount>> faces_keys();
[[nodiscard]] KeyTable<FluidRegion> fluid_region_keys();
[[nodiscard]] KeyTable<Obstacle> obstacle_keys();
[[nodiscard]] KeyTable<Gate> gate_keys();
[[nodiscard]] KeyTable<Gauge> gauge_keys();
[[nodiscard]] KeyTable<PointProbe> probe_keys();
[[nodiscard]] KeyTable<PressureSensor> pressure_sensor_keys();
[[nodiscard]] KeyTable<FrontProbe> front_keys();
[[nodiscard]] KeyTable<LineProbe> line_keys();
[[nodiscard]] KeyTable<ForceProbe> force_keys();
[[nodiscard]] KeyTable<DischargeProbe> discharge_keys();
[[nodiscard]] KeyTable<SchemeSettings> scheme_keys();
[[nodiscard]] KeyTable<ShallowWaterSettings> shallow_water_keys();
[[nodiscard]] KeyTable<BoundarySettings> boundary_keys();
[[nodiscard]] KeyTable<OutputSettings> output_keys();
[[nodiscard]] KeyTable<ImageSettings> image_keys();

}  // namespace eisph
