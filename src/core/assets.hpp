#pragma once

#include <filesystem>
#include <string>

namespace eisph {

/// Folder that holds assets/ and shaders/: the environment variable EISPH_HOME if set, otherwise the source
/// tree that the program was built from.
[[nodiscard]] std::filesystem::path home_folder();

/// The file of a scene that comes with the program.
[[nodiscard]] std::filesystem::path shipped_scene(const std::string& name);

}  // namespace eisph
