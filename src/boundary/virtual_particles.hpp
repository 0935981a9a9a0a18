#pragma once

#include "boundary/mirror_planes.hpp"
#include "core/repulsion.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace eisph {

/// Repulsion of the virtual particles on the walls of the tank. The thesis has a lattice of spacing dx/2 on
/// each wall (3.41), every point of which pushes along the line to it. At the cutoff of 0.4 dx only two to
/// four points act at a time: the wall is rough (in a thin layer it brakes like friction), and a particle
/// pressed against it between four points is held there and can pass. The even form, the default, spreads the
/// same law over the wall: it acts by the distance to the wall, along its normal. Neither is ever stored.
///
/// The lattice continues beyond the edges of the tank and starts from the symmetry planes where there are
/// any, so that a half domain sees the lattice of the full one.
template <int Dim>
class VirtualParticles {
 public:
  VirtualParticles() = default;
  explicit VirtualParticles(const Scene& scene);

  [[nodiscard]] bool empty() const { return walls_.empty(); }
  /// Adds the acceleration, m/s^2, at `position`, m from the domain's lower corner.
  void add_acceleration(const std::array<double, Dim>& position, std::array<double, Dim>& acceleration) const;
  /// The points of the lattice on the walls, m from the domain's lower corner, whatever the form.
  [[nodiscard]] std::vector<std::array<double, Dim>> lattice_points() const;
  /// Number of lattice points on the walls; none with the even form.
  [[nodiscard]] std::uint64_t count() const;

 private:
  struct Wall {
    int axis;
    double position;
    double inward;  ///< +1 at a lower face, -1 at an upper one
  };

  void add_lattice(const Wall& wall, const std::array<double, Dim>& position,
                   std::array<double, Dim>& acceleration) const;
  void add_node(const std::array<double, Dim>& offset, std::array<double, Dim>& acceleration) const;

  std::vector<Wall> walls_;
  std::array<double, Dim> extent_{};
  std::array<double, Dim> origin_{};  ///< of the lattice along each axis
  double spacing_ = 0.0;
  Repulsion repulsion_;
  RepulsionForm form_ = RepulsionForm::Even;
};

}  // namespace eisph
