#include "scheme/particle_scheme.hpp"

#include "scheme/initial_fit.hpp"
#include "scheme/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

template <int Dim>
void ParticleScheme<Dim>::initialise() {
  StageClock clock;
  clock.start(Stage::Pressure);
  ParticleSystem<Dim>& p = particles_;
  p.find_initial_neighbours();
  find_initial_state();
  motion_.record_initial_energy(p);
  clock.stop();
  clock_.reset();
  wall_time_initial_pressure_ = clock.total();
}

template <int Dim>
InitialFit ParticleScheme<Dim>::initial_fit() {
  return eisph::initial_fit(particles_);
}

template <int Dim>
void ParticleScheme<Dim>::step(double until) {
  const double before = clock_.total();
  const double cpu_before = thread_cpu_time();
  const double remaining = until - time_;
  const double parts = std::max(1.0, std::ceil(remaining / admissible_time_step() * (1.0 - 1e-12)));
  StepInHand step;
  step.number = steps_ + 1;
  step.time = time_;
  step.time_step = remaining / parts;
  step.last_time_step = steps_ == 0 ? step.time_step : time_step_;
  if (positions_lead() && steps_ == 0) {
    for (int d = 0; d < Dim; ++d) {
      for (std::uint32_t i = 0; i < particles_.fluid; ++i) {
        particles_.position[d][i] += 0.5 * step.time_step * particles_.velocity[d][i];
      }
    }
  }
  take_step(step);
  way_since_search_ += step.time_step * particles_.speed_max;
  clock_.start(Stage::Diagnostics);
  motion_.record_compression(particles_);
  clock_.stop();

  time_ = parts <= 1.0 ? until : time_ + step.time_step;
  time_step_ = step.time_step;
  ++steps_;
  wall_time_loop_ += clock_.total() - before;
  cpu_time_loop_ += thread_cpu_time() - cpu_before;
}

template <int Dim>
void ParticleScheme<Dim>::set_parameters(const RunningParameters& parameters) {
  Scene& scene = particles_.scene;
  scene.kinematic_viscosity = parameters.kinematic_viscosity;
  scene.artificial_viscosity = parameters.artificial_viscosity;
  (scene.scheme.weakly_compressible() ? scene.scheme.courant : scene.scheme.phi) = parameters.step_factor;
  particles_.set_viscosities();
}

template <int Dim>
void ParticleScheme<Dim>::find_neighbourhood(const StepInHand& step) {
  clock_.start(Stage::Sort);
  const Scene& scene = particles_.scene;
  const double reach = scene.scheme.list_reach * scene.particle_spacing;
  if (steps_ > 0 && way_since_search_ < reach && particles_.solids_stand_still(step.time)) {
    particles_.refresh_fluid();
    return;
  }
  way_since_search_ = 0.0;
  particles_.sort_fluid();
  clock_.start(Stage::Boundaries);
  particles_.place_boundaries(step.time);
  clock_.start(Stage::NeighbourSearch);
  particles_.find_neighbours();
}

template <int Dim>
std::shared_ptr<const Snapshot> ParticleScheme<Dim>::snapshot() const {
  const ParticleSystem<Dim>& p = particles_;
  const Scene& scene = p.scene;
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->time = time_;
  snapshot->step = steps_;
  snapshot->time_step = time_step_;
  snapshot->dimension = Dim;
  snapshot->particle_spacing = scene.particle_spacing;
  snapshot->smoothing_length = p.h;
  snapshot->particle_mass = scene.density * p.volume;
  snapshot->reference_density = scene.density;
  snapshot->penetrations = motion_.penetrations();
  snapshot->lost_particles = p.lost_particles();

  // Place of each particle in the order of ids, whatever has left the domain.
  std::vector<std::uint32_t> place(p.initial_fluid, 0);
  for (std::uint32_t i = 0; i < p.fluid; ++i) place[p.id[i]] = 1;
  std::uint32_t before = 0;
  for (std::uint32_t& entry : place) {
    const std::uint32_t present = entry;
    entry = before;
    before += present;
  }
  snapshot->id.resize(p.fluid);
  snapshot->position.resize(p.fluid);
  snapshot->velocity.resize(p.fluid);
  snapshot->pressure.resize(p.fluid);
  snapshot->number_density.resize(p.fluid);
  const double shift = positions_lead() ? -0.5 * time_step_ : 0.0;
  for (std::uint32_t i = 0; i < p.fluid; ++i) {
    const std::uint32_t at = place[p.id[i]];
    std::array<double, Dim> position;
    std::array<double, Dim> velocity;
    for (int d = 0; d < Dim; ++d) {
      velocity[d] = p.velocity[d][i];
      position[d] = p.position[d][i] + shift * velocity[d];
      const int axis = scene_axis<Dim>(d);
      // Bringing a particle back half a step must not take it through a wall.
      if (scene.faces[2 * axis].kind != FaceKind::Open) position[d] = std::max(position[d], 0.0);
      if (scene.faces[2 * axis + 1].kind != FaceKind::Open) position[d] = std::min(position[d], p.extent[d]);
    }
    Vec3d absolute = p.scene_vector(position);
    for (int d = 0; d < Dim; ++d) absolute[scene_axis<Dim>(d)] += scene.domain_min[scene_axis<Dim>(d)];
    snapshot->id[at] = p.id[i];
    snapshot->position[at] = absolute.template cast<float>();
    snapshot->velocity[at] = p.scene_vector(velocity).template cast<float>();
    snapshot->pressure[at] = p.pressure[i];
    snapshot->number_density[at] = p.number_density[i];
  }
  auto objects = std::make_shared<ObjectParticles>();
  objects->spacing = static_cast<float>(p.solids.spacing());
  objects->position.reserve(p.solids.particles());
  objects->pressure.reserve(p.solids.particles());
  for (std::size_t k = 0; k < p.solids.size(); ++k) {
    if (!p.solids.is_first_side(k)) continue;
    objects->position.emplace_back(p.solids.position(k).template cast<float>());
    objects->pressure.push_back(p.solids.pressure(k));
  }
  snapshot->objects = std::move(objects);
  return snapshot;
}

template <int Dim>
std::uint64_t ParticleScheme<Dim>::state_bytes(std::map<std::string, double>* by_array) const {
  std::map<std::string, double> bytes;
  particles_.add_bytes(bytes);
  add_bytes(bytes);
  double sum = 0.0;
  for (const auto& [name, size] : bytes) sum += size;
  if (by_array != nullptr) *by_array = bytes;
  return static_cast<std::uint64_t>(sum);
}

template <int Dim>
RunSummary ParticleScheme<Dim>::summary() const {
  const ParticleSystem<Dim>& p = particles_;
  RunSummary summary;
  summary.scene = p.scene.name;
  summary.scheme = p.scene.scheme.name;
  summary.dimension = Dim;
  summary.fluid_particles = p.initial_fluid;
  summary.object_particles = p.solids.particles();
  summary.ghost_particles_max = p.ghost_particles_max;
  summary.threads = p.pool.threads();
  summary.steps = steps_;
  summary.simulated_time = time_;
  const auto steps = static_cast<double>(std::max<std::uint64_t>(steps_, 1));
  summary.time_step_mean = time_ / steps;
  summary.wall_time_loop = wall_time_loop_;
  summary.cpu_time_loop = cpu_time_loop_;
  summary.wall_time_initial_pressure = wall_time_initial_pressure_;
  const double particle_steps = static_cast<double>(p.initial_fluid) * static_cast<double>(steps_);
  summary.particle_steps_per_second = wall_time_loop_ > 0.0 ? particle_steps / wall_time_loop_ : 0.0;
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    summary.stage_ns_per_particle_step[std::string(kStageNames[stage])] =
        particle_steps > 0.0 ? 1e9 * clock_.seconds(static_cast<Stage>(stage)) / particle_steps : 0.0;
  }
  summary.state_bytes_per_particle =
      static_cast<double>(state_bytes(&summary.state_bytes_by_array)) / static_cast<double>(p.initial_fluid);
  summary.pair_evaluations = p.pair_evaluations;
  motion_.report(summary);
  report(summary);
  summary.outflow_particles = p.outflow;
  summary.lost_particles = p.lost_particles();
  summary.mass_error = (static_cast<double>(p.fluid + p.outflow) - static_cast<double>(p.initial_fluid)) /
                       static_cast<double>(p.initial_fluid);
  return summary;
}

template <int Dim>
SimulationPlan ParticleScheme<Dim>::plan() const {
  const ParticleSystem<Dim>& p = particles_;
  SimulationPlan plan;
  plan.fluid_particles = p.initial_fluid;
  plan.water_volume = p.volume * static_cast<double>(p.initial_fluid);
  plan.object_particles = p.solids.particles();
  plan.virtual_particles = p.virtual_particles.count();
  plan.ghost_particles = p.count_ghosts();
  plan.time_step = admissible_time_step();
  plan.effective_sound_speed = sound_speed(plan.time_step);
  plan.estimated_steps = static_cast<std::uint64_t>(std::ceil(p.scene.end_time / plan.time_step));
  // Bytes per particle as laid out: state and work arrays, lists of about the lattice's length.
  const double list = 4.0 * (p.lattice.neighbours + 1 + 0.5 * kPackWidth) + 8.0;
  const double fluid = 8.0 * (Dim + 1) + 4.0 * Dim + 24.0 + 8.0 + 48.0 + list + planned_bytes();
  const double ghost = 48.0 + 16.0 + 8.0;
  const double object = 48.0 + 32.0 + 56.0 + 16.0;
  plan.estimated_bytes = static_cast<std::uint64_t>(
      1.125 * (fluid * static_cast<double>(p.fluid) + ghost * static_cast<double>(plan.ghost_particles) +
               object * static_cast<double>(p.solids.size())) +
      4.0 * static_cast<double>(p.grid.cells()) * (p.pool.threads() + 1) * 3.0);
  return plan;
}

template class ParticleScheme<2>;
template class ParticleScheme<3>;

}  // namespace eisph
