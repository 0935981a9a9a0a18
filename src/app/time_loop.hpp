#pragma once

#include "app/output_plan.hpp"
#include "app/pipeline.hpp"
#include "scheme/simulation.hpp"

#include <functional>

namespace eisph {

enum class LoopEnd { Finished, Interrupted };

/// What the time loop calls. None may be empty.
struct LoopHooks {
  std::function<void(const Publication&)> publish;
  std::function<void()> after_step;
  std::function<bool()> stop_requested;  ///< asked before every step
};

/// Steps the simulation from its present time to `end_time` (s) and publishes its state at every output time,
/// the present one and the end included; one snapshot per output time. Steps end on output times exactly.
LoopEnd run_time_loop(Simulation& simulation, const OutputPlan& plan, double end_time,
                      const LoopHooks& hooks);

}  // namespace eisph
