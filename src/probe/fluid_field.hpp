#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "probe/fluid_cells.hpp"
#include "probe/point_probe.hpp"

#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// An obstacle, dam or gate where it stands at one time.
struct StandingSolid {
  std::string name;
  Shape shape;
};

/// Obstacles, then the gates that are still there, lifted as far as they are at `time` (s).
[[nodiscard]] std::vector<StandingSolid> standing_solids(const Scene& scene, double time);

/// The water of one snapshot as a continuum: what probes that look at more than single particles ask. Sorts
/// the particles once when it is made. Keeps references to scene and snapshot. A snapshot with columns is
/// seen through them: a point is wet or dry, and pressure is hydrostatic (probe/column_probes.hpp).
class FluidField {
 public:
  FluidField(const Scene& scene, const Snapshot& snapshot);

  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const Snapshot& snapshot() const { return *snapshot_; }
  [[nodiscard]] const std::vector<StandingSolid>& solids() const { return solids_; }

  /// As the function sample_at.
  [[nodiscard]] PointSample sample_at(const Vec3d& point) const;

  /// Part of the space about `point` that is filled with water, 1 inside it and 1/2 on its surface:
  ///
  ///   f(x) = sum_j V_j B(x - x_j) B(y - y_j) B(z - z_j) / (1 - s),   B(d) = axis_spline(d / dx) / dx
  ///
  /// with V_j = m / rho0. The sum includes mirror images across the side faces of the domain (open ones too,
  /// as though the water went on unchanged) and across its floor and ceiling unless these are open. s is what
  /// layers of particles below the surface of the nearest solid would add, the first at half a spacing, the
  /// surface taken as a plane. On a lattice of particles at rest f is 1 inside, and 1/2 on a free surface
  /// half a spacing above the highest particles, exactly and up to walls, corners and faces of solids.
  [[nodiscard]] double water_fraction(const Vec3d& point) const;
  [[nodiscard]] bool is_wet(const Vec3d& point) const { return water_fraction(point) >= 0.5; }
  /// Inside an obstacle, a dam or a gate, not on its surface.
  [[nodiscard]] bool is_in_solid(const Vec3d& point) const;
  /// Within the closed domain.
  [[nodiscard]] bool is_in_domain(const Vec3d& point) const;

  /// Pressure (Pa) on a wall at `point` (m), `normal` being a unit vector into the water; nothing where the
  /// wall is dry (water_fraction below 1/2). Moving least squares: the linear function that fits the
  /// particles in front of the wall within 2 h best, weighted by the cubic spline, so a linear field comes
  /// out exactly, in corners too. It is level in directions in which the particles have no spread (across a
  /// single layer); where it is farther from their weighted mean than they are from each other, that mean
  /// (Shepard) is taken instead. Not negative unless pressures of particles are.
  [[nodiscard]] std::optional<double> wall_pressure(const Vec3d& point, const Vec3d& normal) const;

 private:
  [[nodiscard]] double distance_to_solids(const Vec3d& point) const;

  const Scene* scene_;
  const Snapshot* snapshot_;
  std::vector<StandingSolid> solids_;
  FluidCells cells_;
};

}  // namespace eisph
