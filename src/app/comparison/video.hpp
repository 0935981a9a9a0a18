#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

[[nodiscard]] bool has_ffmpeg();

/// Joins pictures of one size to an H.264 video of `rate` frames per second, each shown for `seconds_each`;
/// odd sides are made even by a row or column of black. Throws std::runtime_error with ffmpeg's message if
/// that fails; an older file is then unchanged.
void write_video(const std::filesystem::path& path, const std::vector<std::filesystem::path>& pictures,
                 double seconds_each, double rate = 25.0);

}  // namespace eisph
