#include "probe/force.hpp"

#include "core/repulsion.hpp"
#include "core/scene_geometry.hpp"
#include "probe/surface_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Adds what the repulsion of the surface pushes back with.
void add_repulsion(const Shape& shape, const Vec3d& origin, const FluidField& field, WaterForce& result) {
  const Snapshot& snapshot = field.snapshot();
  const Repulsion repulsion = repulsion_of_solids(field.scene());
  if (snapshot.columns || repulsion.cutoff <= 0.0) return;
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  lower.array() -= repulsion.cutoff;
  upper.array() += repulsion.cutoff;
  if (snapshot.dimension == 2) {
    lower.y() = -std::numeric_limits<double>::max();
    upper.y() = std::numeric_limits<double>::max();
  }
  WaterForce part;
  for (const Vec3f& position : snapshot.position) {
    const Vec3d point = position.cast<double>();
    if ((point.array() < lower.array()).any() || (point.array() > upper.array()).any()) continue;
    const double distance = shape.signed_distance(point, snapshot.dimension);
    if (distance >= repulsion.cutoff) continue;
    const Vec3d normal = shape.outward_normal(point, snapshot.dimension);
    const Vec3d push = -snapshot.particle_mass * repulsion.capped(distance) * normal;
    part.force += push;
    part.moment += (point - distance * normal - origin).cross(push);
  }
  if (part.force.isZero() && part.moment.isZero()) return;
  double squared = 0.0;
  for (const Vec3f& velocity : snapshot.velocity) squared = std::max<double>(squared, velocity.squaredNorm());
  const double growth = repulsion_growth(field.scene(), std::sqrt(squared));
  result.force += growth * part.force;
  result.moment += growth * part.moment;
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
  add_repulsion(solid->shape, origin, field, result);
  return result;
}

}  // namespace eisph
