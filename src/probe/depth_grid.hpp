#pragma once

#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "probe/surface_depth.hpp"

#include <cstddef>
#include <optional>

namespace eisph {

/// Water depth on square cells over the floor of a scene's domain, by scene.output.depth_rule:
///
/// HighestParticle: the height above the floor (domain_min.z) of the centre of the highest fluid particle in
/// the cell, zero without one; a full cell reads about half a particle spacing less than the free surface.
/// With scene.output.ignore_spray the highest that is no spray (SprayRule); without it, as in the thesis, a
/// lone drop in the air counts as depth up to its own height.
///
/// Surface: the level of the water about the centre of the cell, see SurfaceDepth. Spray counts by its
/// volume: it is water that the cells would lack without it.
///
/// The cells start at domain_min and cover the whole domain: where its length is no multiple of the cell
/// size, the last column or row reaches beyond the wall and holds fewer particles. Particles outside the
/// domain are left out; those on its upper faces belong to the last cell. A two-dimensional scene has one
/// row, centred on its plane y = 0.
class DepthGridBuilder {
 public:
  /// Cells of scene.output.depth_cell_size, 1.5 particle spacings if that is zero. Throws InputError if the
  /// cell size is of no use.
  explicit DepthGridBuilder(const Scene& scene);

  [[nodiscard]] DepthGrid build(const Snapshot& snapshot) const;

 private:
  void fill_with_highest(const Snapshot& snapshot, DepthGrid& grid) const;

  Scene scene_;
  DepthGrid empty_;  ///< all dry, at t = 0
  Vec3d lower_;
  Vec3d upper_;
  bool one_row_ = false;
  std::optional<SurfaceDepth> surface_;  ///< with the rule Surface
};

}  // namespace eisph
