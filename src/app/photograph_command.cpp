#include "app/commands.hpp"
#include "app/comparison/comparison_report.hpp"
#include "app/comparison/photograph_set.hpp"
#include "app/comparison/run_depths.hpp"
#include "app/comparison/synthetic_settings.hpp"
#include "compare/synthetic_photograph.hpp"
#include "core/error.hpp"
#include "core/scene_mirror.hpp"
#include "io/comparison_file.hpp"
#include "io/file_io.hpp"
#include "render/grey_png.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

namespace eisph {

namespace {

constexpr double kMillimetre = 0.001;
constexpr double kPickStep = 0.01;            ///< pixels, to which reference points are written
constexpr unsigned kFirstCalibration = 1000;  ///< number of the first photograph of still water

/// The finest depths that a run has: cells of the shallow-water solver, or the free surface of particles.
DeviationSettings finest_depth(const Scene& scene) {
  DeviationSettings settings;
  settings.depth_rule = DepthRule::Surface;
  if (scene.scheme.name == "shallow_water") settings.cell_size = scene.shallow_water.cell_size;
  return settings;
}

std::vector<double> chosen_times(const RunDepths& run, const PhotographOptions& options) {
  if (options.times.empty()) return run.times();
  for (const double time : options.times) {
    if (run.has(time)) continue;
    throw InputError(fmt::format("--time {}: {} has no saved state or depth at that time; it has {} s", time,
                                 options.run_folder.string(), fmt::join(run.times(), ", ")));
  }
  std::vector<double> times = options.times;
  std::sort(times.begin(), times.end());
  return times;
}

/// Photographs and the comparison file that describes them.
class Photographer {
 public:
  Photographer(SyntheticSettings settings, const Scene& scene, std::optional<std::array<double, 4>> area,
               std::filesystem::path folder)
      : settings_(std::move(settings)),
        floor_(floor_of(completed_by_symmetry(scene), area)),
        camera_(synthetic_camera(settings_.camera, floor_.area)),
        folder_(std::move(folder)) {
    comparison_.title = scene.title;
    const bool shallow = scene.scheme.name == "shallow_water";
    comparison_.experiment =
        fmt::format("synthetic photograph of {} ({})", scene.name, shallow ? "shallow water" : "EISPH");
    comparison_.synthetic = true;
    comparison_.area = floor_.area;
  }

  void take_calibration() {
    SyntheticSettings still = settings_;
    still.rims.width = 0.0;
    unsigned number = kFirstCalibration;
    for (const double depth : settings_.calibration_depths) {
      const std::string name = fmt::format("still_{:03.0f}mm.png", depth / kMillimetre);
      take(
          still, name, [depth](double, double) { return depth; }, number++);
      comparison_.calibration.photographs.push_back({name, depth});
    }
    take(
        still, "empty.png", [](double, double) { return 0.0; }, number);
  }

  void take_wave(const DepthGrid& grid, double time) {
    const std::string name = fmt::format("photograph_{:04}.png", comparison_.photographs.size());
    const auto number = static_cast<unsigned>(comparison_.photographs.size());
    take(
        settings_, name, [&grid](double x, double y) { return depth_between(grid, x, y); }, number);
    comparison_.photographs.push_back({name, time});
  }

  /// Without distortion the outline is enough; with it points along the edges are given, as if picked.
  void write_comparison() {
    if (settings_.camera.radial_distortion == 0.0) {
      comparison_.registration.outline = "empty.png";
    } else {
      comparison_.registration.radial_distortion = true;
      add_edge_points();
    }
    write_file_atomically(folder_ / "comparison.toml",
                          "# " + synthetic_warning() + "\n\n" + comparison_toml(comparison_));
  }

 private:
  void take(const SyntheticSettings& settings, const std::string& name,
            const std::function<double(double, double)>& depth, unsigned number) {
    write_grey_png(folder_ / name, synthetic_photograph(settings, camera_, floor_, depth, number),
                   settings.camera.bit_depth, {{"Description", synthetic_warning()}});
  }

  void add_edge_points() {
    const auto& [x_min, y_min, x_max, y_max] = floor_.area;
    for (int i = 0; i <= 2; ++i) {
      for (int j = 0; j <= 2; ++j) {
        if (i == 1 && j == 1) continue;
        const PlanePoint plane = {x_min + 0.5 * i * (x_max - x_min), y_min + 0.5 * j * (y_max - y_min)};
        const Eigen::Vector2d pixel = camera_.pixel_of({plane[0], plane[1]});
        const auto written = [](double value) { return std::round(value / kPickStep) * kPickStep; };
        comparison_.registration.points.push_back(
            {fmt::format("edge {} {}", i, j), plane, {written(pixel.x()), written(pixel.y())}});
      }
    }
  }

  SyntheticSettings settings_;
  FloorMap floor_;
  PlaneCamera camera_;
  std::filesystem::path folder_;
  Comparison comparison_;
};

}  // namespace

int photograph_command(const PhotographOptions& options, std::ostream& out) {
  const SyntheticSettings settings = load_synthetic_settings(options.camera, options.overrides);
  const Scene scene = RunDepths(options.run_folder, {}).scene();
  const RunDepths run(options.run_folder, finest_depth(scene));
  const std::vector<double> times = chosen_times(run, options);
  const std::filesystem::path folder = options.out.value_or(options.run_folder / "photographs");
  Photographer photographer(settings, scene, options.area, folder);
  create_folder(folder);
  photographer.take_calibration();
  for (const double time : times) photographer.take_wave(run.at(time).front().grid, time);
  photographer.write_comparison();
  if (!options.quiet) {
    fmt::print(out, "{} synthetic photographs of the wave, {} of still water; {}\n", times.size(),
               settings.calibration_depths.size() + 1, (folder / "comparison.toml").string());
  }
  return kSuccess;
}

}  // namespace eisph
