#pragma once

#include <filesystem>

namespace eisph {

/// Folder that holds assets/ and shaders/: the environment variable EISPH_HOME if set, otherwise the source
/// tree that the program was built from.
[[nodiscard]] std::filesystem::path home_folder();

}  // namespace eisph
