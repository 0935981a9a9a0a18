#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace eisph {

/// The whole content. Throws InputError with the path and the system's reason if the file cannot be read.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path);

/// Writes a file as a whole: a temporary one takes its place. Throws std::runtime_error with the path and the
/// system's reason if it cannot be written; an older file is then unchanged.
void write_whole_file(const std::filesystem::path& path, std::string_view content);

}  // namespace eisph
