#pragma once

#include "app/run_files.hpp"
#include "core/snapshot.hpp"

#include <filesystem>
#include <vector>

namespace eisph {

/// One state that a run has saved.
struct SavedState {
  double time = 0.0;  ///< s
  std::filesystem::path particles;
  std::filesystem::path objects;  ///< empty if there were none
};

/// The states of a run in the order of time. Throws InputError if there are none.
[[nodiscard]] std::vector<SavedState> saved_states(const RunFiles& files);

/// How far a time on the command line may be from that of the state it means, s.
inline constexpr double kStateTimeTolerance = 1e-3;

/// The states nearest to `times` (s), each once and in the order of time; all of them for no times. Throws
/// InputError for a time without a state within the tolerance.
[[nodiscard]] std::vector<SavedState> select_states(const std::vector<SavedState>& states,
                                                    const std::vector<double>& times);

[[nodiscard]] Snapshot read_state(const SavedState& state);

}  // namespace eisph
