#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace eisph {

/// Where a program is; empty if it is nowhere on the PATH.
[[nodiscard]] std::filesystem::path find_program(std::string_view name);

/// Runs a program, arguments[0], with no input and with its output and its messages in files. Returns its
/// exit code, or minus the signal that ended it. Throws std::runtime_error if it cannot be started.
[[nodiscard]] int run_child_program(std::vector<std::string> arguments, const std::filesystem::path& out,
                                    const std::filesystem::path& messages);

/// A folder for files that nobody keeps; it goes with everything in it. Throws std::runtime_error if it
/// cannot be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();
  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace eisph
