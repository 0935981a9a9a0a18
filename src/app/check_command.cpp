#include "app/commands.hpp"
#include "app/scene_report.hpp"
#include "core/error.hpp"
#include "io/scene_file.hpp"

#include <ostream>

#include <fmt/ostream.h>

namespace eisph {

int check_command(const CheckOptions& options, std::ostream& out) {
  // Asked before the particles are placed: what they take is part of the estimate.
  const std::uint64_t available_memory = available_memory_bytes();
  const Scene scene = load_scene(options.scene, options.overrides, available_memory);
  const std::unique_ptr<Simulation> simulation = Simulation::create(scene, options.threads);
  const SimulationPlan plan = simulation->plan();
  fmt::print(out, "{}", scene_report(scene, plan, available_memory));
  if (plan.cell_size == 0.0) fmt::print(out, "{}", fit_report(simulation->initial_fit()));
  for (const std::string& warning : scene_warnings(scene, plan)) fmt::print(out, "warning: {}\n", warning);
  return kSuccess;
}

}  // namespace eisph
