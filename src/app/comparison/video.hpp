#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

[[nodiscard]] bool has_ffmpeg();

/// Joins pictures of one size to a video, each shown for `seconds_each`. Throws std::runtime_error with
/// ffmpeg's message if that fails; an older file is then unchanged.
void write_video(const std::filesystem::path& path, const std::vector<std::filesystem::path>& pictures,
                 double seconds_each);

}  // namespace eisph
