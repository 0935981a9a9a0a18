#include "core/fluid_fit.hpp"
#include "io/scene_check.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace eisph {

namespace {

/// Lengths, over the particle spacing.
constexpr double kTolerance = 1e-6;

/// A shape's extent, m, and the key that sets it.
struct Extent {
  double length = 0.0;
  const char* key = "";
  int axis = -1;  ///< -1: no single one
};

std::vector<Extent> extents(const Scene& scene, const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::Sphere:
      return {{2.0 * shape.radius, ".radius", -1}};
    case ShapeKind::Cylinder:
      return {{2.0 * shape.radius, ".radius", -1}, {shape.height, ".height", 2}};
    case ShapeKind::Box:
      break;
  }
  std::vector<Extent> found;
  for (const int axis : scene_axes(scene)) {
    const bool upright = shape.rotation_z == 0.0;
    const double lower = upright ? std::max(shape.min[axis], scene.domain_min[axis]) : shape.min[axis];
    const double upper = upright ? std::min(shape.max[axis], scene.domain_max[axis]) : shape.max[axis];
    found.push_back({upper - lower, ".max", axis});
  }
  return found;
}

/// Whether other regions continue a box, so that the water in it is thicker along `axis` than itself.
bool is_continued(const Scene& scene, const FluidFit& fit, const Shape& box, int axis) {
  if (box.kind != ShapeKind::Box || box.rotation_z != 0.0) return false;
  const double least = (1.0 - kTolerance) * scene.particle_spacing;
  const auto overlaps = [&](const FluidPiece& piece) {
    const std::vector<int> axes = scene_axes(scene);
    return std::all_of(axes.begin(), axes.end(),
                       [&](int a) { return piece.lower[a] < box.max[a] && piece.upper[a] > box.min[a]; });
  };
  const auto is_thin = [&](const FluidPiece& piece) {
    return overlaps(piece) && piece.upper[axis] - piece.lower[axis] < least;
  };
  if (std::any_of(fit.thin.begin(), fit.thin.end(), is_thin)) return false;
  if (std::any_of(fit.pieces.begin(), fit.pieces.end(), is_thin)) return false;
  return std::any_of(fit.pieces.begin(), fit.pieces.end(), overlaps);
}

}  // namespace

void check_thickness(const Scene& scene, const TomlSource& source) {
  if (scene.scheme.name == "shallow_water") return;
  const FluidFit fit = fit_fluid(scene);
  for (std::size_t k = 0; k < scene.fluid.size(); ++k) {
    const Shape& shape = scene.fluid[k].shape;
    if (scene.fluid[k].cut) continue;
    for (const Extent& extent : extents(scene, shape)) {
      if (extent.length >= (1.0 - kTolerance) * scene.particle_spacing) continue;
      if (extent.axis >= 0 && is_continued(scene, fit, shape, extent.axis)) continue;
      const std::string along = extent.axis < 0 ? "" : fmt::format(" in {}", "xyz"[extent.axis]);
      source.fail(
          fmt::format("fluid.region.{}{}", k, extent.key),
          fmt::format("the water is {:.6g} m thick{}, less than a layer of particles; expected at least "
                      "particles.spacing = {:.6g} m, or a smaller spacing",
                      extent.length, along, scene.particle_spacing));
    }
  }
}

}  // namespace eisph
