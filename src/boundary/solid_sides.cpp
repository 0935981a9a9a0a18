#include "boundary/solid_sides.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace eisph {

namespace {

/// How far before a face there must be room for water, in particle spacings: less than half of one, where the
/// first water lies.
constexpr double kRoom = 0.3;
/// Depths that differ by less than this part of the spacing are equal.
constexpr double kTolerance = 1e-3;
/// Cosine of the angle between normals from which on faces are opposite ones.
constexpr double kOpposite = -0.5;

/// Unit vector of the horizontal (`flat`: in x and z) offset from an axis or a centre; x on it.
Vec3d radial_direction(const Vec3d& offset) {
  const double length = offset.norm();
  return length > 1e-12 ? Vec3d(offset / length) : Vec3d::UnitX();
}

}  // namespace

SolidSides::SolidSides(const Scene& scene)
    : dimension_(scene.dimension),
      spacing_(scene.particle_spacing),
      reach_(scene.support_radius() - kRoom * scene.particle_spacing),
      domain_min_(scene.domain_min),
      domain_max_(scene.domain_max) {}

/// All faces of a shape as a point in it sees them: a round one has its nearest and its farthest point.
std::vector<SolidSides::Face> SolidSides::faces(const Shape& shape, const Vec3d& point) const {
  std::vector<Face> found;
  const auto add_round = [&](const Vec3d& offset) {
    const Vec3d outward = radial_direction(offset);
    found.push_back({outward, shape.radius - offset.norm()});
    found.push_back({-outward, shape.radius + offset.norm()});
  };
  const auto add_pair = [&](const Vec3d& axis, double along, double half) {
    for (const double side : {-1.0, 1.0}) found.push_back({side * axis, half - side * along});
  };
  switch (shape.kind) {
    case ShapeKind::Sphere: {
      Vec3d offset = point - shape.centre;
      if (dimension_ == 2) offset.y() = 0.0;
      add_round(offset);
      return found;
    }
    case ShapeKind::Cylinder: {
      const Vec3d offset = point - shape.centre;
      add_round(Vec3d(offset.x(), offset.y(), 0.0));
      add_pair(Vec3d::UnitZ(), offset.z() - 0.5 * shape.height, 0.5 * shape.height);
      return found;
    }
    case ShapeKind::Box:
      break;
  }
  const double c = std::cos(shape.rotation_z);
  const double s = std::sin(shape.rotation_z);
  const Vec3d axes[3] = {Vec3d(c, s, 0.0), Vec3d(-s, c, 0.0), Vec3d::UnitZ()};
  const Vec3d half = 0.5 * (shape.max - shape.min);
  const Vec3d offset = point - 0.5 * (shape.min + shape.max);
  for (int a = 0; a < 3; ++a) {
    if (dimension_ == 2 && a == 1) continue;
    add_pair(axes[a], offset.dot(axes[a]), half[a]);
  }
  return found;
}

Vec3d SolidSides::before(const Vec3d& point, const Face& face) const {
  return point + (face.depth + kRoom * spacing_) * face.normal;
}

bool SolidSides::in_domain(const Vec3d& point) const {
  for (const int axis : {0, 1, 2}) {
    if (dimension_ == 2 && axis == 1) continue;
    if (point[axis] < domain_min_[axis] || point[axis] > domain_max_[axis]) return false;
  }
  return true;
}

bool SolidSides::is_free(std::size_t own, const Vec3d& point, const Face& face) const {
  const Vec3d room = before(point, face);
  if (!in_domain(room)) return false;
  for (std::size_t s = 0; s < shapes_.size(); ++s) {
    if (s != own && shapes_[s] && shapes_[s]->contains(room, dimension_)) return false;
  }
  return true;
}

bool SolidSides::may_touch(std::size_t own, const Vec3d& point, const Vec3d& lower,
                           const Vec3d& upper) const {
  const std::vector<Face> all = faces(*shapes_[own], point);
  return std::any_of(all.begin(), all.end(), [&](const Face& face) {
    const Vec3d room = before(point, face);
    for (const int axis : {0, 1, 2}) {
      if (dimension_ == 2 && axis == 1) continue;
      if (room[axis] < lower[axis] || room[axis] > upper[axis]) return false;
    }
    return true;
  });
}

Vec3d SolidSides::nearest_normal(const std::vector<Face>& faces, const Vec3d& hidden) const {
  double nearest = std::numeric_limits<double>::max();
  const auto counts = [&](const Face& face) { return face.normal.dot(hidden) >= kOpposite; };
  for (const Face& face : faces) {
    if (counts(face)) nearest = std::min(nearest, face.depth);
  }
  Vec3d sum = Vec3d::Zero();
  for (const Face& face : faces) {
    if (counts(face) && face.depth < nearest + kTolerance * spacing_) sum += face.normal;
  }
  const double length = sum.norm();
  return length > kTolerance ? Vec3d(sum / length) : Vec3d::Zero();
}

std::vector<SolidSide> SolidSides::of(std::size_t own, const Vec3d& point) const {
  std::vector<Face> all = faces(*shapes_[own], point);
  std::vector<Face> free;
  std::copy_if(all.begin(), all.end(), std::back_inserter(free),
               [&](const Face& face) { return is_free(own, point, face); });
  if (free.empty()) {
    // Built in on all sides; what water is in reach stands before a neighbour that continues one of them.
    std::erase_if(all, [&](const Face& face) { return !in_domain(before(point, face)); });
    return {{nearest_normal(all, Vec3d::Zero()), Vec3d::Zero(), 0.0}};
  }
  // The thinnest way through between two faces that water can touch.
  const Face* first = nullptr;
  const Face* second = nullptr;
  double thinnest = std::numeric_limits<double>::max();
  for (const Face& a : free) {
    for (const Face& b : free) {
      if (a.normal.dot(b.normal) >= kOpposite || a.depth > b.depth || b.depth >= reach_) continue;
      if (a.depth + b.depth >= thinnest - kTolerance * spacing_) continue;
      thinnest = a.depth + b.depth;
      first = &a;
      second = &b;
    }
  }
  if (first == nullptr) return {{nearest_normal(free, Vec3d::Zero()), Vec3d::Zero(), 0.0}};
  const Vec3d across = first->normal;
  const double middle = 0.5 * (first->depth - second->depth);
  return {{nearest_normal(free, across), across, middle}, {nearest_normal(free, -across), -across, -middle}};
}

}  // namespace eisph
