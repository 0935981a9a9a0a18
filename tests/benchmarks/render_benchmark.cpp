// CPU time of 1280 x 720 frames of 576,000 particles, PNG file included: the half tank at 5 mm, once as a
// column behind the dam and once spread over the whole floor, which shows the most particles. Beside it its
// parts, and the water surface of the same states, at 1920 x 1080 too. LP_NUM_THREADS in the environment
// chooses the threads of the software renderer.

#include "render/frame_renderer.hpp"
#include "render/ground_shadow.hpp"
#include "render/particle_culling.hpp"
#include "render/png_file.hpp"
#include "render/synthetic_scene.hpp"

#include <cmath>
#include <filesystem>
#include <memory>

#include <benchmark/benchmark.h>

namespace {

using namespace eisph;

constexpr double kSpacing = 0.005;
constexpr int kParticles = 576'000;

/// Water over `columns` x 120 lattice columns, with a wavy surface and no order within a quarter of the
/// spacing.
synthetic::State water(int columns) {
  synthetic::State state;
  state.scene = synthetic::tank_scene(kSpacing, true);
  state.snapshot.time = 0.4;
  state.snapshot.particle_spacing = kSpacing;
  state.snapshot.objects = std::make_shared<ObjectParticles>();
  const double layers = static_cast<double>(kParticles) / (120.0 * columns);
  std::uint32_t random = 1;
  const auto noise = [&] {
    return 0.25 * (static_cast<double>((random = random * 1664525U + 1013904223U) >> 8U) / 16777216.0 - 0.5);
  };
  for (int j = 0; j < 120; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double height = layers * (1.0 + 0.2 * std::sin(0.05 * i) * std::cos(0.07 * j));
      for (int k = 0; k < static_cast<int>(height + 0.5); ++k) {
        const Vec3d place = kSpacing * Vec3d(i + 0.5 + noise(), j + 0.5 + noise(), k + 0.5 + noise());
        synthetic::add_particle(state, place, {std::sin(5.0 * place.x()), 0.1, 0.0},
                                9810.0 * (0.15 - place.z()));
      }
    }
  }
  synthetic::fill_depth(state, 0.0075);
  return state;
}

void frame_with_png(benchmark::State& run) {
  const synthetic::State state = water(static_cast<int>(run.range(0)));
  ParticlePictureOptions options;
  options.cull_interior = run.range(1) != 0;
  FrameRenderer renderer(state.scene, options);
  const ImageSettings settings;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "eisph_render_benchmark.png";
  const Image first = renderer.draw(settings, state.snapshot, state.depth);
  benchmark::DoNotOptimize(first.rgb.data());
  for (auto _ : run)
    write_png(file, renderer.draw(settings, state.snapshot, state.depth), {{"Title", "benchmark"}});
  std::filesystem::remove(file);
  run.counters["particles"] = static_cast<double>(state.snapshot.size());
}
BENCHMARK(frame_with_png)
    ->ArgNames({"columns", "culled"})
    ->Args({160, 1})
    ->Args({160, 0})
    ->Args({520, 1})
    ->Args({520, 0})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// The particle view and the water surface of one state, PNG file included, as medians.
void styled_frame(benchmark::State& run) {
  const synthetic::State state = water(static_cast<int>(run.range(0)));
  FrameRenderer renderer(state.scene);
  ImageSettings settings;
  settings.height = static_cast<int>(run.range(1));
  settings.width = settings.height * 16 / 9;
  if (run.range(2) != 0) {
    settings.style = WaterStyle::Surface;
    settings.field = "water";
  }
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "eisph_style_benchmark.png";
  const Image first = renderer.draw(settings, state.snapshot, state.depth);
  benchmark::DoNotOptimize(first.rgb.data());
  for (auto _ : run)
    write_png(file, renderer.draw(settings, state.snapshot, state.depth), {{"Title", "benchmark"}});
  std::filesystem::remove(file);
}
BENCHMARK(styled_frame)
    ->ArgNames({"columns", "height", "surface"})
    ->ArgsProduct({{160, 520}, {720, 1080}, {0, 1}})
    ->Iterations(1)
    ->Repetitions(5)
    ->ReportAggregatesOnly(true)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void ground_shadow(benchmark::State& run) {
  const synthetic::State state = water(520);
  for (auto _ : run)
    benchmark::DoNotOptimize(ground_light(state.scene, state.snapshot, true, 0.3).light.data());
}
BENCHMARK(ground_shadow)->Unit(benchmark::kMillisecond);

void culling(benchmark::State& run) {
  const synthetic::State state = water(static_cast<int>(run.range(0)));
  const Camera camera = default_camera(state.scene, 720, 1280, 560);
  const CameraView view(camera, 720, 1280, 560, drawn_bounds(state.scene));
  std::size_t kept = 0;
  for (auto _ : run) kept = visible_particles(state.snapshot, view, 0.0).size();
  run.counters["kept"] = static_cast<double>(kept);
}
BENCHMARK(culling)->ArgName("columns")->Arg(160)->Arg(520)->Unit(benchmark::kMillisecond);

void depth_map_frame(benchmark::State& run) {
  const synthetic::State state = synthetic::tank(0.02);
  FrameRenderer renderer(state.scene);
  ImageSettings settings;
  settings.kind = ImageKind::DepthMap;
  settings.colour_map = "depth_blue";
  for (auto _ : run) {
    const Image frame = renderer.draw(settings, state.snapshot, state.depth);
    benchmark::DoNotOptimize(frame.rgb.data());
  }
}
BENCHMARK(depth_map_frame)->Unit(benchmark::kMillisecond);

}  // namespace
