#pragma once

#include "app/in_situ_run.hpp"
#include "app/progress.hpp"
#include "app/run_files.hpp"
#include "core/run_summary.hpp"
#include "core/scene.hpp"

#include <functional>

namespace eisph {

/// Simulates a scene into the folder of a run, which is made or emptied of an earlier run: the resolved
/// scene, the log, all outputs and run.json. Throws InputError before anything is written when the scene
/// cannot be simulated; a blow-up and a requested stop are told by the status of the summary.
[[nodiscard]] RunSummary run_scene(const Scene& scene, const RunFiles& files, const InSituSettings& settings,
                                   int threads, ProgressReporter& progress,
                                   const std::function<bool()>& stop_requested);

}  // namespace eisph
