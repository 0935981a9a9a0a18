#include "probe/spray.hpp"

#include <algorithm>

namespace eisph {

SprayRule::SprayRule(const Scene& scene, double time)
    : dimension_(scene.dimension),
      spacing_(scene.particle_spacing),
      floor_(scene.domain_min.z()),
      solids_(standing_solids(scene, time)) {}

bool SprayRule::is_in_air(const Vec3d& position) const {
  if (position.z() - floor_ < spacing_) return false;
  const Vec3d below = position - Vec3d(0.0, 0.0, spacing_);
  return std::none_of(solids_.begin(), solids_.end(), [&](const StandingSolid& solid) {
    return solid.shape.signed_distance(below, dimension_) < 0.0;
  });
}

}  // namespace eisph
