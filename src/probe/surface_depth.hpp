#pragma once

#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eisph {

/// Level of the water, metres above the floor, on the cells of a depth grid: the rule "surface". The volume
/// of water over a unit of floor about the centre of a cell,
///
///   v(x, y) = sum_j V_j B(x - x_j) B(y - y_j),   B(d) = axis_spline(d / dx) / dx   (in 2D: in x alone)
///
/// with V_j = m / rho0 and mirror images across the sides of the domain, is filled up from the floor into the
/// space that the solids about the centre leave: level L with integral from 0 to L of (1 - s(z)) dz = v, s
/// the part of the same kernel that solids take up at height z. Where the centre is above a solid only the
/// water above it counts and stands on it.
///
/// A lattice of particles at rest comes out exactly (half a spacing above the highest particles) up to walls,
/// corners and faces of solids that follow the lattice; along other faces the steps of the lattice show. With
/// all particles displaced by up to a tenth of a spacing it is good to 5 % of a depth of ten spacings. A
/// layer that thins out keeps its mean depth: there are no holes until particles are 4 spacings apart. Drops
/// count by their volume, not their height. Spheres are taken as a stack of discs.
class SurfaceDepth {
 public:
  /// `grid` tells the cells.
  SurfaceDepth(const Scene& scene, const DepthGrid& grid);

  /// Sets grid.depth.
  void fill(const Snapshot& snapshot, DepthGrid& grid) const;

 private:
  /// A solid between two heights: an upright prism.
  struct Prism {
    double bottom = 0.0;  ///< m above the floor, closed gate
    double top = 0.0;
    double foot = 0.0;     ///< bottom of the whole solid
    std::size_t gate = 0;  ///< place in Scene::gates, kNoGate for what does not move
  };
  /// What prism takes up about one cell.
  struct Share {
    std::uint32_t cell = 0;
    std::uint32_t prism = 0;
    double share = 0.0;    ///< of the kernel
    bool covered = false;  ///< the centre is inside the outline
  };
  static constexpr std::size_t kNoGate = static_cast<std::size_t>(-1);

  void add_solid(const Shape& shape, std::size_t gate, const DepthGrid& grid);
  void add_prism(const Shape& outline, const Prism& prism, const DepthGrid& grid);
  template <class Visit>
  void visit_cells(double x, double y, const DepthGrid& grid, const Visit& visit) const;
  [[nodiscard]] std::vector<Prism> standing_prisms(double time) const;
  void fill_around_solids(const std::vector<Prism>& prisms, const std::vector<double>& ground,
                          std::vector<double>& volume) const;

  int dimension_;
  double dx_;
  Vec3d lower_;
  Vec3d upper_;
  std::vector<Gate> gates_;
  std::vector<Prism> prisms_;
  std::vector<Share> shares_;  ///< by cell
};

}  // namespace eisph
