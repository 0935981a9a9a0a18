#pragma once

#include "app/run_files.hpp"
#include "app/saved_states.hpp"
#include "core/comparison.hpp"
#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <filesystem>
#include <map>
#include <vector>

namespace eisph {

/// The depth rules that a state is compared by; the first is the one asked for. One rule where only that one
/// can be had.
struct RuledDepth {
  DepthRule rule = DepthRule::HighestParticle;
  DepthGrid grid;  ///< a half domain completed by its mirror image
};

/// Depth of a state by both rules, `settings.depth_rule` first. Models without particles have one depth.
[[nodiscard]] std::vector<RuledDepth> depths_of(const Scene& scene, const DeviationSettings& settings,
                                                const Snapshot& snapshot);

/// Cells that a run is compared on, m.
[[nodiscard]] double comparison_cell_size(const Scene& scene, const DeviationSettings& settings);

/// Water depth that a finished run has saved: from its particle states, or, where it has none, from its depth
/// grids, whose rule and cells are then the ones to compare on.
class RunDepths {
 public:
  /// Throws InputError if the folder is not that of a run, or the run has saved neither.
  RunDepths(const std::filesystem::path& folder, DeviationSettings settings);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// Times with a saved depth, s, rising.
  [[nodiscard]] std::vector<double> times() const;
  [[nodiscard]] bool has(double time) const;
  [[nodiscard]] double cell_size() const;
  /// Depth at the saved time nearest to `time`.
  [[nodiscard]] std::vector<RuledDepth> at(double time) const;

 private:
  [[nodiscard]] double nearest(double time) const;

  RunFiles files_;
  DeviationSettings settings_;
  Scene scene_;
  std::vector<SavedState> states_;
  std::map<double, std::filesystem::path> grids_;  ///< by time, without states
};

}  // namespace eisph
