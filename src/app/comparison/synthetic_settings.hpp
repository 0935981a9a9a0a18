#pragma once

#include "core/synthetic_camera.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// Settings of synthetic photographs: the defaults, or those of a file, with overrides laid over them. Throws
/// InputError naming file, line, key, value and what is accepted.
[[nodiscard]] SyntheticSettings load_synthetic_settings(const std::optional<std::filesystem::path>& file,
                                                        const std::vector<std::string>& overrides);

/// Reference of all keys with units and defaults.
[[nodiscard]] std::string synthetic_schema_text();

}  // namespace eisph
