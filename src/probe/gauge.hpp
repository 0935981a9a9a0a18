#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "probe/fluid_field.hpp"

namespace eisph {

/// Water level at a gauge, metres above the floor (scene.domain_min.z): the height of the centre of the
/// highest fluid particle in a square column of side gauge.size about (gauge.x, gauge.y), edges included, and
/// up to gauge.height; with gauge.ignore_spray the highest that is no spray (SprayRule). Zero if the column
/// is empty. In two dimensions the column is an interval in x. A size of zero means 1.5 particle spacings, a
/// height of zero the domain's.
[[nodiscard]] double water_level(const Gauge& gauge, const Scene& scene, const Snapshot& snapshot);

/// Free surface on the axis of a gauge, metres above the floor: where the water fraction
/// (FluidField::water_fraction) falls to one half on the way up, starting on the floor or on the solid that
/// stands there, and not farther than gauge.height. Spray above the surface is not seen. Zero where the way
/// begins dry. For a lattice of particles at rest it is the water level, half a spacing above the highest
/// particles, to 1e-4 spacings, also on walls, in corners and on faces of solids; layers of less than about
/// 0.4 spacings read zero.
[[nodiscard]] double surface_level(const Gauge& gauge, const FluidField& field);

}  // namespace eisph
