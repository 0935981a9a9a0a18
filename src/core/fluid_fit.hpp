#pragma once

#include "core/scene.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace eisph {

/// A box of water with one lattice in it, half a layer from each of its faces and stretched by direction.
struct FluidPiece {
  Vec3d lower = Vec3d::Zero();  ///< m
  Vec3d upper = Vec3d::Zero();  ///< m
  std::array<double, 3> layers{1.0, 1.0,
                               1.0};  ///< per direction; doubles, as a bad scene may ask for any number
  std::size_t region = 0;             ///< the last added one that reaches into it

  /// Distance of two layers, m.
  [[nodiscard]] double spacing(int axis) const {
    return (upper[axis] - lower[axis]) / layers[static_cast<std::size_t>(axis)];
  }
};

/// How the water of a scene is divided into pieces of one lattice each.
struct FluidFit {
  /// Every region is an upright box that begins and ends on the lattice domain_min + i dx: then that lattice,
  /// unstretched, is the water's, and there are no pieces.
  bool aligned = false;
  std::vector<FluidPiece>
      pieces;                    ///< of the upright boxes, less the upright ones cut out; they do not overlap
  std::vector<FluidPiece> thin;  ///< thinner than half a spacing: hold no particles
  std::vector<std::size_t> loose;       ///< the other added regions: round or rotated
  std::vector<std::size_t> loose_cuts;  ///< round or rotated regions that are cut out
  double cell_volume = 0.0;  ///< of the pieces, volume over layers, m^3 (m^2 in 2D); without pieces dx^D
  double misfit = 0.0;       ///< largest difference of the cell volume of a piece from it, over it
};

/// The axis along which a piece is thinner than a particle spacing, the thinnest of them; -1 if there is
/// none.
[[nodiscard]] int thin_axis(const Scene& scene, const FluidPiece& piece);

/// m^3 (m^2 in 2D).
[[nodiscard]] double piece_volume(const Scene& scene, const FluidPiece& piece);

/// The pieces that the boxes of a scene make. Of the ways to divide the water and to number the layers, that
/// one whose cells differ least from each other in volume, from cubes in shape and from dx^D in volume.
[[nodiscard]] FluidFit fit_fluid(const Scene& scene);

}  // namespace eisph
