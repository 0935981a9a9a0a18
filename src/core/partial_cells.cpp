#include "core/partial_cells.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

/// Sub-cells per direction by which the water in a divided cell is measured.
constexpr int kParts = 6;
/// Fraction of the spacing within which a centre counts as on a surface.
constexpr double kTolerance = 1e-9;
/// Particles of divided cells start at least this far from the surface, in spacings.
constexpr double kClearance = 0.25;

}  // namespace

PartialCells::PartialCells(const Scene& scene, const FluidFit& fit)
    : scene_(scene), loose_(fit.loose), loose_cuts_(fit.loose_cuts) {
  for (std::size_t r = 0; r < scene.fluid.size(); ++r) {
    const Shape& shape = scene.fluid[r].shape;
    if (shape.kind != ShapeKind::Box || shape.rotation_z != 0.0) continue;
    (scene.fluid[r].cut ? box_cuts_ : boxes_).push_back(r);
  }
  for (const Obstacle& obstacle : scene.obstacles) solids_.push_back(obstacle.shape);
  for (const Gate& gate : scene.gates) solids_.push_back(gate.shape);
}

double PartialCells::distance(std::size_t region, const Vec3d& point) const {
  return scene_.fluid[region].shape.signed_distance(point, scene_.dimension);
}

bool PartialCells::in_any(const std::vector<std::size_t>& regions, const Vec3d& point) const {
  return std::any_of(regions.begin(), regions.end(), [&](std::size_t r) {
    return distance(r, point) <= kTolerance * scene_.particle_spacing;
  });
}

bool PartialCells::near_solid(const Vec3d& point) const {
  return std::any_of(solids_.begin(), solids_.end(), [&](const Shape& solid) {
    return solid.signed_distance(point, scene_.dimension) < scene_.particle_spacing;
  });
}

bool PartialCells::in_domain(const Vec3d& point) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (scene_.dimension == 2 && axis == 1) continue;
    if (point[axis] <= scene_.domain_min[axis] || point[axis] >= scene_.domain_max[axis]) return false;
  }
  return true;
}

template <class Wet>
PartialCells::Share PartialCells::share(const Vec3d& centre, const Vec3d& edges, const Wet& wet) const {
  const int across = scene_.dimension == 3 ? kParts : 1;
  const auto offset = [](int k, int parts) { return (k + 0.5) / parts - 0.5; };
  Share share;
  int count = 0;
  for (int c = 0; c < kParts; ++c) {
    for (int b = 0; b < across; ++b) {
      for (int a = 0; a < kParts; ++a) {
        const Vec3d at =
            centre + edges.cwiseProduct(Vec3d(offset(a, kParts), offset(b, across), offset(c, kParts)));
        if (!wet(at)) continue;
        ++count;
        share.middle += at;
      }
    }
  }
  if (count == 0) return share;
  share.part = static_cast<double>(count) / (kParts * across * kParts);
  share.middle /= static_cast<double>(count);
  return share;
}

template <class Wet>
std::optional<Vec3d> PartialCells::diffuse(const Vec3d& centre, const Vec3d& edges, const Wet& wet) {
  const Share water = share(centre, edges, wet);
  if (water.part == 1.0) return centre;
  if (water.part == 0.0) return std::nullopt;
  carry_ += water.part;
  if (carry_ < 1.0) return std::nullopt;
  const double clearance = kClearance * scene_.particle_spacing;
  const auto is_clear = [&](const Vec3d& point) {
    return wet(point) && std::all_of(loose_cuts_.begin(), loose_cuts_.end(),
                                     [&](std::size_t r) { return distance(r, point) >= clearance; });
  };
  for (const Vec3d& place : {centre, water.middle}) {
    if (!is_clear(place) && !(place == water.middle && wet(place))) continue;
    carry_ -= 1.0;
    return place;
  }
  return std::nullopt;  // a later cell takes its part
}

std::optional<Vec3d> PartialCells::in_piece(const Vec3d& centre, const Vec3d& edges) {
  if (loose_cuts_.empty()) return centre;
  const double reach = 0.5 * edges.norm();
  bool divided = false;
  for (const std::size_t r : loose_cuts_) {
    const double depth = distance(r, centre);
    if (depth < -reach) return std::nullopt;
    divided = divided || depth < reach;
  }
  if (!divided) return centre;
  const auto wet = [&](const Vec3d& point) { return !in_any(loose_cuts_, point); };
  if (near_solid(centre)) return diffuse(centre, edges, wet);
  return wet(centre) ? std::optional(centre) : std::nullopt;
}

std::optional<Vec3d> PartialCells::in_region(std::size_t region, const Vec3d& centre, const Vec3d& edges) {
  const double reach = 0.5 * edges.norm();
  if (distance(region, centre) > reach) return std::nullopt;
  const auto wet = [&](const Vec3d& point) {
    if (distance(region, point) > kTolerance * scene_.particle_spacing || !in_domain(point)) return false;
    if (in_any(loose_cuts_, point) || in_any(box_cuts_, point) || in_any(boxes_, point)) return false;
    return std::none_of(loose_.begin(), loose_.end(), [&](std::size_t other) {
      return other < region && distance(other, point) <= kTolerance * scene_.particle_spacing;
    });
  };
  if (near_solid(centre)) return diffuse(centre, edges, wet);
  return wet(centre) ? std::optional(centre) : std::nullopt;
}

}  // namespace eisph
