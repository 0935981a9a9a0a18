#pragma once

#include "io/run_json.hpp"

#include <string>

namespace eisph {

/// "eisph 0.1.0": what frames and the command line name as their software.
[[nodiscard]] std::string software_name();

/// How this program was made, for run.json.
[[nodiscard]] BuildInfo build_info();

}  // namespace eisph
