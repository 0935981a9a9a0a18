#include "scheme/simulation.hpp"

#include "core/error.hpp"
#include "scheme/eisph_solver.hpp"
#include "scheme/shallow_water_solver.hpp"

namespace eisph {

std::unique_ptr<Simulation> Simulation::create(const Scene& scene, int threads) {
  if (scene.scheme.name == "shallow_water") return std::make_unique<ShallowWaterSolver>(scene, threads);
  if (scene.scheme.name != "eisph") {
    throw InputError(scene.source_file + ": scheme.name = \"" + scene.scheme.name +
                     "\": accepted are \"eisph\", \"shallow_water\"");
  }
  if (scene.dimension == 2) return std::make_unique<EisphSolver<2>>(scene, threads);
  return std::make_unique<EisphSolver<3>>(scene, threads);
}

}  // namespace eisph
