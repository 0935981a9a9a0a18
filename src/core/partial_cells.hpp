#pragma once

#include "core/fluid_fit.hpp"
#include "core/scene.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace eisph {

/// Which cells of the water's lattices hold a particle, and where, in a scene with round or rotated regions.
/// Cells that the surface divides beside a solid are kept by error diffusion: as many as their parts add up
/// to, spread evenly along the walk. To be asked once for every cell, in the order of the walk.
class PartialCells {
 public:
  PartialCells(const Scene& scene, const FluidFit& fit);

  /// Place of the particle of a piece's cell with this centre and these edges (m), if it has one.
  [[nodiscard]] std::optional<Vec3d> in_piece(const Vec3d& centre, const Vec3d& edges);
  /// The same of a cell of the lattice of loose region `region`.
  [[nodiscard]] std::optional<Vec3d> in_region(std::size_t region, const Vec3d& centre, const Vec3d& edges);

 private:
  /// The part of a cell that is water, and the middle of that part.
  struct Share {
    double part = 0.0;
    Vec3d middle = Vec3d::Zero();
  };

  template <class Wet>
  [[nodiscard]] Share share(const Vec3d& centre, const Vec3d& edges, const Wet& wet) const;
  template <class Wet>
  [[nodiscard]] std::optional<Vec3d> diffuse(const Vec3d& centre, const Vec3d& edges, const Wet& wet);
  [[nodiscard]] double distance(std::size_t region, const Vec3d& point) const;
  [[nodiscard]] bool in_any(const std::vector<std::size_t>& regions, const Vec3d& point) const;
  [[nodiscard]] bool near_solid(const Vec3d& point) const;
  [[nodiscard]] bool in_domain(const Vec3d& point) const;

  const Scene& scene_;
  std::vector<std::size_t> loose_;
  std::vector<std::size_t> loose_cuts_;
  std::vector<std::size_t> boxes_;
  std::vector<std::size_t> box_cuts_;
  std::vector<Shape> solids_;
  double carry_ = 0.5;  ///< parts of cells that no particle stands for yet
};

}  // namespace eisph
