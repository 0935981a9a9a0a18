#pragma once

#include "core/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

/// Memory that the system can still hand out, bytes.
[[nodiscard]] std::uint64_t available_memory_bytes();

/// Reads a scene file (TOML), fills in the defaults and checks everything. `overrides` are
/// "section.key=value" with the value in TOML syntax or a bare word; elements of a list are addressed by
/// number or name: "image.0.width=640", "image.top.width=640". Throws InputError with the file, line, key and
/// value at fault and what would be accepted; a scene that needs more than `available_memory` bytes is such
/// an error.
[[nodiscard]] Scene load_scene(const std::filesystem::path& file,
                               const std::vector<std::string>& overrides = {},
                               std::uint64_t available_memory = available_memory_bytes());

/// The scene as a file with every key written out; load_scene turns it into the same scene again.
[[nodiscard]] std::string resolved_scene_toml(const Scene& scene);

/// Reference of all keys: type, range, unit, default and meaning.
[[nodiscard]] std::string scene_schema_text();

/// Colour maps that an image can name: the tables in assets/colour_maps and "grey_depth".
[[nodiscard]] std::vector<std::string> colour_map_names();

}  // namespace eisph
