#include "scheme/particle_system.hpp"

#include "core/lattice.hpp"
#include "scheme/particle_packing.hpp"
#include "scheme/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 1024;
/// Height of the cell grid in units of the initial height of the water.
constexpr double kGridHeight = 1.0;
/// Fluid particles are kept this far apart (ParticleMotion), in particle spacings.
constexpr double kSeparationReach = 0.62;

}  // namespace

template <int Dim>
ParticleSystem<Dim>::ParticleSystem(const Scene& of, int threads)
    : ParticleSystem(of, threads, packed_fluid(of, threads)) {}

template <int Dim>
ParticleSystem<Dim>::ParticleSystem(const Scene& of, int threads, const FluidLattice& sites)
    : scene(of),
      pool(threads),
      lattice(lattice_constants<Dim>(scene.kernel, scene.smoothing_ratio)),
      planes(scene),
      virtual_particles(scene),
      solids(scene),
      h(scene.smoothing_length()),
      alpha(kernel_normalisation<Dim>(scene.kernel) / std::pow(h, Dim)) {
  set_viscosities();
  if (scene.scheme.pair_separation > 0.0) {
    separation_squared = std::pow(kSeparationReach * scene.particle_spacing / h, 2);
  }
  std::array<double, Dim> cells{};
  for (int d = 0; d < Dim; ++d) {
    const int axis = scene_axis<Dim>(d);
    gravity[d] = scene.gravity[axis];
    extent[d] = scene.domain_max[axis] - scene.domain_min[axis];
    cells[d] = extent[d] / h;
  }
  place_particles(sites);
  // Cells up to a little above the water at rest; the few particles that fly higher share the topmost ones.
  cells[Dim - 1] = std::min(cells[Dim - 1], kGridHeight * highest_particle() / h + kKernelSupport);
  grid = CellGrid<Dim>(cells);
}

template <int Dim>
void ParticleSystem<Dim>::place_particles(const FluidLattice& sites) {
  fluid = static_cast<std::uint32_t>(sites.position.size());
  initial_fluid = fluid;
  volume = sites.particle_volume;
  for (auto& component : position) component.resize_exactly(fluid);
  for (auto& component : velocity) component.resize_exactly(fluid);
  for (AlignedBuffer<float>* array : {&carried, &pressure, &number_density}) {
    array->resize_exactly(fluid);
    array->fill(0.0F);
  }
  id.resize_exactly(fluid);
  for (std::uint32_t i = 0; i < fluid; ++i) {
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      position[d][i] = sites.position[i][axis] - scene.domain_min[axis];
      velocity[d][i] = static_cast<float>(sites.velocity[i][axis]);
    }
    id[i] = i;
    speed_max = std::max(speed_max, sites.velocity[i].norm());
  }
}

template <int Dim>
void ParticleSystem<Dim>::set_viscosities() {
  // Of ViscousTerms. With more than 0.3 of it Taylor-Green vortices by ISPH blow up, and those of the weakly
  // compressible schemes, whose density makes noise of every difference, decay 4 to 5 % too fast.
  constexpr double kMorrisPart = 0.9;
  constexpr double kMorrisPartInNoise = 0.3;
  const bool noisy = scene.scheme.projects_velocity() || scene.scheme.weakly_compressible();
  morris_part = noisy ? kMorrisPartInNoise : kMorrisPart;
  laminar_viscosity = scene.kinematic_viscosity;
  artificial_viscosity = artificial_kinematic_viscosity(scene);
}

template <int Dim>
Vec3d ParticleSystem<Dim>::scene_vector(const std::array<double, Dim>& components) const {
  Vec3d vector = Vec3d::Zero();
  for (int d = 0; d < Dim; ++d) vector[scene_axis<Dim>(d)] = components[d];
  return vector;
}

template <int Dim>
void ParticleSystem<Dim>::sort_fluid() {
  const double to_units = 1.0 / h;
  bool any_open = false;
  for (int d = 0; d < Dim; ++d) {
    const int axis = scene_axis<Dim>(d);
    any_open |= scene.faces[2 * axis].kind == FaceKind::Open;
    any_open |= axis != 2 && scene.faces[2 * axis + 1].kind == FaceKind::Open;
  }
  const auto gone = [&](std::size_t i) {
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      if (scene.faces[2 * axis].kind == FaceKind::Open && position[d][i] < 0.0) return true;
      const bool open_end = axis != 2 && scene.faces[2 * axis + 1].kind == FaceKind::Open;
      if (open_end && position[d][i] > extent[d]) return true;
    }
    return false;
  };
  const std::size_t cells = grid.cells();
  fluid_sort.sort(fluid, cells, pool, sort_workspace_, [&](std::size_t i) {
    if (any_open && gone(i)) return static_cast<std::uint32_t>(cells);
    float xi[Dim];
    for (int d = 0; d < Dim; ++d) xi[d] = static_cast<float>(position[d][i] * to_units);
    return grid.index(xi);
  });
  const std::uint32_t left = fluid_sort.start()[cells];
  outflow += fluid - left;

  // Images are laid out when they are known.
  const auto objects = static_cast<std::uint32_t>(solids.size());
  table.lay_out(objects, object_images.size(), left, 0);
  const std::uint32_t* order = fluid_sort.order();
  Float4* rows = fluid_rows(table.position);
  Float4* velocities = fluid_rows(table.velocity);
  pool.run_blocks(left, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t from = order[k];
      rows[k] = {0.0F, 0.0F, 0.0F, carried[from]};
      Float4 u{velocity[0][from], velocity[1][from], 0.0F, static_cast<float>(volume)};
      if constexpr (Dim == 3) u.z = velocity[2][from];
      velocities[k] = u;
    }
  });
  scratch_.resize_exactly(fluid);
  for (int d = 0; d < Dim; ++d) {
    pool.run_blocks(left, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) {
        scratch_[k] = position[d][order[k]];
        (&rows[k].x)[d] = static_cast<float>(scratch_[k] * to_units);
      }
    });
    position[d].swap(scratch_);
  }
  scratch_id_.resize_exactly(fluid);
  pool.run_blocks(left, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) scratch_id_[k] = id[order[k]];
  });
  id.swap(scratch_id_);
  fluid = left;
}

template <int Dim>
void ParticleSystem<Dim>::refresh_fluid() {
  const double to_units = 1.0 / h;
  Float4* rows = fluid_rows(table.position);
  Float4* velocities = fluid_rows(table.velocity);
  pool.run_blocks(fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      for (int d = 0; d < Dim; ++d) {
        (&rows[i].x)[d] = static_cast<float>(position[d][i] * to_units);
        (&velocities[i].x)[d] = velocity[d][i];
      }
      rows[i].w = carried[i];
    }
  });
  pool.run_blocks(objects(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) table.position[object_row(k)].w = kept_object_pressure(k);
  });
  mirror_object_pressure();
  mirror_motion();
}

template <int Dim>
bool ParticleSystem<Dim>::solids_stand_still(double time) const {
  return std::all_of(scene.gates.begin(), scene.gates.end(),
                     [&](const Gate& gate) { return gate.lift(time) == gate.lift(placed_at_); });
}

template <int Dim>
void ParticleSystem<Dim>::fill_objects() {
  const std::size_t count = solids.size();
  const bool viscous = scene.boundary.object_no_slip;
  AlignedBuffer<Float4> unsorted(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3d relative = (solids.position(k) - scene.domain_min) / h;
    unsorted[k] = {static_cast<float>(relative.x()), static_cast<float>(relative[scene_axis<Dim>(1)]),
                   Dim == 3 ? static_cast<float>(relative.z()) : 0.0F, 0.0F};
  }
  object_sort.sort(count, grid.cells(), pool, sort_workspace_,
                   [&](std::size_t k) { return grid.index(&unsorted[k].x); });
  for (auto& rows : object_rows_) rows.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t from = object_sort.order()[k];
    object_rows_[0][k] = unsorted[from];
    Float4 u{};
    (&u.x)[Dim - 1] = static_cast<float>(solids.rise_speed(from));
    u.w = viscous ? static_cast<float>(solids.volume(from)) : 0.0F;
    object_rows_[1][k] = u;
    const SolidSide& side = solids.side(from);
    object_rows_[2][k] = object_rows_[3][k] = Float4{};
    for (int d = 0; d < Dim; ++d) {
      (&object_rows_[2][k].x)[d] = static_cast<float>(side.normal[scene_axis<Dim>(d)]);
      (&object_rows_[3][k].x)[d] = static_cast<float>(side.across[scene_axis<Dim>(d)]);
    }
    // What lies in the middle belongs to the first side.
    auto middle = static_cast<float>(side.middle / h);
    if (!solids.is_first_side(from)) middle = std::nextafter(middle, -1e9F);
    object_rows_[3][k].w = side.across.isZero() ? -1.0F : middle;
  }
  object_images.find(planes, grid, object_rows_[0].data(), count, pool, sort_workspace_);
}

template <int Dim>
void ParticleSystem<Dim>::place_boundaries(double time) {
  placed_at_ = time;
  const bool first_time = object_rows_[0].size() != solids.size();
  if (!solids.empty() && (solids.update(time) || first_time)) {
    // The fluid's place in the table follows from the number of objects; keep its rows across the change.
    AlignedBuffer<Float4> keep[2];
    const Float4* from[2] = {fluid_rows(table.position), fluid_rows(table.velocity)};
    for (int a = 0; a < 2; ++a) {
      keep[a].resize(fluid);
      std::copy_n(from[a], fluid, keep[a].data());
    }
    fill_objects();
    table.lay_out(static_cast<std::uint32_t>(solids.size()), object_images.size(), fluid, 0);
    std::copy_n(keep[0].data(), fluid, fluid_rows(table.position));
    std::copy_n(keep[1].data(), fluid, fluid_rows(table.velocity));
  }
  fluid_images.find(planes, grid, fluid_rows(table.position), fluid, pool, sort_workspace_);
  const auto objects = static_cast<std::uint32_t>(solids.size());
  table.lay_out(objects, object_images.size(), fluid, fluid_images.size());
  ghost_particles_max = std::max<std::uint64_t>(ghost_particles_max, fluid_images.size());

  pool.run_blocks(objects, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t from = object_sort.order()[k];
      Float4 xi = object_rows_[0][k];
      xi.w = solids.pressure(from);
      table.position[table.first_object + k] = xi;
      table.velocity[table.first_object + k] = object_rows_[1][k];
    }
  });
  const Float4* positions = table.position.data() + table.first_object;
  const auto image = [&](AlignedBuffer<Float4>& rows) { return rows.data() + table.first_object_image; };
  object_images.mirror_positions(planes, positions, image(table.position), pool);
  object_images.mirror_vectors(planes, table.velocity.data() + table.first_object, image(table.velocity),
                               pool);
  mirror_motion();
}

template <int Dim>
void ParticleSystem<Dim>::find_neighbours() {
  typename NeighbourList<Dim>::Groups groups;
  groups[0] = {table.first_object, object_sort.start(), solids.size() == 0};
  groups[1] = {table.first_object_image, object_images.start(), object_images.size() == 0};
  groups[2] = {table.first_fluid, fluid_sort.start(), fluid == 0};
  groups[3] = {table.first_image, fluid_images.start(), fluid_images.size() == 0};
  const bool symmetric = planes.any_symmetry();
  neighbours.build(grid, table, groups, kernel_reach(scene.kernel), pool, symmetric);
  if (solids.has_thin_solids()) hide_far_sides();
  if (symmetric && !solids.empty()) hide_wall_images();
  set_object_sources();
}

template <int Dim>
void ParticleSystem<Dim>::find_initial_neighbours() {
  sort_fluid();
  for (std::uint32_t i = 0; i < fluid; ++i) {
    for (int d = 0; d < Dim; ++d) velocity[d][i] = (&table.velocity[fluid_row(i)].x)[d];
  }
  place_boundaries(0.0);
  find_neighbours();
}

template <int Dim>
void ParticleSystem<Dim>::set_source_volumes() {
  Float4* rows = fluid_rows(table.source);
  std::fill_n(rows, fluid, Float4{0.0F, 0.0F, 0.0F, static_cast<float>(volume)});
  mirror_source();
}

/// Of a thin solid, water sees only the side that faces it, and that side only this water.
template <int Dim>
void ParticleSystem<Dim>::hide_far_sides() {
  across_.resize(table.first_fluid);
  std::copy_n(object_rows_[3].data(), solids.size(), across_.data() + table.first_object);
  object_images.mirror_gradients(planes, across_.data() + table.first_object,
                                 across_.data() + table.first_object_image, pool);
  const auto sees = [&](std::uint32_t fluid_row, std::uint32_t object) {
    if (object >= table.first_fluid) return true;
    const Float4& across = across_[object];
    float along = 0.0F;
    for (int d = 0; d < Dim; ++d) {
      along += (&across.x)[d] * ((&table.position[fluid_row].x)[d] - (&table.position[object].x)[d]);
    }
    return along > across.w;
  };
  pool.run_blocks(fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t row = fluid_row(i);
      if (!neighbours.of(row).near_object) continue;
      neighbours.filter(row, [&](std::uint32_t j) { return sees(row, j); });
    }
  });
  pool.run_blocks(objects(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t row = object_row(k);
      if (!neighbours.is_wet(row) || solids.side(object_sort.order()[k]).across.isZero()) continue;
      neighbours.filter(row, [&](std::uint32_t j) { return sees(j, row); });
    }
  });
}

/// Solids see the water and what is water beyond a plane of symmetry. Images beyond walls have the water's
/// pressure, not that of water which goes on.
template <int Dim>
void ParticleSystem<Dim>::hide_wall_images() {
  pool.run_blocks(objects(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      if (!neighbours.is_wet(object_row(k))) continue;
      neighbours.filter(object_row(k), [&](std::uint32_t j) {
        return j < table.first_image || planes.is_symmetry(fluid_images.code(j - table.first_image));
      });
    }
  });
}

/// Objects without water in reach take no part in any sum: they know nothing of its pressure.
template <int Dim>
void ParticleSystem<Dim>::set_object_sources() {
  pool.run_blocks(solids.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t row = object_row(k);
      table.source[row] = {};
      table.source[row].w = neighbours.is_wet(row) ? static_cast<float>(object_volume(k)) : 0.0F;
    }
  });
  mirror_object_vectors(table.source);
}

template <int Dim>
void ParticleSystem<Dim>::mirror_object_vectors(AlignedBuffer<Float4>& rows) {
  object_images.mirror_vectors(planes, rows.data() + table.first_object,
                               rows.data() + table.first_object_image, pool);
}

template <int Dim>
void ParticleSystem<Dim>::mirror_object_pressure() {
  object_images.mirror_pressure(table.position.data() + table.first_object,
                                table.position.data() + table.first_object_image, pool);
}

template <int Dim>
void ParticleSystem<Dim>::mirror_pressure() {
  mirror_object_pressure();
  fluid_images.mirror_pressure(fluid_rows(table.position), table.position.data() + table.first_image, pool);
}

template <int Dim>
void ParticleSystem<Dim>::mirror_source() {
  fluid_images.mirror_vectors(planes, fluid_rows(table.source), table.source.data() + table.first_image,
                              pool);
}

template <int Dim>
void ParticleSystem<Dim>::mirror_source_gradients() {
  fluid_images.mirror_gradients(planes, fluid_rows(table.source), table.source.data() + table.first_image,
                                pool);
  object_images.mirror_gradients(planes, table.source.data() + table.first_object,
                                 table.source.data() + table.first_object_image, pool);
}

template <int Dim>
void ParticleSystem<Dim>::mirror_motion() {
  fluid_images.mirror_positions(planes, fluid_rows(table.position), table.position.data() + table.first_image,
                                pool);
  fluid_images.mirror_vectors(planes, fluid_rows(table.velocity), table.velocity.data() + table.first_image,
                              pool);
}

template <int Dim>
std::array<double, Dim> ParticleSystem<Dim>::position_of(std::size_t i) const {
  std::array<double, Dim> at;
  for (int d = 0; d < Dim; ++d) at[d] = position[d][i];
  return at;
}

template <int Dim>
Vec3d ParticleSystem<Dim>::place_of(std::size_t i) const {
  Vec3d at = scene_vector(position_of(i));
  for (int d = 0; d < Dim; ++d) at[scene_axis<Dim>(d)] += scene.domain_min[scene_axis<Dim>(d)];
  return at;
}

template <int Dim>
double ParticleSystem<Dim>::highest_particle() const {
  double top = 0.0;
  for (std::uint32_t i = 0; i < fluid; ++i) top = std::max(top, position[Dim - 1][i]);
  return top;
}

template <int Dim>
std::uint64_t ParticleSystem<Dim>::lost_particles() const {
  std::uint64_t inside = 0;
  for (std::uint32_t i = 0; i < fluid; ++i) {
    bool in = true;
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      in = in && (scene.faces[2 * axis].kind == FaceKind::Open || position[d][i] >= 0.0);
      in = in && (scene.faces[2 * axis + 1].kind == FaceKind::Open || position[d][i] <= extent[d]);
    }
    inside += in ? 1 : 0;
  }
  return initial_fluid - outflow - inside;
}

template <int Dim>
std::uint64_t ParticleSystem<Dim>::count_ghosts() const {
  std::uint64_t ghosts = 0;
  for (std::uint32_t i = 0; i < fluid; ++i) {
    Float4 xi{};
    for (int d = 0; d < Dim; ++d) (&xi.x)[d] = static_cast<float>(position[d][i] / h);
    planes.for_images(xi, [&](std::uint8_t) { ++ghosts; });
  }
  return ghosts;
}

template <int Dim>
void ParticleSystem<Dim>::add_bytes(std::map<std::string, double>& by_array) const {
  const auto add = [&](const char* name, std::size_t bytes) { by_array[name] += static_cast<double>(bytes); };
  for (const auto& component : position) add("position", component.bytes());
  for (const auto& component : velocity) add("velocity", component.bytes());
  add("pressure", carried.bytes() + pressure.bytes());
  add("id", id.bytes() + scratch_id_.bytes());
  add("density_and_coefficient", number_density.bytes());
  add("sort", scratch_.bytes() + fluid_sort.bytes() + sort_workspace_.bytes());
  add("neighbour_lists", neighbours.bytes());
  add("source_table", table.bytes());
  add("mirror_images", fluid_images.bytes() + object_images.bytes());
  add("objects", solids.bytes() + object_sort.bytes() + 4 * object_rows_[0].capacity() * sizeof(Float4) +
                     across_.bytes());
}

template struct ParticleSystem<2>;
template struct ParticleSystem<3>;

}  // namespace eisph
