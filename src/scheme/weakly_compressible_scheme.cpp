#include "scheme/equation_of_state.hpp"
#include "scheme/particle_scheme.hpp"
#include "scheme/pressure_equation.hpp"
#include "scheme/schemes.hpp"
#include "scheme/solid_field.hpp"
#include "scheme/time_step.hpp"
#include "sph/gradient_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 512;

enum class Diffusion { None, Plain, Renormalised };

/// A stage of an explicit Runge-Kutta method: the state that it starts from and its weight in the step.
struct RungeKuttaStage {
  double advance;  ///< of the state along the rates of the stage before, in steps
  double weight;
};
constexpr std::array<RungeKuttaStage, 2> kMidpoint = {{{0.0, 0.0}, {0.5, 1.0}}};
constexpr std::array<RungeKuttaStage, 4> kClassical = {
    {{0.0, 1.0 / 6.0}, {0.5, 1.0 / 3.0}, {0.5, 1.0 / 3.0}, {1.0, 1.0 / 6.0}}};

/// Weakly compressible SPH: the compression s = rho/rho0 - 1 follows from the divergence of the velocity,
///   ds/dt = -(1 + s) sum V_j (u_j - u_i) . grad W_ij + D,
/// and the pressure from s. Sums use the volume of water at rest, which conserves momentum and differs from
/// that of the moment by s, below 1 %. D is nothing, or the density diffusion of delta-SPH,
/// delta h c0 times DiffusionSum. Solids have the velocity and the pressure that SolidField finds for them.
///
/// Symplectic stepping is the leap-frog: viscosity and continuity with u^n, then the pressure gradient with
/// the new s. The others keep neighbour lists and images over the stages of a step and move only rows.
template <int Dim>
class WeaklyCompressibleScheme : public ParticleScheme<Dim> {
 protected:
  WeaklyCompressibleScheme(const Scene& scene, int threads, double gamma, Diffusion diffusion)
      : ParticleScheme<Dim>(scene, threads),
        state_{scene.density, scene.scheme.sound_speed, gamma, scene.scheme.clamp_pressure},
        solids_(this->particles_),
        diffusion_(diffusion) {}

 private:
  using Components = std::array<double, Dim>;

  void find_initial_state() override;
  void take_step(const StepInHand& step) override;
  [[nodiscard]] double admissible_time_step() const override;
  [[nodiscard]] double sound_speed(double) const override { return state_.sound_speed; }
  void add_bytes(std::map<std::string, double>& by_array) const override {
    const std::size_t bytes =
        rate_.bytes() + start_.bytes() + velocity_sum_.bytes() + rate_sum_.bytes() + crowded_.size();
    by_array["rates"] += static_cast<double>(bytes + solids_.bytes());
  }
  [[nodiscard]] double planned_bytes() const override {
    return this->positions_lead() ? sizeof(Float4) : 4.0 * sizeof(Float4);
  }

  void leap_frog(const StepInHand& step);
  void runge_kutta(const StepInHand& step, std::span<const RungeKuttaStage> stages);
  void start_stage(double time);
  void add_stage(double weight);

  void prepare_sources();
  void find_density_gradients();
  template <Diffusion D>
  void find_rates();
  void find_rates();
  void add_pressure_gradient();
  void publish_pressure();
  [[nodiscard]] Components table_position(std::uint32_t row) const {
    Components at;
    for (int d = 0; d < Dim; ++d) at[d] = this->particles_.h * (&this->particles_.table.position[row].x)[d];
    return at;
  }

  /// None on the free surface: what the few neighbours of spray make of its density is noise, that throws
  /// particles about when they fall back.
  [[nodiscard]] float kept_compression(std::size_t i, double compression) const {
    const bool free =
        this->particles_.number_density[i] < this->particles_.scene.scheme.free_surface_threshold;
    return free ? 0.0F : static_cast<float>(compression);
  }

  EquationOfState state_;
  SolidField<Dim> solids_;
  Diffusion diffusion_;
  AlignedBuffer<Float4> rate_;  ///< x, y, z: acceleration, m/s^2; w: ds/dt, 1/s
  // Of Runge-Kutta methods: velocity and s at the beginning of the step, and weighted sums over its stages.
  AlignedBuffer<Float4> start_;
  AlignedBuffer<Float4> velocity_sum_;
  AlignedBuffer<Float4> rate_sum_;
  std::vector<std::uint8_t> crowded_;  ///< PressureTerms::crowded of the last stage
};

template <int Dim>
void WeaklyCompressibleScheme<Dim>::find_initial_state() {
  ParticleSystem<Dim>& p = this->particles_;
  PressureEquation<Dim>(p, true).find_initial_pressure();
  for (std::uint32_t i = 0; i < p.fluid; ++i) {
    p.carried[i] = static_cast<float>(state_.compression(p.carried[i]));
  }
}

/// dt = courant h / (c0 + Umax), and the limits of viscosity and diffusion.
template <int Dim>
double WeaklyCompressibleScheme<Dim>::admissible_time_step() const {
  const ParticleSystem<Dim>& p = this->particles_;
  const SchemeSettings& scheme = p.scene.scheme;
  if (scheme.time_step_mode == TimeStepMode::Fixed) return scheme.time_step;
  const double speed = std::max(p.scene.expected_speed(), p.speed_max);
  double step = scheme.courant * p.h / (state_.sound_speed + speed);
  if (p.is_viscous()) step = std::min(step, viscous_time_step(p.scene, p.lattice));
  return step;
}

template <int Dim>
void WeaklyCompressibleScheme<Dim>::take_step(const StepInHand& step) {
  this->find_neighbourhood(step);
  this->clock_.start(Stage::Acceleration);
  rate_.resize(this->particles_.fluid);
  prepare_sources();
  switch (this->particles_.scene.scheme.stepping) {
    case Stepping::PredictorCorrector:
      return runge_kutta(step, kMidpoint);
    case Stepping::RungeKutta:
      return runge_kutta(step, kClassical);
    case Stepping::Symplectic:
    case Stepping::Thesis:
      break;
  }
  leap_frog(step);
}

template <int Dim>
void WeaklyCompressibleScheme<Dim>::leap_frog(const StepInHand& step) {
  ParticleSystem<Dim>& p = this->particles_;
  const double time_step = step.time_step;
  find_rates();
  this->clock_.start(Stage::Pressure);
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const float compression = p.table.position[p.fluid_row(i)].w;
      p.carried[i] = kept_compression(i, compression + time_step * rate_[i].w);
      p.pressure[i] = static_cast<float>(state_.pressure(p.carried[i]));
    }
  });
  publish_pressure();
  this->clock_.start(Stage::Gradient);
  p.count_pass();
  const double drift = step.leading_drift();
  this->motion_.advance(p, step, 0.5 * time_step,
                        [&](std::size_t i, const Neighbours& near, auto& position, auto& velocity) {
                          const std::uint32_t row = p.fluid_row(i);
                          const PressureTerms<Dim> push = pressure_terms(p, row, near);
                          for (int d = 0; d < Dim; ++d) {
                            const double acceleration = (&rate_[i].x)[d] + push.acceleration.x[d];
                            velocity[d] = (&p.table.velocity[row].x)[d] + time_step * acceleration;
                            position[d] = p.position[d][i] + drift * velocity[d];
                          }
                          return push.crowded;
                        });
}

template <int Dim>
void WeaklyCompressibleScheme<Dim>::runge_kutta(const StepInHand& step,
                                                std::span<const RungeKuttaStage> stages) {
  ParticleSystem<Dim>& p = this->particles_;
  for (AlignedBuffer<Float4>* array : {&start_, &velocity_sum_, &rate_sum_}) array->resize(p.fluid);
  crowded_.resize(p.fluid);
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      start_[i] = p.table.velocity[p.fluid_row(i)];
      start_[i].w = p.table.position[p.fluid_row(i)].w;
      velocity_sum_[i] = {};
      rate_sum_[i] = {};
    }
  });
  for (const RungeKuttaStage& stage : stages) {
    this->clock_.start(Stage::Acceleration);
    if (stage.advance > 0.0) start_stage(stage.advance * step.time_step);
    find_rates();
    this->clock_.start(Stage::Pressure);
    p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t i = first; i < last; ++i) {
        p.pressure[i] = static_cast<float>(state_.pressure(p.table.position[p.fluid_row(i)].w));
      }
    });
    publish_pressure();
    this->clock_.start(Stage::Gradient);
    add_pressure_gradient();
    if (stage.weight > 0.0) add_stage(stage.weight);
  }
  const double time_step = step.time_step;
  this->motion_.advance(p, step, 0.0, [&](std::size_t i, const Neighbours&, auto& position, auto& velocity) {
    for (int d = 0; d < Dim; ++d) {
      velocity[d] = (&start_[i].x)[d] + time_step * (&rate_sum_[i].x)[d];
      position[d] = p.position[d][i] + time_step * (&velocity_sum_[i].x)[d];
    }
    p.carried[i] = kept_compression(i, start_[i].w + time_step * rate_sum_[i].w);
    p.pressure[i] = static_cast<float>(state_.pressure(p.carried[i]));
    return crowded_[i] != 0;
  });
}

/// The state `time` after the beginning of the step along the rates of the stage before.
template <int Dim>
void WeaklyCompressibleScheme<Dim>::start_stage(double time) {
  ParticleSystem<Dim>& p = this->particles_;
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      Float4& xi = p.table.position[p.fluid_row(i)];
      Float4& velocity = p.table.velocity[p.fluid_row(i)];
      for (int d = 0; d < Dim; ++d) {
        (&xi.x)[d] = static_cast<float>((p.position[d][i] + time * (&velocity.x)[d]) / p.h);
        (&velocity.x)[d] = static_cast<float>((&start_[i].x)[d] + time * (&rate_[i].x)[d]);
      }
      xi.w = static_cast<float>(start_[i].w + time * rate_[i].w);
    }
  });
  p.mirror_motion();
  prepare_sources();
}

template <int Dim>
void WeaklyCompressibleScheme<Dim>::add_stage(double weight) {
  ParticleSystem<Dim>& p = this->particles_;
  const auto add = [&](Float4& sum, const Float4& term) {
    const auto factor = static_cast<float>(weight);
    sum = {sum.x + factor * term.x, sum.y + factor * term.y, sum.z + factor * term.z,
           sum.w + factor * term.w};
  };
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      add(velocity_sum_[i], p.table.velocity[p.fluid_row(i)]);
      add(rate_sum_[i], rate_[i]);
    }
  });
}

/// Velocities of solids, and source rows: the volumes, and with renormalised diffusion the gradients of s per
/// smoothing length. With diffusion the compression of solids stands where that of the fluid does, as w of
/// the positions.
template <int Dim>
void WeaklyCompressibleScheme<Dim>::prepare_sources() {
  ParticleSystem<Dim>& p = this->particles_;
  const auto volume = static_cast<float>(p.volume);
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) p.table.source[p.fluid_row(i)] = {0.0F, 0.0F, 0.0F, volume};
  });
  p.mirror_source();
  solids_.find_weights();
  solids_.set_velocities();
  if (diffusion_ == Diffusion::None) return;
  // Beside a solid the gradient is that of water at rest.
  const double per_length = p.h / (state_.sound_speed * state_.sound_speed);
  p.pool.run_blocks(p.objects(), 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t row = p.object_row(k);
      p.table.position[row].w = static_cast<float>(state_.compression(p.kept_object_pressure(k)));
      for (int d = 0; d < Dim; ++d) {
        (&p.table.source[row].x)[d] = static_cast<float>(per_length * p.gravity[d]);
      }
    }
  });
  p.mirror_pressure();
  if (diffusion_ == Diffusion::Renormalised) find_density_gradients();
}

/// Gradients of s, and the diffusion built on them, leave the images of the fluid out: these have its
/// pressure, not that of water which goes on beneath the floor, and a fold in the hydrostatic pressure is no
/// noise.
template <int Dim>
void WeaklyCompressibleScheme<Dim>::find_density_gradients() {
  ParticleSystem<Dim>& p = this->particles_;
  const SourceTable& table = p.table;
  const Pack fluid_volume = splat<Pack>(p.volume);
  p.count_pass();
  // Rates are free until find_rates().
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t row = p.fluid_row(i);
      const Neighbours near = p.neighbours.of(row);
      const Pack own = splat<Pack>(table.position[row].w);
      MomentSum<Dim, Pack> moments;
      ScalarGradientSum<Dim, Pack> sum;
      for_neighbours<Dim>(p, row, near, [&](const std::uint32_t* j, const auto& pair, const Pack& other) {
        Pack volume = near.near_object ? gather_rows(table.source.data(), j).w : fluid_volume;
        volume *= ones_below(j, table.first_image);
        moments.add(pair, volume);
        sum.add(pair, volume, other - own);
      });
      const GradientCorrection<Dim> correction(moments, p.alpha);
      const auto gradient = correction.gradient(sum);
      Float4 result{0.0F, 0.0F, 0.0F, static_cast<float>(p.volume)};
      if (correction.regular()) {
        for (int d = 0; d < Dim; ++d) (&result.x)[d] = static_cast<float>(gradient[d]);
      }
      rate_[i] = result;
    }
  });
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) p.table.source[p.fluid_row(i)] = rate_[i];
  });
  p.mirror_source_gradients();
}

template <int Dim>
void WeaklyCompressibleScheme<Dim>::find_rates() {
  switch (diffusion_) {
    case Diffusion::None:
      return find_rates<Diffusion::None>();
    case Diffusion::Plain:
      return find_rates<Diffusion::Plain>();
    case Diffusion::Renormalised:
      return find_rates<Diffusion::Renormalised>();
  }
}

/// Acceleration without pressure, ds/dt and the number density, in one pass over the neighbours.
template <int Dim>
template <Diffusion D>
void WeaklyCompressibleScheme<Dim>::find_rates() {
  ParticleSystem<Dim>& p = this->particles_;
  const SourceTable& table = p.table;
  const double diffusive = -2.0 * p.scene.scheme.diffusion * state_.sound_speed * p.alpha / p.h;
  const double push = repulsion_scale(p);
  const Pack fluid_volume = splat<Pack>(p.volume);
  p.count_pass();
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t row = p.fluid_row(i);
      const Neighbours near = p.neighbours.of(row);
      const auto u = splat_row<Dim>(table.velocity[row]);
      const Pack own = splat<Pack>(table.position[row].w);
      const auto own_gradient = splat_row<Dim>(table.source[row]);
      ViscousTerms<Dim> viscous(p);
      DivergenceSum<Pack> divergence;
      DensitySum<Pack> density;
      DiffusionSum<Pack> diffusion;
      for_neighbours<Dim>(p, row, near, [&](const std::uint32_t* j, const auto& pair, const Pack& other) {
        const PackRows velocities = gather_rows(table.velocity.data(), j);
        const auto others = components<Dim>(velocities);
        Pack volume = fluid_volume;
        if constexpr (D == Diffusion::Renormalised) {
          const PackRows sources = gather_rows(table.source.data(), j);
          volume = sources.w;
          auto gradients = components<Dim>(sources);
          for (int d = 0; d < Dim; ++d) gradients.x[d] += own_gradient.x[d];
          diffusion.add(pair, volume * ones_below(j, table.first_image), other - own, gradients);
        } else {
          if (near.near_object) volume = gather_rows(table.source.data(), j).w;
          if constexpr (D == Diffusion::Plain) diffusion.add(pair, volume, other - own);
        }
        viscous.add(pair, velocities, u);
        divergence.add(pair, volume, u, others);
        density.add(pair, volume);
      });
      Components acceleration = p.gravity;
      const Vector<Dim, double> drag = viscous.acceleration();
      for (int d = 0; d < Dim; ++d) acceleration[d] += drag.x[d];
      add_repulsion<Dim>(p, table_position(row), near.near_object, push, acceleration);
      Float4 rate;
      for (int d = 0; d < Dim; ++d) (&rate.x)[d] = static_cast<float>(acceleration[d]);
      const double opening = p.alpha / p.h * horizontal_sum(divergence.value);
      rate.w = static_cast<float>(-(1.0 + table.position[row].w) * opening +
                                  diffusive * horizontal_sum(diffusion.value));
      rate_[i] = rate;
      p.number_density[i] = static_cast<float>(
          (p.own_number_density() + p.alpha * horizontal_sum(density.value)) / p.lattice.number_density);
    }
  });
}

/// Puts the pressures of the fluid into the table, and from them those of the solids.
template <int Dim>
void WeaklyCompressibleScheme<Dim>::publish_pressure() {
  ParticleSystem<Dim>& p = this->particles_;
  p.pool.run_blocks(p.fluid, 8 * kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) p.table.position[p.fluid_row(i)].w = p.pressure[i];
  });
  p.mirror_pressure();
  solids_.extrapolate();
}

template <int Dim>
void WeaklyCompressibleScheme<Dim>::add_pressure_gradient() {
  ParticleSystem<Dim>& p = this->particles_;
  p.count_pass();
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t row = p.fluid_row(i);
      const PressureTerms<Dim> push = pressure_terms(p, row, p.neighbours.of(row));
      for (int d = 0; d < Dim; ++d) (&rate_[i].x)[d] += static_cast<float>(push.acceleration.x[d]);
      crowded_[i] = push.crowded ? 1 : 0;
    }
  });
}

template <int Dim>
class Wcsph final : public WeaklyCompressibleScheme<Dim> {
 public:
  Wcsph(const Scene& scene, int threads)
      : WeaklyCompressibleScheme<Dim>(scene, threads, 7.0, Diffusion::None) {}
};

template <int Dim>
class DeltaSph final : public WeaklyCompressibleScheme<Dim> {
 public:
  DeltaSph(const Scene& scene, int threads)
      : WeaklyCompressibleScheme<Dim>(scene, threads, 1.0,
                                      scene.scheme.diffusion_form == DensityDiffusion::Plain
                                          ? Diffusion::Plain
                                          : Diffusion::Renormalised) {}
};

}  // namespace

std::unique_ptr<Simulation> make_wcsph(const Scene& scene, int threads) {
  return make_particle_scheme<Wcsph>(scene, threads);
}

std::unique_ptr<Simulation> make_delta_sph(const Scene& scene, int threads) {
  return make_particle_scheme<DeltaSph>(scene, threads);
}

}  // namespace eisph
