#pragma once

#include "core/scene.hpp"
#include "scheme/simulation.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace eisph {

/// What a scene amounts to: particles, memory, time step, outputs. Lines for people.
[[nodiscard]] std::string scene_report(const Scene& scene, const SimulationPlan& plan,
                                       std::uint64_t available_memory);

/// How the particles of t = 0 lie at walls and solids, and their compression. Lines for people.
[[nodiscard]] std::string fit_report(const InitialFit& fit);

/// What is allowed but doubtful about a scene: one sentence each.
[[nodiscard]] std::vector<std::string> scene_warnings(const Scene& scene, const SimulationPlan& plan);

}  // namespace eisph
