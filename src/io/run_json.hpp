#pragma once

#include "core/run_summary.hpp"
#include "io/host.hpp"

#include <chrono>
#include <filesystem>
#include <string>

namespace eisph {

/// How the program was made.
struct BuildInfo {
  std::string version;
  std::string compiler;
  std::string type;             ///< Release, Debug, ...
  std::string flags;            ///< of the compiler
  std::string instruction_set;  ///< the widest that the code may use
  std::string commit;           ///< empty if unknown
};

/// The compiler and the instruction set as compiled into this library; the rest is for the caller to fill in.
[[nodiscard]] BuildInfo compiled_build_info();

/// Start and end of a run by the clock on the wall.
struct RunTimes {
  std::chrono::system_clock::time_point started;
  std::chrono::system_clock::time_point finished;
};

/// Writes run.json: an object with every field of the summary by its own name, and `version`, `build`,
/// `host`, `started` and `finished`. Units are those of RunSummary; a figure that is not a number becomes
/// null. Throws std::runtime_error naming the path; an older file is then unchanged.
void write_run_json(const std::filesystem::path& path, const RunSummary& summary, const BuildInfo& build,
                    const HostInfo& host, const RunTimes& times);

}  // namespace eisph
