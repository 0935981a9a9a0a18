#pragma once

#include "core/comparison.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

/// Reads a comparison file (TOML), with overrides "section.key=value" laid over it. Paths in the file are
/// taken from its folder; those of the result can be opened as they are. Throws InputError naming file, line,
/// key, value and what is accepted: also for a photograph that does not exist.
[[nodiscard]] Comparison load_comparison(const std::filesystem::path& file,
                                         const std::vector<std::string>& overrides = {});

/// The file that reads back to `comparison`, with paths as they are.
[[nodiscard]] std::string comparison_toml(const Comparison& comparison);

/// Reference of all keys with units and defaults.
[[nodiscard]] std::string comparison_schema_text();

}  // namespace eisph
