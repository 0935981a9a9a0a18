#include "scheme/eisph_solver.hpp"

#include "core/error.hpp"
#include "core/lattice.hpp"
#include "scheme/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 1024;
/// Height of the cell grid in units of the initial height of the water.
constexpr double kGridHeight = 1.0;
/// Blow-up: speeds beyond this many times the largest that gravity and the initial state explain.
constexpr double kSpeedLimitFactor = 20.0;

}  // namespace

template <int Dim>
EisphSolver<Dim>::EisphSolver(const Scene& scene, int threads)
    : scene_(scene),
      pool_(threads),
      lattice_(lattice_constants<Dim>(scene.smoothing_ratio)),
      planes_(scene),
      virtual_particles_(scene),
      solids_(scene),
      h_(scene.smoothing_length()),
      alpha_(cubic_spline::normalisation<Dim>() / std::pow(h_, Dim)),
      volume_(std::pow(scene.particle_spacing, Dim)),
      viscosity_(scene.kinematic_viscosity + artificial_kinematic_viscosity(scene)) {
  std::array<double, Dim> cells{};
  for (int d = 0; d < Dim; ++d) {
    const int axis = scene_axis<Dim>(d);
    gravity_[d] = scene.gravity[axis];
    extent_[d] = scene.domain_max[axis] - scene.domain_min[axis];
    cells[d] = extent_[d] / h_;
  }
  place_particles();
  // Cells up to a little above the water at rest; the few particles that fly higher share the topmost ones.
  double top = 0.0;
  for (std::uint32_t i = 0; i < fluid_; ++i) top = std::max(top, position_[Dim - 1][i]);
  cells[Dim - 1] = std::min(cells[Dim - 1], kGridHeight * top / h_ + cubic_spline::kSupport);
  grid_ = CellGrid<Dim>(cells);
}

template <int Dim>
void EisphSolver<Dim>::place_particles() {
  const FluidLattice lattice = fluid_lattice(scene_);
  fluid_ = static_cast<std::uint32_t>(lattice.position.size());
  initial_fluid_ = fluid_;
  for (auto& component : position_) component.resize_exactly(fluid_);
  for (auto& component : velocity_) component.resize_exactly(fluid_);
  pressure_.resize_exactly(fluid_);
  pressure_.fill(0.0F);
  id_.resize_exactly(fluid_);
  double fastest = 0.0;
  for (std::uint32_t i = 0; i < fluid_; ++i) {
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      position_[d][i] = lattice.position[i][axis] - scene_.domain_min[axis];
      velocity_[d][i] = static_cast<float>(lattice.velocity[i][axis]);
    }
    id_[i] = i;
    fastest = std::max(fastest, lattice.velocity[i].norm());
  }
  speed_max_ = fastest;
  const double fall =
      std::sqrt(2.0 * scene_.gravity.norm() * (scene_.domain_max - scene_.domain_min).maxCoeff());
  speed_limit_ = kSpeedLimitFactor * std::max({scene_.reference_speed(), fall, fastest});
  for (AlignedBuffer<float>* array : {&number_density_, &coefficient_, &total_pressure_}) {
    array->resize_exactly(fluid_);
    array->fill(0.0F);
  }
}

template <int Dim>
Vec3d EisphSolver<Dim>::scene_vector(const std::array<double, Dim>& components) const {
  Vec3d vector = Vec3d::Zero();
  for (int d = 0; d < Dim; ++d) vector[scene_axis<Dim>(d)] = components[d];
  return vector;
}

/// Positions of the symplectic stepping are half a step ahead of time_.
template <int Dim>
double EisphSolver<Dim>::output_shift() const {
  return scene_.scheme.stepping == Stepping::Symplectic ? -0.5 * time_step_ : 0.0;
}

template <int Dim>
void EisphSolver<Dim>::initialise() {
  StageClock clock;
  clock.start(Stage::Pressure);
  sort_fluid();
  // A step leaves the velocities in the order of its sort; so does this.
  for (std::uint32_t i = 0; i < fluid_; ++i) {
    for (int d = 0; d < Dim; ++d) velocity_[d][i] = (&table_.velocity[table_.first_fluid + i].x)[d];
  }
  place_boundaries();
  find_neighbours();
  // Density and the coefficients of the first snapshot; the pressures computed here are replaced below.
  accelerate(1.0);
  relax_pressure(1.0);
  pressure_.fill(0.0F);
  switch (scene_.scheme.initial_pressure) {
    case InitialPressure::Solve:
      solve_initial_pressure();
      break;
    case InitialPressure::Hydrostatic:
      set_hydrostatic_pressure();
      break;
    case InitialPressure::Zero:
      break;
  }
  for (std::uint32_t i = 0; i < fluid_; ++i) total_pressure_[i] = pressure_[i];
  compression_max_ = 0.0;
  compression_p95_ = 0.0;
  double energy = 0.0;
  for (std::uint32_t i = 0; i < fluid_; ++i) {
    for (int d = 0; d < Dim; ++d) {
      energy += 0.5 * velocity_[d][i] * velocity_[d][i] - gravity_[d] * position_[d][i];
    }
  }
  energy_ = energy_initial_ = energy_lowest_ = energy * scene_.density * volume_;
  clock.stop();
  clock_.reset();
  wall_time_initial_pressure_ = clock.total();
}

template <int Dim>
void EisphSolver<Dim>::step(double until) {
  const double before = clock_.total();
  const double admissible = admissible_time_step(scene_, speed_max_);
  const double remaining = until - time_;
  const double parts = std::max(1.0, std::ceil(remaining / admissible * (1.0 - 1e-12)));
  const double time_step = remaining / parts;
  attempted_step_ = time_step;
  if (scene_.scheme.stepping == Stepping::Symplectic && steps_ == 0) {
    // The first positions of the symplectic stepping: half a step ahead.
    for (int d = 0; d < Dim; ++d) {
      for (std::uint32_t i = 0; i < fluid_; ++i) position_[d][i] += 0.5 * time_step * velocity_[d][i];
    }
    time_step_ = time_step;
  }

  clock_.start(Stage::Sort);
  sort_fluid();
  clock_.start(Stage::Boundaries);
  place_boundaries();
  clock_.start(Stage::NeighbourSearch);
  find_neighbours();
  clock_.start(Stage::Acceleration);
  accelerate(time_step);
  clock_.start(Stage::Pressure);
  relax_pressure(time_step);
  clock_.start(Stage::Gradient);
  apply_gradient(time_step);
  clock_.start(Stage::Diagnostics);
  record_compression();
  clock_.stop();

  time_ = parts <= 1.0 ? until : time_ + time_step;
  time_step_ = time_step;
  ++steps_;
  wall_time_loop_ += clock_.total() - before;
}

template <int Dim>
void EisphSolver<Dim>::sort_fluid() {
  const double to_units = 1.0 / h_;
  bool any_open = false;
  for (int d = 0; d < Dim; ++d) {
    const int axis = scene_axis<Dim>(d);
    any_open |= scene_.faces[2 * axis].kind == FaceKind::Open;
    any_open |= axis != 2 && scene_.faces[2 * axis + 1].kind == FaceKind::Open;
  }
  const auto gone = [&](std::size_t i) {
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      if (scene_.faces[2 * axis].kind == FaceKind::Open && position_[d][i] < 0.0) return true;
      const bool open_end = axis != 2 && scene_.faces[2 * axis + 1].kind == FaceKind::Open;
      if (open_end && position_[d][i] > extent_[d]) return true;
    }
    return false;
  };
  const std::size_t cells = grid_.cells();
  fluid_sort_.sort(fluid_, cells, pool_, sort_workspace_, [&](std::size_t i) {
    if (any_open && gone(i)) return static_cast<std::uint32_t>(cells);
    float xi[Dim];
    for (int d = 0; d < Dim; ++d) xi[d] = static_cast<float>(position_[d][i] * to_units);
    return grid_.index(xi);
  });
  const std::uint32_t left = fluid_sort_.start()[cells];
  outflow_ += fluid_ - left;

  // Images are laid out when they are known.
  const auto objects = static_cast<std::uint32_t>(solids_.size());
  table_.lay_out(objects, object_images_.size(), left, 0);
  const std::uint32_t* order = fluid_sort_.order();
  Float4* rows = fluid_rows(table_.position);
  Float4* velocities = fluid_rows(table_.velocity);
  pool_.run_blocks(left, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t from = order[k];
      rows[k] = {0.0F, 0.0F, 0.0F, pressure_[from]};
      Float4 velocity{velocity_[0][from], velocity_[1][from], 0.0F, static_cast<float>(volume_)};
      if constexpr (Dim == 3) velocity.z = velocity_[2][from];
      velocities[k] = velocity;
    }
  });
  scratch_.resize_exactly(fluid_);
  for (int d = 0; d < Dim; ++d) {
    pool_.run_blocks(left, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) {
        scratch_[k] = position_[d][order[k]];
        (&rows[k].x)[d] = static_cast<float>(scratch_[k] * to_units);
      }
    });
    position_[d].swap(scratch_);
  }
  scratch_id_.resize_exactly(fluid_);
  pool_.run_blocks(left, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) scratch_id_[k] = id_[order[k]];
  });
  id_.swap(scratch_id_);
  fluid_ = left;
}

template <int Dim>
void EisphSolver<Dim>::fill_objects() {
  const std::size_t count = solids_.size();
  const bool viscous = scene_.boundary.object_no_slip;
  AlignedBuffer<Float4> unsorted(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3d relative = (solids_.position(k) - scene_.domain_min) / h_;
    unsorted[k] = {static_cast<float>(relative.x()), static_cast<float>(relative[scene_axis<Dim>(1)]),
                   Dim == 3 ? static_cast<float>(relative.z()) : 0.0F, 0.0F};
  }
  object_sort_.sort(count, grid_.cells(), pool_, sort_workspace_,
                    [&](std::size_t k) { return grid_.index(&unsorted[k].x); });
  for (auto& rows : object_rows_) rows.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t from = object_sort_.order()[k];
    object_rows_[0][k] = unsorted[from];
    Float4 velocity{};
    (&velocity.x)[Dim - 1] = static_cast<float>(solids_.rise_speed(from));
    velocity.w = viscous ? static_cast<float>(solids_.volume(from)) : 0.0F;
    object_rows_[1][k] = velocity;
  }
  object_images_.find(planes_, grid_, object_rows_[0].data(), count, pool_, sort_workspace_);
  object_pressure_.resize(count);
  object_coefficient_.resize(count);
}

template <int Dim>
void EisphSolver<Dim>::place_boundaries() {
  const bool first_time = object_rows_[0].size() != solids_.size();
  if (!solids_.empty() && (solids_.update(time_) || first_time)) {
    // The fluid's place in the table follows from the number of objects; keep its rows across the change.
    AlignedBuffer<Float4> keep[2];
    const Float4* from[2] = {fluid_rows(table_.position), fluid_rows(table_.velocity)};
    for (int a = 0; a < 2; ++a) {
      keep[a].resize(fluid_);
      std::copy_n(from[a], fluid_, keep[a].data());
    }
    fill_objects();
    table_.lay_out(static_cast<std::uint32_t>(solids_.size()), object_images_.size(), fluid_, 0);
    std::copy_n(keep[0].data(), fluid_, fluid_rows(table_.position));
    std::copy_n(keep[1].data(), fluid_, fluid_rows(table_.velocity));
  }
  fluid_images_.find(planes_, grid_, fluid_rows(table_.position), fluid_, pool_, sort_workspace_);
  const auto objects = static_cast<std::uint32_t>(solids_.size());
  table_.lay_out(objects, object_images_.size(), fluid_, fluid_images_.size());
  ghost_particles_max_ = std::max<std::uint64_t>(ghost_particles_max_, fluid_images_.size());

  pool_.run_blocks(objects, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t from = object_sort_.order()[k];
      Float4 position = object_rows_[0][k];
      position.w = solids_.pressure(from);
      table_.position[table_.first_object + k] = position;
      table_.velocity[table_.first_object + k] = object_rows_[1][k];
    }
  });
  const Float4* positions = table_.position.data() + table_.first_object;
  const auto image = [&](AlignedBuffer<Float4>& rows) { return rows.data() + table_.first_object_image; };
  object_images_.mirror_positions(planes_, positions, image(table_.position), pool_);
  object_images_.mirror_vectors(planes_, table_.velocity.data() + table_.first_object, image(table_.velocity),
                                pool_);
  fluid_images_.mirror_positions(planes_, fluid_rows(table_.position),
                                 table_.position.data() + table_.first_image, pool_);
  fluid_images_.mirror_vectors(planes_, fluid_rows(table_.velocity),
                               table_.velocity.data() + table_.first_image, pool_);
}

template <int Dim>
void EisphSolver<Dim>::find_neighbours() {
  typename NeighbourList<Dim>::Groups groups;
  groups[0] = {table_.first_object, object_sort_.start(), solids_.size() == 0};
  groups[1] = {table_.first_object_image, object_images_.start(), object_images_.size() == 0};
  groups[2] = {table_.first_fluid, fluid_sort_.start(), fluid_ == 0};
  groups[3] = {table_.first_image, fluid_images_.start(), fluid_images_.size() == 0};
  neighbours_.build(grid_, table_, groups, pool_);
  set_object_sources();
}

/// What drives the pressure at a solid is its own motion alone. Objects without water in reach take no part
/// in the pressures of the others: their own is zero for want of an equation, not because they are free.
template <int Dim>
void EisphSolver<Dim>::set_object_sources() {
  pool_.run_blocks(solids_.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const auto row = static_cast<std::uint32_t>(table_.first_object + k);
      Float4 source = object_rows_[1][k];
      (&source.x)[Dim - 1] *= static_cast<float>(scene_.scheme.source_factor);
      const double volume = solids_.volume(object_sort_.order()[k]);
      source.w = neighbours_.is_wet(row) ? static_cast<float>(volume) : 0.0F;
      table_.source[row] = source;
    }
  });
  object_images_.mirror_vectors(planes_, table_.source.data() + table_.first_object,
                                table_.source.data() + table_.first_object_image, pool_);
}

template EisphSolver<2>::EisphSolver(const Scene&, int);
template EisphSolver<3>::EisphSolver(const Scene&, int);
template double EisphSolver<2>::output_shift() const;
template double EisphSolver<3>::output_shift() const;
template Vec3d EisphSolver<2>::scene_vector(const std::array<double, 2>&) const;
template Vec3d EisphSolver<3>::scene_vector(const std::array<double, 3>&) const;
template void EisphSolver<2>::initialise();
template void EisphSolver<3>::initialise();
template void EisphSolver<2>::step(double);
template void EisphSolver<3>::step(double);
template void EisphSolver<2>::sort_fluid();
template void EisphSolver<3>::sort_fluid();
template void EisphSolver<2>::place_boundaries();
template void EisphSolver<3>::place_boundaries();
template void EisphSolver<2>::find_neighbours();
template void EisphSolver<3>::find_neighbours();

}  // namespace eisph
