#include "probe/force.hpp"

#include "core/scene_geometry.hpp"
#include "probe/surface_elements.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace eisph {

namespace {

/// Whether there is room for water in front of an element of solid `own`.
bool is_free(const SurfaceElement& element, std::size_t own, const FluidField& field) {
  const double dx = field.snapshot().particle_spacing;
  const Vec3d in_front = element.point + 0.25 * dx * element.normal;
  if (!field.is_in_domain(in_front) || !field.is_in_domain(element.point)) return false;
  for (std::size_t s = 0; s < field.solids().size(); ++s) {
    if (s != own && field.solids()[s].shape.contains(in_front, field.snapshot().dimension)) return false;
  }
  return true;
}

}  // namespace

WaterForce water_force(const ForceProbe& probe, const FluidField& field) {
  WaterForce result;
  const auto& solids = field.solids();
  const auto solid = std::find_if(solids.begin(), solids.end(), [&](const StandingSolid& candidate) {
    return candidate.name == probe.obstacle;
  });
  if (solid == solids.end()) return result;
  const Vec3d origin = probe.moment_point ? *probe.moment_point
                                          : solid_base(field.scene(), probe.obstacle).value_or(Vec3d::Zero());
  const auto own = static_cast<std::size_t>(solid - solids.begin());
  const Snapshot& snapshot = field.snapshot();
  for (const SurfaceElement& element :
       surface_elements(solid->shape, snapshot.particle_spacing, snapshot.dimension)) {
    if (!is_free(element, own, field)) continue;
    const std::optional<double> pressure = field.wall_pressure(element.point, element.normal);
    if (!pressure) continue;
    const Vec3d part = -*pressure * element.area * element.normal;
    result.force += part;
    result.moment += (element.point - origin).cross(part);
    result.wetted_area += element.area;
  }
  return result;
}

}  // namespace eisph
