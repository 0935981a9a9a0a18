#include "core/scene_mirror.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace eisph {

namespace {

constexpr double kTouches = 1e-9;  ///< m, how near a face has to be to the plane to lie on it

Shape mirrored(Shape shape, double plane) {
  if (shape.kind == ShapeKind::Box) {
    const double lower = 2.0 * plane - shape.max.y();
    shape.max.y() = 2.0 * plane - shape.min.y();
    shape.min.y() = lower;
    shape.rotation_z = -shape.rotation_z;
  } else {
    shape.centre.y() = 2.0 * plane - shape.centre.y();
  }
  return shape;
}

/// Adds the mirror image of a solid; a box that ends on the plane, or reaches across it, grows together with
/// its image.
template <class Solid>
void complete(std::vector<Solid>& solids, double plane) {
  std::vector<Solid> images;
  for (Solid& solid : solids) {
    Solid image = solid;
    image.shape = mirrored(solid.shape, plane);
    const bool meets = solid.shape.kind == ShapeKind::Box && solid.shape.rotation_z == 0.0 &&
                       solid.shape.min.y() <= plane + kTouches && solid.shape.max.y() >= plane - kTouches;
    if (meets) {
      solid.shape.min.y() = std::min(solid.shape.min.y(), image.shape.min.y());
      solid.shape.max.y() = std::max(solid.shape.max.y(), image.shape.max.y());
    } else {
      images.push_back(std::move(image));
    }
  }
  solids.insert(solids.end(), images.begin(), images.end());
}

}  // namespace

std::optional<double> symmetry_plane_y(const Scene& scene) {
  if (scene.dimension == 2) return std::nullopt;
  if (scene.faces[kYMax].kind == FaceKind::Symmetry) return scene.domain_max.y();
  if (scene.faces[kYMin].kind == FaceKind::Symmetry) return scene.domain_min.y();
  return std::nullopt;
}

Scene completed_by_symmetry(const Scene& scene) {
  const std::optional<double> plane = symmetry_plane_y(scene);
  if (!plane) return scene;
  Scene whole = scene;
  if (scene.faces[kYMax].kind == FaceKind::Symmetry) {
    whole.domain_max.y() = 2.0 * *plane - scene.domain_min.y();
    whole.faces[kYMax] = scene.faces[kYMin];
  } else {
    whole.domain_min.y() = 2.0 * *plane - scene.domain_max.y();
    whole.faces[kYMin] = scene.faces[kYMax];
  }
  complete(whole.obstacles, *plane);
  complete(whole.gates, *plane);
  return whole;
}

}  // namespace eisph
