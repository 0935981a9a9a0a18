#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boundary/mirror_planes.hpp"

namespace eisph {

/// Repulsion of the virtual particles (thesis (3.40), (3.41) as corrected): a lattice of spacing dx/2 on each
/// wall pushes a fluid particle nearer than r0 = 0.4 dx by
///   a = c^2 [(r0/r)^4 - (r0/r)^2] x_ij / r^2,  c^2 = 2 g H,
/// summed and then capped at repulsion_cap 2 g H / dx, so that the push moves a particle by the same fraction
/// of dx per step at every scale. The lattice is evaluated where it is needed and never stored. It continues
/// beyond the edges of the tank and starts from the symmetry planes where there are any, so that a half domain
/// sees the lattice of the full one.
template <int Dim>
class VirtualParticles {
 public:
  VirtualParticles() = default;
  explicit VirtualParticles(const Scene& scene);

  [[nodiscard]] bool empty() const { return walls_.empty(); }
  /// Adds the acceleration, m/s^2, at `position`, m from the domain's lower corner.
  void add_acceleration(const std::array<double, Dim>& position, std::array<double, Dim>& acceleration) const;
  /// Number of lattice points on the walls.
  [[nodiscard]] std::uint64_t count() const;

 private:
  struct Wall {
    int axis;
    double position;
    double inward;  ///< +1 at a lower face, -1 at an upper one
  };

  void add_wall(const Wall& wall, const std::array<double, Dim>& position,
                std::array<double, Dim>& acceleration) const;
  void add_node(const std::array<double, Dim>& offset, std::array<double, Dim>& acceleration) const;

  std::vector<Wall> walls_;
  std::array<double, Dim> extent_{};
  std::array<double, Dim> origin_{};  ///< of the lattice along each axis
  double spacing_ = 0.0;
  double cutoff_ = 0.0;
  double strength_ = 0.0;
  double cap_ = 0.0;
};

}  // namespace eisph
