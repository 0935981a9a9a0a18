#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace eisph {

/// Exit codes of the program.
enum ExitCode : int { kSuccess = 0, kFailure = 1, kBadInput = 2, kBlowUp = 3, kLimitsMissed = 4 };

/// Bad input: a scene, an option or a file that cannot be used. The message names the file, line, key, value
/// and what is accepted. The program exits with code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The state left the range in which the method means anything (not-a-number, a speed far above any physical
/// one). The message says when, where and which particle. The program exits with code 3.
class BlowUpError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace eisph
