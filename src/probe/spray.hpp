#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "probe/fluid_field.hpp"

#include <cstddef>
#include <vector>

namespace eisph {

/// Least normalised number density of a particle that is part of the bulk. By particle spacings, over the
/// cubic spline at h = 1.1 and 1.32 dx and Wendland's C2 at 1.2, 1.32 and 1.5 dx:
///
///                                                          2D            3D
///   lone particle                                          0.25 to 0.38  0.12 to 0.24
///   lone particle on a floor that mirrors it               0.36 to 0.50  0.18 to 0.32
///   sheet of one layer in the air, of two                  0.50 to 0.62, 0.73 to 0.81 in both
///   layer of one particle on the floor, its tip            0.73 to 0.82, 0.54 to 0.67 in both
///   the same, particles 1.25 dx apart                      0.59 to 0.66  0.47 to 0.53
///   the same, particles 1.5 dx apart                       0.49 to 0.56  0.33 to 0.39
///   flat free surface of deep water, its straight edge     0.75 to 0.82, 0.54 to 0.67 in both
inline constexpr double kBulkNumberDensity = 0.5;

/// Tells spray from water: spray is a particle whose number density is below kBulkNumberDensity and that is
/// in the air, with its centre a particle spacing dx or more above the floor of the domain and above the tops
/// of the solids that stand at the time. What lies on the ground is water, however thin a film has spread:
/// films of less than a layer (above) have the number density of drops, and a particle on the ground cannot
/// raise the depth by more than dx, about what its volume makes in a cell of 1.5 dx. One in the air raises it
/// to its own height.
class SprayRule {
 public:
  /// `time` (s) says where gates are.
  SprayRule(const Scene& scene, double time);

  /// Whether particle k of a snapshot is spray.
  [[nodiscard]] bool is_spray(const Snapshot& snapshot, std::size_t k) const {
    return snapshot.number_density[k] < kBulkNumberDensity && is_in_air(snapshot.position[k].cast<double>());
  }

 private:
  [[nodiscard]] bool is_in_air(const Vec3d& position) const;

  int dimension_;
  double spacing_;  ///< m
  double floor_;    ///< m
  std::vector<StandingSolid> solids_;
};

}  // namespace eisph
