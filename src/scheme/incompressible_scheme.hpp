#pragma once

#include "scheme/particle_scheme.hpp"
#include "scheme/pressure_equation.hpp"
#include "scheme/time_step.hpp"

#include <array>
#include <map>
#include <string>

namespace eisph {

/// What EISPH and ISPH share: velocities without pressure, a pressure equation, and the correction of the
/// velocities by its gradient. All operators use the positions at the beginning of the step.
template <int Dim>
class IncompressibleScheme : public ParticleScheme<Dim> {
 public:
  IncompressibleScheme(const Scene& scene, int threads, bool keeps_source)
      : ParticleScheme<Dim>(scene, threads), equation_(this->particles_, keeps_source) {}

 protected:
  void find_initial_state() override { equation_.find_initial_pressure(); }
  [[nodiscard]] double admissible_time_step() const override {
    const ParticleSystem<Dim>& p = this->particles_;
    return eisph::admissible_time_step(p.scene, p.lattice, p.speed_max);
  }
  void add_bytes(std::map<std::string, double>& by_array) const override {
    by_array["density_and_coefficient"] += static_cast<double>(equation_.bytes());
  }

  /// u^{n+1} = u* - (dt/rho0) sum V_j (P_i + P_j) grad W_ij, and the new positions: x += dt u^{n+1}, half a
  /// step ahead of time, or with the stepping of the thesis x += dt (u^n + u^{n+1})/2.
  /// Without viscosity in the source, u* has none either, and the viscous term that relax() found on the way
  /// is added here.
  /// `source_step` is the time step with which the sources were set.
  void apply_gradient(const StepInHand& step, double source_step);

  PressureEquation<Dim> equation_;
};

}  // namespace eisph
