#include "core/error.hpp"
#include "scheme/shallow_water_solver.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace eisph {

namespace {

/// Columns shallower than this part of a cell size are not drawn.
constexpr double kDrawnDepth = 0.02;
/// Spacing of the drawn particles over the cell size: in space such that the spheres of a single layer leave
/// no holes between them, in the plane such that discs touch.
constexpr double kSpacingInSpace = 1.25;

/// Cuts the columns into the particles that show them.
class ColumnParticles {
 public:
  ColumnParticles(const Scene& scene, const ColumnField& field, bool plane)
      : scene_(scene), field_(field), plane_(plane) {}

  /// Layer by layer from the surface down, so that ids rise.
  void fill(Snapshot& snapshot) const {
    std::vector<Column> columns = visible_columns();
    reserve(snapshot, columns.size());
    for (std::size_t layer = 0; !columns.empty(); ++layer) {
      std::erase_if(columns, [&](const Column& column) { return layer >= column.layers; });
      for (const Column& column : columns) add(column, layer, snapshot);
    }
  }

 private:
  struct Column {
    std::size_t cell = 0;
    std::size_t layers = 0;  ///< to be drawn
    double thickness = 0.0;  ///< of a layer, m
  };

  [[nodiscard]] std::vector<Column> visible_columns() const {
    std::vector<Column> columns;
    for (std::size_t j = 0; j < field_.rows; ++j) {
      for (std::size_t i = 0; i < field_.columns; ++i) {
        Column column;
        column.cell = field_.index(i, j);
        const double depth = field_.depth[column.cell];
        if (depth < kDrawnDepth * field_.cell_size) continue;
        column.layers = static_cast<std::size_t>(std::ceil(depth / field_.cell_size - 1e-6));
        column.thickness = depth / static_cast<double>(column.layers);
        if (plane_) {
          const double seen = level(column.cell) - lowest_beside(i, j);
          const double seen_layers = std::max(1.0, std::ceil(seen / column.thickness));
          column.layers = std::min(column.layers, static_cast<std::size_t>(seen_layers));
        }
        columns.push_back(column);
      }
    }
    return columns;
  }

  [[nodiscard]] double level(std::size_t cell) const { return field_.bed[cell] + field_.depth[cell]; }

  /// The lowest surface beside a cell, m above the floor: what stands above it can be seen.
  [[nodiscard]] double lowest_beside(std::size_t i, std::size_t j) const {
    if (i == 0 || j == 0 || i + 1 == field_.columns || j + 1 == field_.rows) return 0.0;
    const std::size_t cell = field_.index(i, j);
    const double along_x = std::min(level(cell - 1), level(cell + 1));
    return std::min(along_x, std::min(level(cell - field_.columns), level(cell + field_.columns)));
  }

  static void reserve(Snapshot& snapshot, std::size_t columns) {
    const std::size_t particles = columns + columns / 4;
    snapshot.id.reserve(particles);
    snapshot.position.reserve(particles);
    snapshot.velocity.reserve(particles);
    snapshot.pressure.reserve(particles);
    snapshot.number_density.reserve(particles);
  }

  void add(const Column& column, std::size_t layer, Snapshot& snapshot) const {
    const std::size_t cell = column.cell;
    const double size = field_.cell_size;
    const double below_surface = (static_cast<double>(layer) + 0.5) * column.thickness;
    const std::size_t row = cell / field_.columns;
    const auto i = static_cast<double>(cell - row * field_.columns);
    const auto j = static_cast<double>(row);
    const Vec3d position(field_.origin_x + (i + 0.5) * size,
                         plane_ ? field_.origin_y + (j + 0.5) * size : 0.0,
                         scene_.domain_min.z() + level(cell) - below_surface);
    snapshot.id.push_back(static_cast<std::uint32_t>(layer * field_.size() + cell));
    snapshot.position.emplace_back(position.cast<float>());
    snapshot.velocity.emplace_back(field_.velocity_x[cell], field_.velocity_y[cell], 0.0F);
    snapshot.pressure.push_back(
        static_cast<float>(scene_.density * std::abs(scene_.gravity.z()) * below_surface));
    snapshot.number_density.push_back(1.0F);
  }

  const Scene& scene_;
  const ColumnField& field_;
  bool plane_;
};

}  // namespace

std::shared_ptr<const ColumnField> ShallowWaterSolver::column_field() const {
  auto field = std::make_shared<ColumnField>();
  field->origin_x = grid_.origin_x;
  field->origin_y = grid_.origin_y;
  field->cell_size = grid_.cell_size;
  field->columns = grid_.columns;
  field->rows = grid_.rows;
  const std::size_t cells = grid_.columns * grid_.rows;
  for (std::vector<float>* values : {&field->bed, &field->depth, &field->velocity_x, &field->velocity_y}) {
    values->assign(cells, 0.0F);
  }
  for (std::size_t j = 0; j < grid_.rows; ++j) {
    for (std::size_t i = 0; i < grid_.columns; ++i) {
      const std::size_t from = grid_.index(i, j);
      const std::size_t to = field->index(i, j);
      field->bed[to] = static_cast<float>(bed_.bed()[from]);
      if (state_.depth[from] <= scene_.shallow_water.dry_depth) continue;
      field->depth[to] = static_cast<float>(state_.depth[from]);
      field->velocity_x[to] = static_cast<float>(state_.velocity_x[from]);
      field->velocity_y[to] = static_cast<float>(state_.velocity_y[from]);
    }
  }
  return field;
}

std::shared_ptr<const Snapshot> ShallowWaterSolver::snapshot() const {
  auto snapshot = std::make_shared<Snapshot>();
  const double size = grid_.cell_size;
  snapshot->time = time_;
  snapshot->step = steps_;
  snapshot->time_step = time_step_;
  snapshot->dimension = scene_.dimension;
  snapshot->particle_spacing = plane_ ? kSpacingInSpace * size : size;
  snapshot->smoothing_length = scene_.smoothing_ratio * snapshot->particle_spacing;
  snapshot->particle_mass = scene_.density * cell_area() * size;
  snapshot->reference_density = scene_.density;
  snapshot->columns = column_field();
  ColumnParticles(scene_, *snapshot->columns, plane_).fill(*snapshot);
  snapshot->objects = std::make_shared<ObjectParticles>();
  return snapshot;
}

std::uint64_t ShallowWaterSolver::state_bytes(std::map<std::string, double>* by_array) const {
  std::map<std::string, double> bytes;
  for (const State* state : {&state_, &next_}) {
    bytes["state"] +=
        static_cast<double>(state->depth.bytes() + state->velocity_x.bytes() + state->velocity_y.bytes());
  }
  bytes["bed_and_walls"] = static_cast<double>(bed_.bytes());
  for (const AlignedBuffer<double>* values :
       {&mass_x_, &mass_y_, &lower_y_, &upper_y_, &tangential_y_, &gain_x_, &gain_y_, &share_}) {
    bytes["fluxes"] += static_cast<double>(values->bytes());
  }
  for (const Workspace& work : workspaces_) {
    for (const RowSides& sides : work.sides) {
      for (const SideRow& side : sides) bytes["rows"] += static_cast<double>(side.bytes());
    }
  }
  double sum = 0.0;
  for (const auto& [name, size] : bytes) sum += size;
  if (by_array != nullptr) *by_array = bytes;
  return static_cast<std::uint64_t>(sum);
}

RunSummary ShallowWaterSolver::summary() const {
  RunSummary summary;
  summary.scheme = scene_.scheme.name;
  summary.scene = scene_.name;
  summary.dimension = scene_.dimension;
  summary.fluid_particles = fluid_particles();
  summary.object_particles = bed_.solid_cells();
  summary.threads = pool_.threads();
  summary.steps = steps_;
  summary.simulated_time = time_;
  summary.time_step_mean = time_ / static_cast<double>(std::max<std::uint64_t>(steps_, 1));
  summary.wall_time_loop = wall_time_loop_;
  const double cell_steps = static_cast<double>(fluid_particles()) * static_cast<double>(steps_);
  summary.particle_steps_per_second = wall_time_loop_ > 0.0 ? cell_steps / wall_time_loop_ : 0.0;
  constexpr std::array<const char*, kStages> kStageNames = {"boundaries", "fluxes", "update"};
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    summary.stage_ns_per_particle_step[kStageNames[stage]] =
        cell_steps > 0.0 ? 1e9 * stage_seconds_[stage] / cell_steps : 0.0;
  }
  summary.state_bytes_per_particle = static_cast<double>(state_bytes(&summary.state_bytes_by_array)) /
                                     static_cast<double>(fluid_particles());
  summary.outflow_volume = outflow_;
  summary.energy_initial = energy_initial_;
  summary.energy_final = energy_;
  summary.energy_gain_max = energy_gain_max_;
  if (volume_initial_ > 0.0) {
    summary.mass_error = (volume_ + outflow_ - volume_initial_) / volume_initial_;
  }
  return summary;
}

SimulationPlan ShallowWaterSolver::plan() const {
  SimulationPlan plan;
  plan.fluid_particles = fluid_particles();
  plan.object_particles = bed_.solid_cells();
  plan.wet_cells = wet_cells_initial_;
  plan.cell_size = grid_.cell_size;
  plan.water_volume = volume_initial_;
  plan.time_step = admissible_step();
  plan.effective_sound_speed = std::sqrt(gravity_ * scene_.reference_depth);
  // A front runs at up to 2 sqrt(g H), and with two axes the waves across it add to that.
  const double fastest = (plane_ ? 2.5 : 2.0) * std::sqrt(gravity_ * scene_.reference_depth);
  const double speed = std::max(wave_speed_, fastest);
  plan.estimated_steps = static_cast<std::uint64_t>(
      std::ceil(scene_.end_time * speed / (scene_.shallow_water.courant * grid_.cell_size)));
  plan.estimated_bytes = state_bytes(nullptr);
  return plan;
}

}  // namespace eisph
