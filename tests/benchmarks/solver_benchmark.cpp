// Time of a solver step in space: a column with a free surface that has just been released, on the way along
// a tank with walls and an obstacle. Counters give nanoseconds of wall clock per particle and step, by stage;
// items are particle-steps. The neighbour search alone stands beside it.

#include "scheme/particle_system.hpp"
#include "scheme/simulation.hpp"

#include <cmath>
#include <memory>

#include <benchmark/benchmark.h>

namespace {

using namespace eisph;

/// Water of 2 : 1.5 : 1 in length, width and depth with about the given number of particles, in a tank twice
/// as long, and an obstacle in its way.
Scene column(double particles) {
  const auto layers = std::round(std::cbrt(particles / 3.0));
  const double spacing = 0.2 / layers;
  const Vec3d water(std::round(2.0 * layers) * spacing, std::round(1.5 * layers) * spacing, layers * spacing);
  Scene scene;
  scene.name = "benchmark";
  scene.particle_spacing = spacing;
  scene.reference_depth = water.z();
  scene.domain_max = Vec3d(2.0 * water.x(), water.y(), 2.0 * water.z());
  scene.end_time = 10.0;
  FluidRegion region;
  region.shape.max = water;
  scene.fluid.push_back(region);
  Obstacle obstacle;
  obstacle.name = "obstacle";
  obstacle.shape.min = Vec3d(1.4 * water.x(), 0.4 * water.y(), 0.0);
  obstacle.shape.max = Vec3d(1.6 * water.x(), 0.6 * water.y(), water.z());
  scene.obstacles.push_back(obstacle);
  return scene;
}

constexpr int kWarmUpSteps = 20;

void solver_step(benchmark::State& run) {
  const Scene scene = column(static_cast<double>(run.range(0)));
  const auto simulation = Simulation::create(scene, static_cast<int>(run.range(1)));
  simulation->initialise();
  for (int step = 0; step < kWarmUpSteps; ++step) simulation->step(1e3);
  const RunSummary before = simulation->summary();
  for (auto _ : run) simulation->step(1e3);
  const RunSummary after = simulation->summary();
  const auto particles = static_cast<double>(after.fluid_particles);
  const auto steps = static_cast<double>(after.steps - before.steps);
  run.SetItemsProcessed(static_cast<std::int64_t>(particles * steps));
  for (const auto& [stage, nanoseconds] : after.stage_ns_per_particle_step) {
    const double earlier = before.stage_ns_per_particle_step.at(stage) * static_cast<double>(before.steps);
    run.counters[stage] = (nanoseconds * static_cast<double>(after.steps) - earlier) / steps;
  }
  run.counters["particles"] = particles;
  run.counters["bytes_per_particle"] = after.state_bytes_per_particle;
}
BENCHMARK(solver_step)
    ->ArgNames({"particles", "threads"})
    ->Args({20'000, 1})
    ->Args({20'000, 2})
    ->Args({140'000, 1})
    ->Args({140'000, 2})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// A step of the shallow-water scheme for the same column, in 240,000 cells; items are cell-steps.
void shallow_water_step(benchmark::State& run) {
  Scene scene = column(1000.0);
  scene.scheme.name = "shallow_water";
  scene.shallow_water.cell_size = scene.domain_max.y() / 346.0;
  scene.domain_max.x() = scene.shallow_water.cell_size * 692.0;
  const auto simulation = Simulation::create(scene, static_cast<int>(run.range(0)));
  simulation->initialise();
  for (int step = 0; step < kWarmUpSteps; ++step) simulation->step(1e3);
  const std::uint64_t before = simulation->steps();
  for (auto _ : run) simulation->step(1e3);
  const auto steps = static_cast<double>(simulation->steps() - before);
  run.SetItemsProcessed(
      static_cast<std::int64_t>(steps * static_cast<double>(simulation->fluid_particles())));
}
BENCHMARK(shallow_water_step)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void neighbour_search(benchmark::State& run) {
  const Scene scene = column(static_cast<double>(run.range(0)));
  ParticleSystem<3> system(scene, static_cast<int>(run.range(1)));
  system.sort_fluid();
  system.place_boundaries(0.0);
  for (auto _ : run) system.find_neighbours();
  const auto particles = static_cast<double>(system.fluid);
  run.SetItemsProcessed(static_cast<std::int64_t>(particles * static_cast<double>(run.iterations())));
  std::size_t entries = 0;
  const SourceTable& table = system.table;
  for (std::uint32_t row = table.first_fluid; row < table.first_image; ++row) {
    const Neighbours near = system.neighbours.of(row);
    entries += static_cast<std::size_t>(near.end - near.begin);
  }
  run.counters["entries_per_list"] = static_cast<double>(entries) / particles;
}
BENCHMARK(neighbour_search)
    ->ArgNames({"particles", "threads"})
    ->Args({20'000, 1})
    ->Args({20'000, 2})
    ->Args({140'000, 1})
    ->Args({140'000, 2})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
