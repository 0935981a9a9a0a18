#include "app/time_loop.hpp"

namespace eisph {

LoopEnd run_time_loop(Simulation& simulation, const OutputPlan& plan, double end_time,
                      const LoopHooks& hooks) {
  while (true) {
    const double time = simulation.time();
    DueOutputs due = plan.due_at(time);
    if (due.any()) hooks.publish({simulation.snapshot(), std::move(due)});
    if (time >= end_time) return LoopEnd::Finished;

    double target = plan.next_after(time);
    if (target > end_time - OutputPlan::kTolerance) target = end_time;
    while (simulation.time() < target) {
      if (hooks.stop_requested()) return LoopEnd::Interrupted;
      simulation.step(target);
      hooks.after_step();
    }
  }
}

}  // namespace eisph
