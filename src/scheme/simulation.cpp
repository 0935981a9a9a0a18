#include "scheme/simulation.hpp"

#include "core/error.hpp"
#include "scheme/schemes.hpp"

#include <fmt/format.h>

namespace eisph {

namespace {

struct Registration {
  const char* name;  ///< value of the scene key scheme.name
  std::unique_ptr<Simulation> (*make)(const Scene& scene, int threads);
};

#define EISPH_REGISTER(name, meaning) {#name, make_##name},
constexpr Registration kSchemes[] = {EISPH_SCHEMES(EISPH_REGISTER)};
#undef EISPH_REGISTER

}  // namespace

RunningParameters running_parameters(const Scene& scene) {
  RunningParameters parameters;
  parameters.kinematic_viscosity = scene.kinematic_viscosity;
  parameters.artificial_viscosity = scene.artificial_viscosity;
  parameters.pressure_sweeps = scene.scheme.pressure_sweeps;
  if (scene.scheme.name == "shallow_water") {
    parameters.step_factor = scene.shallow_water.courant;
  } else {
    parameters.step_factor = scene.scheme.weakly_compressible() ? scene.scheme.courant : scene.scheme.phi;
  }
  return parameters;
}

std::unique_ptr<Simulation> Simulation::create(const Scene& scene, int threads) {
  std::string accepted;
  for (const Registration& scheme : kSchemes) {
    if (scene.scheme.name == scheme.name) return scheme.make(scene, threads);
    accepted += fmt::format("{}\"{}\"", accepted.empty() ? "" : ", ", scheme.name);
  }
  throw InputError(fmt::format("{}: scheme.name = \"{}\": accepted are {}", scene.source_file,
                               scene.scheme.name, accepted));
}

}  // namespace eisph
