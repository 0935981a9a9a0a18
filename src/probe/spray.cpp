#include "probe/spray.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

double spray_number_density(KernelKind kind, double smoothing_ratio, int dimension) {
  constexpr double kShareOfEdge = 0.87;
  const auto reach = static_cast<int>(kKernelSupport * smoothing_ratio);
  const int across = dimension == 2 ? 0 : reach;
  return with_kernel(kind, [&](auto kernel) {
    double all = 0.0;
    double edge = 0.0;
    for (int k = -reach; k <= reach; ++k) {
      for (int j = -across; j <= across; ++j) {
        for (int i = -reach; i <= reach; ++i) {
          const double value =
              kernel.value(std::sqrt(static_cast<double>(i * i + j * j + k * k)) / smoothing_ratio);
          all += value;
          if (i <= 0 && k <= 0) edge += value;
        }
      }
    }
    return kShareOfEdge * edge / all;
  });
}

SprayRule::SprayRule(const Scene& scene, double time)
    : dimension_(scene.dimension),
      threshold_(spray_number_density(scene.kernel, scene.smoothing_ratio, scene.dimension)),
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
