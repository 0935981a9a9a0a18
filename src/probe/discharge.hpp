#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"

namespace eisph {

/// Volume of water that passes a plane, in m^3/s (m^2/s in two dimensions), positive along the axis:
///
///   Q = sum_j V_j u_j,n D(x_j,n - position) / I,   D(d) = axis_spline(d / w) / w,   w = 2 dx
///
/// with V_j = m / rho0; D reaches 2 w to both sides and has unit integral, and I is the part of it that lies
/// in the domain. A particle at the edge of a restricted plane counts with the part of its cube of side dx
/// that lies in the band. A uniform stream on a lattice comes out to rounding, wherever the plane is.
[[nodiscard]] double discharge(const DischargeProbe& probe, const Scene& scene, const Snapshot& snapshot);

}  // namespace eisph
