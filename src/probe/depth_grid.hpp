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
/// HighestParticle (thesis): the height above the floor (domain_min.z) of the centre of the highest fluid
/// particle in the cell, zero without one; a full cell reads about half a particle spacing less than the free
/// surface.
///
/// Surface: the level of the water about the centre of the cell, see SurfaceDepth.
///
/// With scene.output.ignore_spray, particles that are spray (SprayRule) do not count by either rule; without
/// it, as in the thesis, a lone drop in the air counts as depth, by HighestParticle up to its own height. The
/// columns of a depth-averaged model know no spray.
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
  void fill_with_highest(const Snapshot& snapshot, const SprayRule* spray, DepthGrid& grid) const;

  Scene scene_;
  DepthGrid empty_;  ///< all dry, at t = 0
  Vec3d lower_;
  Vec3d upper_;
  bool one_row_ = false;
  std::optional<SurfaceDepth> surface_;  ///< with the rule Surface
};

}  // namespace eisph
