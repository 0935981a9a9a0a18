#include "scheme/incompressible_scheme.hpp"
#include "scheme/schemes.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

namespace {

/// The explicit incompressible SPH scheme (De Castro 2019, section 3.3): one Jacobi sweep per step of the
/// pressure equation, started from the pressures of the step before.
///
/// The default stepping is symplectic: x += dt u^{n+1}, so that positions are half a step ahead of the
/// velocities and are brought back for every snapshot; the divergence that drives the pressure is that of
/// omega u^n + dt a with omega = 3, which raises the speed of sound of the sweep by sqrt(3). The thesis's
/// stepping is x += dt (u^n + u^{n+1})/2 with omega = 1.
template <int Dim>
class EisphScheme final : public IncompressibleScheme<Dim> {
 public:
  EisphScheme(const Scene& scene, int threads)
      : IncompressibleScheme<Dim>(scene, threads, scene.scheme.pressure_sweeps > 1) {}

  void set_parameters(const RunningParameters& parameters) override {
    IncompressibleScheme<Dim>::set_parameters(parameters);
    this->particles_.scene.scheme.pressure_sweeps = parameters.pressure_sweeps;
    this->equation_.keep_source(parameters.pressure_sweeps > 1);
  }

 private:
  void take_step(const StepInHand& step) override {
    this->find_neighbourhood(step);
    pressure_step_ = std::max(step.time_step, pressure_step_ / kLargestChange);
    this->clock_.start(Stage::Acceleration);
    this->equation_.set_source(pressure_step_);
    this->clock_.start(Stage::Pressure);
    this->equation_.relax(pressure_step_);
    for (int sweep = 1; sweep < this->particles_.scene.scheme.pressure_sweeps; ++sweep) {
      this->equation_.sweep_again();
    }
    this->equation_.correct_volume(pressure_step_);
    this->equation_.publish(true);
    this->clock_.start(Stage::Gradient);
    this->apply_gradient(step, pressure_step_);
  }

  [[nodiscard]] double admissible_time_step() const override {
    const double step = IncompressibleScheme<Dim>::admissible_time_step();
    return pressure_step_ > 0.0 ? std::min(step, kLargestChange * pressure_step_) : step;
  }

  /// One sweep with persistent pressure is artificial compressibility.
  [[nodiscard]] double sound_speed(double time_step) const override {
    const ParticleSystem<Dim>& p = this->particles_;
    return std::sqrt(p.scene.scheme.source_factor / p.lattice.laplacian) * p.h / time_step;
  }

  [[nodiscard]] double planned_bytes() const override { return 4.0; }

  /// The step that the pressure equation reckons with, s. The sweep's speed of sound goes with its inverse:
  /// in a step cut short for an output that follows another closely, every bit of noise in the divergence
  /// would become a blow of pressure, which the next, long step would let act in full.
  double pressure_step_ = 0.0;
  static constexpr double kLargestChange = 4.0;  ///< of that step, up or down, as a factor
};

}  // namespace

std::unique_ptr<Simulation> make_eisph(const Scene& scene, int threads) {
  return make_particle_scheme<EisphScheme>(scene, threads);
}

}  // namespace eisph
