#pragma once

#include "core/kernel.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "probe/fluid_field.hpp"

#include <cstddef>
#include <vector>

namespace eisph {

/// Normalised number density below which a particle in the air is spray:
///
///   n_s = 0.87 n_e,   n_e = sum over i <= 0, k <= 0 of W(|x_ijk|) / sum over all i, j, k of W(|x_ijk|)
///
/// with x_ijk on a lattice of spacing dx (i and k in 2D): n_e is the number density at the straight edge of
/// water with two plane surfaces at a right angle, the sharpest form that water keeps. The factor makes 0.50
/// (2D) and 0.51 (3D) of it with the cubic spline at h = 1.32 dx. By particle spacings, 2D / 3D:
///
///                                            cubic 1.32   Wendland C2     quintic
///                                                         1.32 / 1.2      1.4 / 1.2
///   lone particle                            0.26 / 0.14  0.32 / 0.24     0.35 / 0.34
///   the same on a floor that mirrors it      0.38 / 0.20  0.44 / 0.31     0.47 / 0.42
///   two particles 0.7 dx apart               0.44 / 0.23  0.51 / 0.37     0.56 / 0.51
///   n_s                                      0.50 / 0.51  0.53 / 0.58     0.56 / 0.63
///   sheet of one layer in the air            0.52 / 0.53  0.56 / 0.63     0.60 / 0.71
///   sheet of two layers, its edge            0.75, 0.57   0.78, 0.61      0.80, 0.64 in 2D
///                                            0.76, 0.58   0.81, 0.66      0.86, 0.73 in 3D
///   layer of one particle on a floor, its tip: as the sheet of two layers
///   the same, particles 1.25 dx apart        0.60 / 0.49  0.63 / 0.53     0.64 / 0.57
///   the same, particles 1.5 dx apart         0.50 / 0.34  0.53 / 0.39     0.54 / 0.46
[[nodiscard]] double spray_number_density(KernelKind kernel, double smoothing_ratio, int dimension);

/// Tells spray from water: spray is a particle whose number density is below spray_number_density and that is
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
    return snapshot.number_density[k] < threshold_ && is_in_air(snapshot.position[k].cast<double>());
  }

 private:
  [[nodiscard]] bool is_in_air(const Vec3d& position) const;

  int dimension_;
  double threshold_;
  double spacing_;  ///< m
  double floor_;    ///< m
  std::vector<StandingSolid> solids_;
};

}  // namespace eisph
