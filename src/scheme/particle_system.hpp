#pragma once

#include "boundary/mirror_particles.hpp"
#include "boundary/mirror_planes.hpp"
#include "boundary/solid_particles.hpp"
#include "boundary/virtual_particles.hpp"
#include "core/lattice.hpp"
#include "core/scene.hpp"
#include "core/thread_pool.hpp"
#include "sph/lattice_constants.hpp"
#include "sph/neighbour_list.hpp"
#include "sph/source_table.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace eisph {

/// What all particle schemes share: the fluid as a structure of arrays sorted by cell, the solids, the mirror
/// images of both, the table of everything that can be a neighbour, and the neighbour lists. A scheme calls
/// sort_fluid, place_boundaries and find_neighbours once in a step, and fills the rest of the table itself.
template <int Dim>
struct ParticleSystem {
  /// Places the fluid of the scene, packed at shapes that its lattice does not follow. Throws InputError when
  /// there is none, or too much for the indices.
  ParticleSystem(const Scene& of, int threads);
  /// The same with the fluid at the given places.
  ParticleSystem(const Scene& of, int threads, const FluidLattice& sites);

  /// Sorts the fluid by cell, takes out what has left through open faces, and fills its rows of the table:
  /// positions with the carried scalar, velocities with the volume.
  void sort_fluid();
  /// The fluid's rows and those of its images anew, with the lists and the images of the last search.
  void refresh_fluid();
  /// Whether all solids stand at `time` (s) where they stood when boundaries were last placed.
  [[nodiscard]] bool solids_stand_still(double time) const;
  /// The solids as they stand at `time` (s), and the mirror images of fluid and solids.
  void place_boundaries(double time);
  void find_neighbours();
  /// All three at t = 0, the velocities in the new order as a step leaves them.
  void find_initial_neighbours();
  /// Gives the fluid and its images no vector and their volume in `table.source`, as solids have it.
  void set_source_volumes();

  /// The images' w of `table.position` from their originals.
  void mirror_pressure();
  /// The images' rows of `table.source` from those of the fluid, as vectors like the velocity.
  void mirror_source();
  /// The same of fluid and solids, as gradients.
  void mirror_source_gradients();
  /// The images' positions and velocities anew, from those of the fluid; which images there are stays.
  void mirror_motion();
  /// A pass over all neighbour lists is about to be made.
  void count_pass() { pair_evaluations += static_cast<double>(neighbours.total()); }

  /// The viscosities from those of the scene.
  void set_viscosities();
  [[nodiscard]] bool is_viscous() const { return laminar_viscosity > 0.0 || artificial_viscosity > 0.0; }
  [[nodiscard]] std::uint32_t fluid_row(std::size_t i) const {
    return static_cast<std::uint32_t>(table.first_fluid + i);
  }
  [[nodiscard]] std::uint32_t object_row(std::size_t k) const {
    return static_cast<std::uint32_t>(table.first_object + k);
  }
  [[nodiscard]] Float4* fluid_rows(AlignedBuffer<Float4>& rows) const {
    return rows.data() + table.first_fluid;
  }
  /// What a fluid particle adds to its own number density: V W(0).
  [[nodiscard]] double own_number_density() const { return alpha * volume * kernel_at_zero(scene.kernel); }
  [[nodiscard]] std::size_t objects() const { return solids.size(); }
  /// Volume of the k-th solid particle (a side of one, SolidSide) in the order of the table.
  [[nodiscard]] double object_volume(std::size_t k) const { return solids.volume(object_sort.order()[k]); }
  /// Pressure kept with it, Pa.
  float& kept_object_pressure(std::size_t k) { return solids.pressure(object_sort.order()[k]); }
  /// Outward normal of the surface that the k-th solid particle stands for; zero without one.
  [[nodiscard]] const Float4& object_normal(std::size_t k) const { return object_rows_[2][k]; }
  /// Velocity of the solid that it belongs to, m/s.
  [[nodiscard]] const Float4& object_velocity(std::size_t k) const { return object_rows_[1][k]; }
  /// The images' rows of `rows` (a column of the table) from those of the solids, as vectors like the
  /// velocity.
  void mirror_object_vectors(AlignedBuffer<Float4>& rows);
  void mirror_object_pressure();
  /// Components along the axes of the solver as a vector of the scene.
  [[nodiscard]] Vec3d scene_vector(const std::array<double, Dim>& components) const;
  /// Position of fluid particle `i`, m from the domain's lower corner.
  [[nodiscard]] std::array<double, Dim> position_of(std::size_t i) const;
  /// The same in the coordinates of the scene, m.
  [[nodiscard]] Vec3d place_of(std::size_t i) const;
  /// Height of the highest fluid particle above the floor of the domain, m.
  [[nodiscard]] double highest_particle() const;
  /// Particles that have disappeared or stand where no water can be.
  [[nodiscard]] std::uint64_t lost_particles() const;
  /// Mirror images that the fluid would have where it is.
  [[nodiscard]] std::uint64_t count_ghosts() const;
  /// Adds the sizes of the arrays, bytes.
  void add_bytes(std::map<std::string, double>& by_array) const;

  Scene scene;
  ThreadPool pool;
  LatticeConstants lattice;
  MirrorPlanes<Dim> planes;
  VirtualParticles<Dim> virtual_particles;
  SolidParticles solids;
  CellGrid<Dim> grid;

  // Constants of the run.
  double h = 0.0;                     ///< smoothing length, m
  double alpha = 0.0;                 ///< kernel normalisation, m^-Dim
  double volume = 0.0;                ///< of a fluid particle, m^3 (m^2 in 2D)
  double separation_squared = 0.0;    ///< square of kSeparationReach, h^2; 0: pairs are left alone
  double laminar_viscosity = 0.0;     ///< of the fluid, m^2/s
  double morris_part = 0.0;           ///< of it in the form of Morris (ViscousTerms)
  double artificial_viscosity = 0.0;  ///< as a kinematic one, m^2/s
  std::array<double, Dim> gravity{};
  std::array<double, Dim> extent{};
  std::uint32_t initial_fluid = 0;

  // State of the fluid, in the order of the last sort.
  std::uint32_t fluid = 0;
  std::array<AlignedBuffer<double>, Dim> position;  ///< m from the domain's lower corner
  std::array<AlignedBuffer<float>, Dim> velocity;   ///< m/s
  AlignedBuffer<float>
      carried;  ///< a scalar of the scheme; a sort moves it into the w of the table's positions
  AlignedBuffer<std::uint32_t> id;
  double speed_max = 0.0;  ///< m/s, at the end of the last step

  // What a step leaves for the output.
  AlignedBuffer<float> pressure;        ///< Pa
  AlignedBuffer<float> number_density;  ///< normalised by the lattice's

  std::uint64_t outflow = 0;              ///< particles taken out so far
  std::uint64_t ghost_particles_max = 0;  ///< most images held at once
  double pair_evaluations = 0.0;          ///< entries of neighbour lists read so far

  // Work space of a step.
  CellSort fluid_sort;
  MirrorParticles<Dim> fluid_images;
  CellSort object_sort;
  MirrorParticles<Dim> object_images;
  SourceTable table;
  NeighbourList<Dim> neighbours;

 private:
  void place_particles(const FluidLattice& sites);
  void fill_objects();
  void set_object_sources();
  void hide_far_sides();
  void hide_wall_images();

  double placed_at_ = 0.0;  ///< s, time of the boundaries
  /// Of objects in the order of object_sort: positions, velocities, normals, and of thin ones `across` with
  /// `middle` as w (SolidSide, in smoothing lengths).
  std::vector<Float4> object_rows_[4];
  AlignedBuffer<Float4> across_;  ///< the last of these by row of the table, images as well
  AlignedBuffer<double> scratch_;
  AlignedBuffer<std::uint32_t> scratch_id_;
  CellSort::Workspace sort_workspace_;
};

}  // namespace eisph
