#pragma once

#include "core/scene.hpp"

namespace eisph {

/// The law by which walls and solids repel (thesis (3.40) as corrected), m/s^2:
/// c^2 [(r0/r)^4 - (r0/r)^2] / r for r < r0, not more than the cap.
struct Repulsion {
  double cutoff = 0.0;    ///< r0, m
  double strength = 0.0;  ///< c^2 = repulsion_strength Umax^2, m^2/s^2
  double cap = 0.0;       ///< m/s^2; in units of Umax^2 / dx it is the same at every scale

  Repulsion() = default;
  /// Of the walls of the tank.
  explicit Repulsion(const Scene& scene);
  /// Without the cap.
  [[nodiscard]] double raw(double distance) const;
  [[nodiscard]] double capped(double distance) const;
  /// Nearest that anything counts, in units of the cutoff: what lies on a surface is still pushed inwards.
  static constexpr double kNearest = 1e-3;
};

/// Of the surfaces of solids: none at all without boundary.object_repulsion.
[[nodiscard]] Repulsion repulsion_of_solids(const Scene& scene);

/// Factor of the repulsion when the largest speed is `speed_max` (m/s): it grows with its square, as the step
/// shrinks with that speed, so that a push stays the same fraction of dx per step (thesis (3.40): c^2 is of
/// the scale of the square of the largest velocity).
[[nodiscard]] double repulsion_growth(const Scene& scene, double speed_max);

}  // namespace eisph
