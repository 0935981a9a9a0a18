#pragma once

namespace eisph {

/// Reads the command line, runs the command it names and returns the exit code of the program. Errors end as
/// one line on the standard error stream.
[[nodiscard]] int run_program(int argc, const char* const* argv);

}  // namespace eisph
