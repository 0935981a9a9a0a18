#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

// What another program left of its run of a flow that `eisph pareto` knows. SI units.

struct PeerState {
  double time = 0.0;           ///< s
  std::filesystem::path file;  ///< CSV: particles, or columns of water
};

struct PeerRun {
  std::filesystem::path source_file;
  std::string flow;               ///< name of the case
  std::string scheme;             ///< program and scheme, the series in a chart
  std::string setting;            ///< what tells runs of a scheme apart
  double spacing = 0.0;           ///< m, of particles or cells
  std::uint64_t particles = 0;    ///< or cells; 0: as many as the last state has rows
  std::uint64_t steps = 0;        ///< time steps
  double cpu_time = 0.0;          ///< s, of the time loop up to the last state
  std::vector<PeerState> states;  ///< in the order of time
};

}  // namespace eisph
