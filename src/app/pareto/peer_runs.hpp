#pragma once

#include "app/pareto/pareto_study.hpp"
#include "core/peer_run.hpp"
#include "core/snapshot.hpp"

#include <filesystem>
#include <vector>

namespace eisph {

/// The runs in a folder and in the folders in it: each has a peer.toml (io/peer_file.hpp). In the order of
/// their paths. Throws InputError if there are none, and for one that is not of `cases`, that does not end
/// when they do, or whose states cannot be read.
[[nodiscard]] std::vector<PeerRun> find_peer_runs(const std::filesystem::path& folder,
                                                  const std::vector<const ParetoCase*>& cases, bool full);

/// A state of another program as if a scheme had published it. The table has the columns x, z, velocity_x,
/// velocity_z and pressure, in three dimensions y and velocity_y too, a row per particle; or, in two
/// dimensions, x and depth, a row per cell of equal width from the upstream end of the tank, those that are
/// missing being dry. Number densities are the water fractions at the particles. Throws InputError naming
/// file and column.
[[nodiscard]] Snapshot read_peer_state(const Scene& scene, const PeerState& state);

/// Looks at the states with the probes of the case, writes their tables to `folder`, and measures the errors
/// as those of the program's own runs. What only a solver knows (pairs, memory, energy) is not-a-number.
[[nodiscard]] ParetoPoint measure_peer(const PeerRun& peer, const ParetoCase& chosen,
                                       const ValidationRun* reference, const std::filesystem::path& folder);

}  // namespace eisph
