#pragma once

#include "app/progress.hpp"
#include "app/run_files.hpp"
#include "core/run_summary.hpp"
#include "core/scene.hpp"
#include "render/gl_context.hpp"
#include "scheme/simulation.hpp"

#include <functional>
#include <memory>

#include <spdlog/logger.h>

namespace eisph {

struct InSituSettings {
  double end_time = 0.0;  ///< s
  bool frames = true;
  ContextKind context = ContextKind::Automatic;  ///< of the frames
  /// Is handed every published state, on the thread of the simulation; may be empty.
  std::function<void(const std::shared_ptr<const Snapshot>&)> observer = {};
  /// Is handed the states at the times of Scene::output.comparison, on the thread that records; may be empty.
  std::function<void(const Snapshot&)> compare = {};
};

/// Runs a simulation with everything beside it: records and frames go to the folder of the run, which has to
/// exist. A blow-up and a requested stop end the run early, with everything published before on disk and the
/// status of the summary set; any other failure is thrown.
[[nodiscard]] RunSummary run_in_situ(Simulation& simulation, const Scene& scene, const RunFiles& files,
                                     const InSituSettings& settings, ProgressReporter& progress,
                                     spdlog::logger& log, const std::function<bool()>& stop_requested);

}  // namespace eisph
