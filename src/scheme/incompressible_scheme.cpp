#include "scheme/incompressible_scheme.hpp"

namespace eisph {

template <int Dim>
void IncompressibleScheme<Dim>::apply_gradient(const StepInHand& step, double source_step) {
  ParticleSystem<Dim>& p = this->particles_;
  const double time_step = step.time_step;
  const double omega = p.scene.scheme.source_factor;
  const double part = time_step / source_step;
  const bool lead = this->positions_lead();
  const double drift = step.leading_drift();
  p.count_pass();
  this->motion_.advance(p, step, lead ? 0.5 * time_step : 0.0,
                        [&](std::size_t i, const Neighbours& near, auto& position, auto& velocity) {
                          const std::uint32_t row = p.fluid_row(i);
                          PressureTerms<Dim> terms = pressure_terms(p, row, near);
                          if (const Float4* viscous = equation_.viscous(i)) {
                            for (int d = 0; d < Dim; ++d) terms.acceleration.x[d] += (&viscous->x)[d];
                          }
                          const float* before = &p.table.velocity[row].x;
                          const float* source = &p.table.source[row].x;
                          for (int d = 0; d < Dim; ++d) {
                            const double predicted = before[d] + part * (source[d] - omega * before[d]);
                            velocity[d] = predicted + time_step * terms.acceleration.x[d];
                            const double moved =
                                lead ? drift * velocity[d] : 0.5 * time_step * (before[d] + velocity[d]);
                            position[d] = p.position[d][i] + moved;
                          }
                          return terms.crowded;
                        });
}

template class IncompressibleScheme<2>;
template class IncompressibleScheme<3>;

}  // namespace eisph
