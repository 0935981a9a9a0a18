#include "core/error.hpp"
#include "scheme/eisph_solver.hpp"
#include "scheme/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 8192;
/// Classes of the compression histogram: 1e-3 wide below 0.5, the rest in wider ones.
constexpr double kClassWidth = 1e-3;

}  // namespace

template <int Dim>
std::shared_ptr<const Snapshot> EisphSolver<Dim>::snapshot() const {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->time = time_;
  snapshot->step = steps_;
  snapshot->time_step = time_step_;
  snapshot->dimension = Dim;
  snapshot->particle_spacing = scene_.particle_spacing;
  snapshot->smoothing_length = h_;
  snapshot->particle_mass = scene_.density * volume_;
  snapshot->reference_density = scene_.density;
  snapshot->penetrations = penetrations_;
  snapshot->lost_particles = lost_particles();

  // Place of each particle in the order of ids, whatever has left the domain.
  std::vector<std::uint32_t> place(initial_fluid_, 0);
  for (std::uint32_t i = 0; i < fluid_; ++i) place[id_[i]] = 1;
  std::uint32_t before = 0;
  for (std::uint32_t& entry : place) {
    const std::uint32_t present = entry;
    entry = before;
    before += present;
  }
  snapshot->id.resize(fluid_);
  snapshot->position.resize(fluid_);
  snapshot->velocity.resize(fluid_);
  snapshot->pressure.resize(fluid_);
  snapshot->number_density.resize(fluid_);
  const double shift = output_shift();
  for (std::uint32_t i = 0; i < fluid_; ++i) {
    const std::uint32_t at = place[id_[i]];
    std::array<double, Dim> position;
    std::array<double, Dim> velocity;
    for (int d = 0; d < Dim; ++d) {
      velocity[d] = velocity_[d][i];
      position[d] = position_[d][i] + shift * velocity[d];
      const int axis = scene_axis<Dim>(d);
      // Bringing a particle back half a step must not take it through a wall.
      if (scene_.faces[2 * axis].kind != FaceKind::Open) position[d] = std::max(position[d], 0.0);
      if (scene_.faces[2 * axis + 1].kind != FaceKind::Open) position[d] = std::min(position[d], extent_[d]);
    }
    Vec3d absolute = scene_vector(position);
    for (int d = 0; d < Dim; ++d) absolute[scene_axis<Dim>(d)] += scene_.domain_min[scene_axis<Dim>(d)];
    snapshot->id[at] = id_[i];
    snapshot->position[at] = absolute.template cast<float>();
    snapshot->velocity[at] = scene_vector(velocity).template cast<float>();
    snapshot->pressure[at] = total_pressure_[i];
    snapshot->number_density[at] = number_density_[i];
  }
  auto objects = std::make_shared<ObjectParticles>();
  objects->spacing = static_cast<float>(solids_.spacing());
  objects->position.reserve(solids_.size());
  objects->pressure.reserve(solids_.size());
  for (std::size_t k = 0; k < solids_.size(); ++k) {
    objects->position.emplace_back(solids_.position(k).template cast<float>());
    objects->pressure.push_back(solids_.pressure(k));
  }
  snapshot->objects = std::move(objects);
  return snapshot;
}

template <int Dim>
void EisphSolver<Dim>::add_up(const std::vector<BlockSums>& blocks) {
  double kinetic = 0.0;
  double potential = 0.0;
  double squared = 0.0;
  double density = 0.0;
  for (const BlockSums& block : blocks) {
    kinetic += block.kinetic;
    potential += block.potential;
    squared = std::max(squared, block.speed_squared_max);
    density = std::max(density, block.number_density_max);
    penetrations_ += block.penetrations;
    if (block.bad_row != kNoRow) throw_blow_up(block);
  }
  speed_max_ = std::sqrt(squared);
  compression_max_ = std::max(compression_max_, density - 1.0);
  energy_ = (kinetic + potential) * scene_.density * volume_;
  energy_gain_max_ = std::max(energy_gain_max_, energy_ - energy_lowest_);
  energy_lowest_ = std::min(energy_lowest_, energy_);
}

template <int Dim>
void EisphSolver<Dim>::throw_blow_up(const BlockSums& block) const {
  const Vec3d place = scene_.domain_min + scene_vector(block.bad_position);
  const Vec3d velocity = scene_vector(block.bad_velocity);
  throw BlowUpError(fmt::format(
      "the run blew up at t = {:.6g} s, step {} (time step {:.4g} s): particle {} at ({:.5g}, {:.5g}, "
      "{:.5g}) m "
      "has velocity ({:.4g}, {:.4g}, {:.4g}) m/s; speeds up to {:.4g} m/s are taken as physical. A smaller "
      "time step (scheme.phi or scheme.time_step) is the usual cure.",
      time_, steps_ + 1, attempted_step_, id_[block.bad_row], place.x(), place.y(), place.z(), velocity.x(),
      velocity.y(), velocity.z(), speed_limit_));
}

/// 95th percentile of n - 1 over the fluid.
template <int Dim>
void EisphSolver<Dim>::record_compression() {
  histograms_.resize(static_cast<std::size_t>(pool_.threads()));
  for (auto& histogram : histograms_) histogram.fill(0);
  pool_.run_blocks(fluid_, kBlock, [&](std::size_t first, std::size_t last, int worker) {
    auto& histogram = histograms_[static_cast<std::size_t>(worker)];
    const auto top = static_cast<float>(histogram.size() - 1);
    for (std::size_t i = first; i < last; ++i) {
      const float value = (number_density_[i] - 1.0F) * static_cast<float>(1.0 / kClassWidth);
      ++histogram[static_cast<std::size_t>(std::clamp(value, 0.0F, top))];
    }
  });
  const auto wanted = static_cast<std::uint64_t>(0.05 * fluid_);
  std::uint64_t above = 0;
  for (std::size_t k = histograms_[0].size(); k-- > 0;) {
    for (const auto& histogram : histograms_) above += histogram[k];
    if (above > wanted) {
      // The first class holds everything that is not compressed.
      const double value = k == 0 ? 0.0 : kClassWidth * (static_cast<double>(k) + 0.5);
      compression_p95_ = std::max(compression_p95_, value);
      return;
    }
  }
}

template <int Dim>
std::uint64_t EisphSolver<Dim>::state_bytes(std::map<std::string, double>* by_array) const {
  std::map<std::string, double> bytes;
  for (const auto& component : position_) bytes["position"] += static_cast<double>(component.bytes());
  for (const auto& component : velocity_) bytes["velocity"] += static_cast<double>(component.bytes());
  bytes["pressure"] = static_cast<double>(pressure_.bytes() + total_pressure_.bytes());
  bytes["id"] = static_cast<double>(id_.bytes() + scratch_id_.bytes());
  bytes["density_and_coefficient"] =
      static_cast<double>(number_density_.bytes() + coefficient_.bytes() + source_term_.bytes());
  bytes["sort"] = static_cast<double>(scratch_.bytes() + fluid_sort_.bytes() + sort_workspace_.bytes());
  bytes["neighbour_lists"] = static_cast<double>(neighbours_.bytes());
  bytes["source_table"] = static_cast<double>(table_.bytes());
  bytes["mirror_images"] = static_cast<double>(fluid_images_.bytes() + object_images_.bytes());
  bytes["objects"] = static_cast<double>(
      solids_.bytes() + object_sort_.bytes() + object_pressure_.bytes() + object_coefficient_.bytes() +
      (object_rows_[0].capacity() + object_rows_[1].capacity()) * sizeof(Float4));
  double sum = 0.0;
  for (const auto& [name, size] : bytes) sum += size;
  if (by_array != nullptr) *by_array = bytes;
  return static_cast<std::uint64_t>(sum);
}

/// A particle is lost if it has disappeared or stands where no water can be.
template <int Dim>
std::uint64_t EisphSolver<Dim>::lost_particles() const {
  std::uint64_t inside = 0;
  for (std::uint32_t i = 0; i < fluid_; ++i) {
    bool in = true;
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      in = in && (scene_.faces[2 * axis].kind == FaceKind::Open || position_[d][i] >= 0.0);
      in = in && (scene_.faces[2 * axis + 1].kind == FaceKind::Open || position_[d][i] <= extent_[d]);
    }
    inside += in ? 1 : 0;
  }
  return initial_fluid_ - outflow_ - inside;
}

template <int Dim>
RunSummary EisphSolver<Dim>::summary() const {
  RunSummary summary;
  summary.scene = scene_.name;
  summary.dimension = Dim;
  summary.fluid_particles = initial_fluid_;
  summary.object_particles = solids_.size();
  summary.ghost_particles_max = ghost_particles_max_;
  summary.threads = pool_.threads();
  summary.steps = steps_;
  summary.simulated_time = time_;
  const auto steps = static_cast<double>(std::max<std::uint64_t>(steps_, 1));
  summary.time_step_mean = time_ / steps;
  summary.wall_time_loop = wall_time_loop_;
  summary.wall_time_initial_pressure = wall_time_initial_pressure_;
  const double particle_steps = static_cast<double>(initial_fluid_) * static_cast<double>(steps_);
  summary.particle_steps_per_second = wall_time_loop_ > 0.0 ? particle_steps / wall_time_loop_ : 0.0;
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    summary.stage_ns_per_particle_step[std::string(kStageNames[stage])] =
        particle_steps > 0.0 ? 1e9 * clock_.seconds(static_cast<Stage>(stage)) / particle_steps : 0.0;
  }
  summary.state_bytes_per_particle =
      static_cast<double>(state_bytes(&summary.state_bytes_by_array)) / static_cast<double>(initial_fluid_);
  summary.penetrations = penetrations_;
  summary.outflow_particles = outflow_;
  summary.lost_particles = lost_particles();
  summary.compression_max = compression_max_;
  summary.compression_p95 = compression_p95_;
  summary.energy_initial = energy_initial_;
  summary.energy_final = energy_;
  summary.energy_gain_max = energy_gain_max_;
  summary.mass_error = (static_cast<double>(fluid_ + outflow_) - static_cast<double>(initial_fluid_)) /
                       static_cast<double>(initial_fluid_);
  return summary;
}

template <int Dim>
SimulationPlan EisphSolver<Dim>::plan() const {
  SimulationPlan plan;
  plan.fluid_particles = initial_fluid_;
  plan.object_particles = solids_.size();
  plan.virtual_particles = virtual_particles_.count();
  for (std::uint32_t i = 0; i < fluid_; ++i) {
    Float4 xi{};
    for (int d = 0; d < Dim; ++d) (&xi.x)[d] = static_cast<float>(position_[d][i] / h_);
    planes_.for_images(xi, [&](std::uint8_t) { ++plan.ghost_particles; });
  }
  plan.time_step = admissible_time_step(scene_, speed_max_);
  plan.effective_sound_speed =
      std::sqrt(scene_.scheme.source_factor / lattice_.laplacian) * h_ / plan.time_step;
  plan.estimated_steps = static_cast<std::uint64_t>(std::ceil(scene_.end_time / plan.time_step));
  // Bytes per particle as laid out: state and work arrays, lists of about the lattice's length.
  const double list = 4.0 * (lattice_.neighbours + 1 + 0.5 * kPackWidth) + 8.0;
  const double fluid = 8.0 * (Dim + 1) + 4.0 * Dim + 28.0 + 8.0 + 48.0 + list;
  const double ghost = 48.0 + 16.0 + 8.0;
  const double object = 48.0 + 32.0 + 56.0 + 16.0;
  plan.estimated_bytes = static_cast<std::uint64_t>(
      1.125 * (fluid * static_cast<double>(fluid_) + ghost * static_cast<double>(plan.ghost_particles) +
               object * static_cast<double>(solids_.size())) +
      4.0 * static_cast<double>(grid_.cells()) * (pool_.threads() + 1) * 3.0);
  return plan;
}

template std::shared_ptr<const Snapshot> EisphSolver<2>::snapshot() const;
template std::shared_ptr<const Snapshot> EisphSolver<3>::snapshot() const;
template void EisphSolver<2>::add_up(const std::vector<BlockSums>&);
template void EisphSolver<3>::add_up(const std::vector<BlockSums>&);
template void EisphSolver<2>::record_compression();
template void EisphSolver<3>::record_compression();
template RunSummary EisphSolver<2>::summary() const;
template RunSummary EisphSolver<3>::summary() const;
template SimulationPlan EisphSolver<2>::plan() const;
template SimulationPlan EisphSolver<3>::plan() const;

}  // namespace eisph
