#pragma once

#include "core/scene.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace eisph {

/// From where water sees a solid particle, and which way the surface between them faces.
struct SolidSide {
  Vec3d normal = Vec3d::Zero();  ///< outward, of the nearest face that water can touch; zero: there is none
  Vec3d across = Vec3d::Zero();  ///< unit vector through a thin solid; zero: water all around sees the side
  double middle = 0.0;           ///< m; the side is seen from where across . (x - x_particle) > middle
};

/// Sides of the particles of the solids of a scene. A particle stands for the surface nearest to it, as the
/// wall that mirrors the water before it; faces that touch a wall of the tank or another solid do not count,
/// and equally near ones count with their mean. Where a solid is so thin that water on both sides is within a
/// support radius of a particle, it has two sides, each seen by the water before it alone: what one of them
/// carries never acts through the solid.
class SolidSides {
 public:
  SolidSides() = default;
  explicit SolidSides(const Scene& scene);

  /// All solids where they stand (gates raised), in an order of the caller's; nothing for one that is gone.
  void place(std::vector<std::optional<Shape>> shapes) { shapes_ = std::move(shapes); }
  /// One or two sides of a particle of solid `own` at `point` (m).
  [[nodiscard]] std::vector<SolidSide> of(std::size_t own, const Vec3d& point) const;
  /// Whether a face of solid `own` as that particle sees it may touch what is in a box.
  [[nodiscard]] bool may_touch(std::size_t own, const Vec3d& point, const Vec3d& lower,
                               const Vec3d& upper) const;

 private:
  struct Face {
    Vec3d normal;
    double depth;  ///< m, of the particle below it
  };

  [[nodiscard]] std::vector<Face> faces(const Shape& shape, const Vec3d& point) const;
  /// The place before a face where there must be room for water.
  [[nodiscard]] Vec3d before(const Vec3d& point, const Face& face) const;
  [[nodiscard]] bool in_domain(const Vec3d& point) const;
  /// Whether water can be in front of a face of solid `own`.
  [[nodiscard]] bool is_free(std::size_t own, const Vec3d& point, const Face& face) const;
  /// Mean of the normals of the nearest faces, those that face against `hidden` left out.
  [[nodiscard]] Vec3d nearest_normal(const std::vector<Face>& faces, const Vec3d& hidden) const;

  int dimension_ = 3;
  double spacing_ = 0.0;  ///< m, of the fluid
  double reach_ = 0.0;    ///< m, depth to which water is in reach
  Vec3d domain_min_ = Vec3d::Zero();
  Vec3d domain_max_ = Vec3d::Zero();
  std::vector<std::optional<Shape>> shapes_;
};

}  // namespace eisph
