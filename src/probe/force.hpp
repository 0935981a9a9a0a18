#pragma once

#include "core/scene.hpp"
#include "probe/fluid_field.hpp"

namespace eisph {

/// What the water does to a solid. In two dimensions per metre of width.
struct WaterForce {
  Vec3d force = Vec3d::Zero();   ///< N (N/m)
  Vec3d moment = Vec3d::Zero();  ///< N m (N), about the probe's point
  double wetted_area = 0.0;      ///< m^2 (m)
};

/// Force of the water on an obstacle, dam or gate, where it stands at the time of the snapshot, that of its
/// pressure and that of the particles which the repulsion of the surface pushes away:
///
///   F = - sum p n dA - sum m a n,   M = - sum (x - x0) x p n dA - sum (x - x0) x m a n
///
/// The pressure is summed over midpoints of its surface at most a particle spacing apart, p from
/// FluidField::wall_pressure. Parts of the surface on or outside the faces of the domain, on or inside
/// another solid, and dry ones do not count: a solid that stands on the floor has no buoyancy. The repulsion
/// a (m/s^2, core/repulsion.hpp) acts in blows, not at rest. Friction is not included. x0 is the probe's
/// moment point, without one the centre of the base of the closed gate or the solid. Zero for a solid that is
/// not there (a gate that is gone).
///
/// A field of hydrostatic pressure on a lattice of particles gives rho g H^2 / 2 per width on an upright face
/// within 0.3 (dx / H)^2 of it; round solids add the error of the midpoints, of second order in dx over their
/// radius.
[[nodiscard]] WaterForce water_force(const ForceProbe& probe, const FluidField& field);

}  // namespace eisph
