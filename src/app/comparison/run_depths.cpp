#include "app/comparison/run_depths.hpp"

#include "compare/deviation_statistics.hpp"
#include "core/error.hpp"
#include "core/scene_mirror.hpp"
#include "io/pvd_collection.hpp"
#include "io/scene_file.hpp"
#include "io/vtk_output.hpp"
#include "probe/depth_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kCellsPerSpacing = 1.5;  ///< thesis section 4.2.1

Scene scene_of_run(const RunFiles& files) {
  if (!std::filesystem::is_regular_file(files.scene())) {
    throw InputError(
        fmt::format("{}: is not the folder of a run: it has no scene.toml", files.folder.string()));
  }
  Scene scene = load_scene(files.scene(), {}, std::numeric_limits<std::uint64_t>::max());
  if (scene.dimension != 3) {
    throw InputError(fmt::format("{}: a two-dimensional run cannot be compared with photographs from above",
                                 files.folder.string()));
  }
  return scene;
}

DepthGrid completed(const Scene& scene, DepthGrid grid) {
  const auto plane = symmetry_plane_y(scene);
  return plane ? mirrored(grid, *plane) : std::move(grid);
}

DepthGrid depth_by(const Scene& scene, const DeviationSettings& settings, DepthRule rule,
                   const Snapshot& snapshot) {
  Scene ruled = scene;
  ruled.output.depth_rule = rule;
  ruled.output.ignore_spray = settings.ignore_spray;
  ruled.output.depth_cell_size = comparison_cell_size(scene, settings);
  return completed(scene, DepthGridBuilder(ruled).build(snapshot));
}

}  // namespace

double comparison_cell_size(const Scene& scene, const DeviationSettings& settings) {
  return settings.cell_size > 0.0 ? settings.cell_size : kCellsPerSpacing * scene.particle_spacing;
}

std::vector<RuledDepth> depths_of(const Scene& scene, const DeviationSettings& settings,
                                  const Snapshot& snapshot) {
  std::vector<RuledDepth> depths;
  const bool highest = settings.depth_rule == DepthRule::HighestParticle;
  const DepthRule other = highest ? DepthRule::Surface : DepthRule::HighestParticle;
  depths.push_back({settings.depth_rule, depth_by(scene, settings, settings.depth_rule, snapshot)});
  if (!snapshot.columns) depths.push_back({other, depth_by(scene, settings, other, snapshot)});
  return depths;
}

RunDepths::RunDepths(const std::filesystem::path& folder, DeviationSettings settings)
    : files_{folder}, settings_(settings), scene_(scene_of_run(files_)) {
  if (std::filesystem::exists(files_.particles_collection())) {
    states_ = saved_states(files_);
    return;
  }
  if (!std::filesystem::exists(files_.depth_collection())) {
    throw InputError(
        fmt::format("{}: the run has saved neither states nor depth grids; they are written at "
                    "output.particles_times and "
                    "output.depth_times",
                    folder.string()));
  }
  for (const PvdEntry& entry : read_pvd(files_.depth_collection())) grids_[entry.time] = entry.file;
}

std::vector<double> RunDepths::times() const {
  std::vector<double> times;
  for (const SavedState& state : states_) times.push_back(state.time);
  for (const auto& [time, file] : grids_) times.push_back(time);
  return times;
}

double RunDepths::nearest(double time) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double candidate : times()) {
    if (std::abs(candidate - time) < std::abs(nearest - time)) nearest = candidate;
  }
  return nearest;
}

bool RunDepths::has(double time) const { return std::abs(nearest(time) - time) <= kStateTimeTolerance; }

double RunDepths::cell_size() const {
  if (!states_.empty()) return comparison_cell_size(scene_, settings_);
  return grids_.empty() ? 0.0 : read_depth(grids_.begin()->second).cell_size;
}

std::vector<RuledDepth> RunDepths::at(double time) const {
  const double saved = nearest(time);
  if (states_.empty()) return {{scene_.output.depth_rule, completed(scene_, read_depth(grids_.at(saved)))}};
  const auto state = std::find_if(states_.begin(), states_.end(),
                                  [saved](const SavedState& candidate) { return candidate.time == saved; });
  return depths_of(scene_, settings_, read_state(*state));
}

}  // namespace eisph
