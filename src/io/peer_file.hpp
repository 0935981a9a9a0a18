#pragma once

#include "core/peer_run.hpp"

#include <filesystem>

namespace eisph {

/// Reads a peer.toml:
///
///     case = "ritter_long"        # of eisph pareto
///     scheme = "PySPH, WCSPH"     # program and scheme
///     setting = "h = 1.3 dx"      # optional
///     spacing = 0.005             # m, of particles or cells
///     particles = 6000            # or cells; optional
///     steps = 4000
///     cpu_time = 12.3             # s, of the time loop
///     [[state]]
///     time = 0.8                  # s
///     file = "state_0000.csv"     # from the folder of this file
///
/// Paths of the result can be opened as they are. Throws InputError naming file, line, key and value: also
/// for a state that does not exist and for times that do not rise.
[[nodiscard]] PeerRun load_peer_run(const std::filesystem::path& file);

}  // namespace eisph
