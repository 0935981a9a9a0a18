#include "scheme/particle_motion.hpp"

#include "core/error.hpp"
#include "scheme/neighbour_sums.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace eisph {

namespace {

/// Blow-up: speeds beyond this many times the largest that gravity and the initial state explain.
constexpr double kSpeedLimitFactor = 20.0;
/// Largest shift of a particle in a step, in particle spacings.
constexpr double kLargestShift = 0.1;
/// Pairs of particles that are slower than this on the mean are not taken apart, over the expected speed.
constexpr double kSlow = 0.05;
constexpr std::size_t kHistogramBlock = 8192;
/// Classes of the compression histogram: 1e-3 wide below 0.5, the rest in wider ones.
constexpr double kClassWidth = 1e-3;

}  // namespace

template <int Dim>
ParticleMotion<Dim>::ParticleMotion(const ParticleSystem<Dim>& particles) {
  const Scene& scene = particles.scene;
  const double fall =
      std::sqrt(2.0 * scene.gravity.norm() * (scene.domain_max - scene.domain_min).maxCoeff());
  slow_ = kSlow * scene.expected_speed();
  speed_limit_ = kSpeedLimitFactor * std::max({scene.expected_speed(), fall, particles.speed_max});
}

/// -A h |u| dt grad n (Lind et al. 2012, Skillen et al. 2013), at most a tenth of the spacing; the velocity
/// stays. Not on the free surface.
template <int Dim>
void ParticleMotion<Dim>::shift(const ParticleSystem<Dim>& particles, std::size_t i, const Neighbours& near,
                                double time_step, Components& position, const Components& velocity) const {
  const Scene& scene = particles.scene;
  if (particles.number_density[i] < scene.scheme.free_surface_threshold) return;
  const Vector<Dim, double> gradient = concentration_gradient(particles, particles.fluid_row(i), near);
  double squared_speed = 0.0;
  double squared_gradient = 0.0;
  for (int d = 0; d < Dim; ++d) {
    squared_speed += velocity[d] * velocity[d];
    squared_gradient += gradient.x[d] * gradient.x[d];
  }
  const double factor = scene.scheme.shifting * particles.h * std::sqrt(squared_speed) * time_step;
  const double length = factor * std::sqrt(squared_gradient);
  const double most = kLargestShift * scene.particle_spacing;
  const double scale = length > most ? factor * most / length : factor;
  for (int d = 0; d < Dim; ++d) position[d] -= scale * gradient.x[d];
}

/// Of pairs of fluid particles nearer than the reach of separation both are moved apart by half of a part
/// (SchemeSettings::pair_separation) of what is missing, at most a tenth of the spacing in all; the velocity
/// stays. Pressure does not do that in flow which is stretched: two particles that are driven together along
/// one axis and from others along another keep the density that it reacts to, and stand for one from then
/// on. Water that hardly moves is left alone: it would be pressed together where it settles about solids.
template <int Dim>
void ParticleMotion<Dim>::separate(const ParticleSystem<Dim>& particles, std::size_t i,
                                   const Neighbours& near, Components& position) const {
  const SourceTable& table = particles.table;
  const Float4& at = table.position[particles.fluid_row(i)];
  const auto speed_of = [&](std::uint32_t row) {
    double sum = 0.0;
    for (int d = 0; d < Dim; ++d) sum += std::pow((&table.velocity[row].x)[d], 2);
    return std::sqrt(sum);
  };
  const double speed = speed_of(particles.fluid_row(i));
  Components way{};
  double squared_way = 0.0;
  for (const std::uint32_t* j = near.begin; j != near.end; ++j) {
    if (*j < table.first_fluid || *j >= table.first_image) continue;
    Components offset;
    double squared = kTinySquared;
    for (int d = 0; d < Dim; ++d) {
      offset[d] = static_cast<double>((&at.x)[d]) - (&table.position[*j].x)[d];
      squared += offset[d] * offset[d];
    }
    if (squared >= particles.separation_squared) continue;
    if (speed + speed_of(*j) < 2.0 * slow_) continue;
    const double missing = std::sqrt(particles.separation_squared / squared) - 1.0;
    for (int d = 0; d < Dim; ++d) way[d] += missing * offset[d];
  }
  const double factor = 0.5 * particles.scene.scheme.pair_separation * particles.h;
  for (int d = 0; d < Dim; ++d) {
    way[d] *= factor;
    squared_way += way[d] * way[d];
  }
  const double most = kLargestShift * particles.scene.particle_spacing;
  const double scale = squared_way > most * most ? most / std::sqrt(squared_way) : 1.0;
  for (int d = 0; d < Dim; ++d) position[d] += scale * way[d];
}

template <int Dim>
void ParticleMotion<Dim>::settle(ParticleSystem<Dim>& particles, std::size_t i, double lead, bool near_object,
                                 Components& position, Components& velocity, BlockSums& sums) const {
  double squared = 0.0;
  for (int d = 0; d < Dim; ++d) squared += velocity[d] * velocity[d];
  if (!(squared < speed_limit_ * speed_limit_) && sums.bad_row == kNoRow) {
    sums.bad_row = static_cast<std::uint32_t>(i);
    sums.bad_velocity = velocity;
    sums.bad_position = particles.position_of(i);
  }
  contain(particles, near_object, position, velocity, sums);
  for (int d = 0; d < Dim; ++d) {
    particles.position[d][i] = position[d];
    particles.velocity[d][i] = static_cast<float>(velocity[d]);
    sums.kinetic += 0.5 * velocity[d] * velocity[d];
    sums.potential -= particles.gravity[d] * (position[d] - lead * velocity[d]);
  }
  sums.speed_squared_max = std::max(sums.speed_squared_max, squared);
  sums.number_density_max =
      std::max(sums.number_density_max, static_cast<double>(particles.number_density[i]));
}

/// Safety clamp: a particle beyond a wall or inside a solid is counted as a penetration and put back, without
/// the velocity that took it there. A particle that crosses a symmetry plane changes places with its mirror
/// image, which is no penetration.
template <int Dim>
void ParticleMotion<Dim>::contain(const ParticleSystem<Dim>& particles, bool near_object,
                                  Components& position, Components& velocity, BlockSums& sums) const {
  const Scene& scene = particles.scene;
  bool penetrated = false;
  for (int d = 0; d < Dim; ++d) {
    const double extent = particles.extent[d];
    const int axis = scene_axis<Dim>(d);
    const bool low = position[d] < 0.0;
    if (!low && !(position[d] > extent)) continue;
    const FaceKind kind = scene.faces[2 * axis + (low ? 0 : 1)].kind;
    if (kind == FaceKind::Open) continue;
    const double mirrored = (low ? 0.0 : 2.0 * extent) - position[d];
    position[d] = low ? std::min(mirrored, 0.5 * extent) : std::max(mirrored, 0.5 * extent);
    if (kind == FaceKind::Symmetry) {
      velocity[d] = -velocity[d];
      continue;
    }
    velocity[d] = low ? std::max(velocity[d], 0.0) : std::min(velocity[d], 0.0);
    penetrated = true;
  }
  if (near_object) {
    Vec3d point = scene.domain_min + particles.scene_vector(position);
    Vec3d normal = Vec3d::Zero();
    if (particles.solids.push_out(point, normal)) {
      penetrated = true;
      double inward = 0.0;
      for (int d = 0; d < Dim; ++d) inward += velocity[d] * normal[scene_axis<Dim>(d)];
      for (int d = 0; d < Dim; ++d) {
        const int axis = scene_axis<Dim>(d);
        position[d] = point[axis] - scene.domain_min[axis];
        if (inward < 0.0) velocity[d] -= inward * normal[axis];
      }
    }
  }
  if (penetrated) ++sums.penetrations;
}

template <int Dim>
void ParticleMotion<Dim>::add_up(ParticleSystem<Dim>& particles, const StepInHand& step) {
  double kinetic = 0.0;
  double potential = 0.0;
  double squared = 0.0;
  double density = 0.0;
  for (const BlockSums& block : blocks_) {
    kinetic += block.kinetic;
    potential += block.potential;
    squared = std::max(squared, block.speed_squared_max);
    density = std::max(density, block.number_density_max);
    penetrations_ += block.penetrations;
    if (block.bad_row != kNoRow) throw_blow_up(particles, step, block);
  }
  particles.speed_max = std::sqrt(squared);
  compression_max_ = std::max(compression_max_, density - 1.0);
  energy_ = (kinetic + potential) * particles.scene.density * particles.volume;
  energy_gain_max_ = std::max(energy_gain_max_, energy_ - energy_lowest_);
  energy_lowest_ = std::min(energy_lowest_, energy_);
}

template <int Dim>
void ParticleMotion<Dim>::throw_blow_up(const ParticleSystem<Dim>& particles, const StepInHand& step,
                                        const BlockSums& block) const {
  const Vec3d place = particles.scene.domain_min + particles.scene_vector(block.bad_position);
  const Vec3d velocity = particles.scene_vector(block.bad_velocity);
  throw BlowUpError(fmt::format(
      "the run blew up at t = {:.6g} s, step {} (time step {:.4g} s): particle {} at ({:.5g}, {:.5g}, "
      "{:.5g}) m has velocity ({:.4g}, {:.4g}, {:.4g}) m/s; speeds up to {:.4g} m/s are taken as physical. A "
      "smaller time step ({} or scheme.time_step) is the usual cure.",
      step.time, step.number, step.time_step, particles.id[block.bad_row], place.x(), place.y(), place.z(),
      velocity.x(), velocity.y(), velocity.z(), speed_limit_,
      particles.scene.scheme.weakly_compressible() ? "scheme.courant" : "scheme.phi"));
}

template <int Dim>
void ParticleMotion<Dim>::record_compression(ParticleSystem<Dim>& particles) {
  histograms_.resize(static_cast<std::size_t>(particles.pool.threads()));
  for (auto& histogram : histograms_) histogram.fill(0);
  particles.pool.run_blocks(
      particles.fluid, kHistogramBlock, [&](std::size_t first, std::size_t last, int worker) {
        auto& histogram = histograms_[static_cast<std::size_t>(worker)];
        const auto top = static_cast<float>(histogram.size() - 1);
        for (std::size_t i = first; i < last; ++i) {
          const float value = (particles.number_density[i] - 1.0F) * static_cast<float>(1.0 / kClassWidth);
          ++histogram[static_cast<std::size_t>(std::clamp(value, 0.0F, top))];
        }
      });
  const auto wanted = static_cast<std::uint64_t>(0.05 * particles.fluid);
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
void ParticleMotion<Dim>::record_initial_energy(const ParticleSystem<Dim>& particles) {
  double energy = 0.0;
  for (std::uint32_t i = 0; i < particles.fluid; ++i) {
    for (int d = 0; d < Dim; ++d) {
      const double u = particles.velocity[d][i];
      energy += 0.5 * u * u - particles.gravity[d] * particles.position[d][i];
    }
  }
  energy_ = energy_initial_ = energy_lowest_ = energy * particles.scene.density * particles.volume;
}

template <int Dim>
void ParticleMotion<Dim>::report(RunSummary& summary) const {
  summary.penetrations = penetrations_;
  summary.compression_max = compression_max_;
  summary.compression_p95 = compression_p95_;
  summary.energy_initial = energy_initial_;
  summary.energy_final = energy_;
  summary.energy_gain_max = energy_gain_max_;
}

template class ParticleMotion<2>;
template class ParticleMotion<3>;

}  // namespace eisph
