#pragma once

#include "core/scene.hpp"
#include "io/scene_source.hpp"

#include <cstdint>

namespace eisph {

/// What no single key can tell: names, times, cameras, gates. Throws InputError.
void check_settings(const Scene& scene, const SceneSource& source);

/// Domain, bodies, instruments, particle counts and memory. Throws InputError.
void check_geometry(const Scene& scene, const SceneSource& source, std::uint64_t available_memory);

/// Section that solid `index` was read from, the obstacles counted first and the gates after them.
[[nodiscard]] std::string solid_path(const Scene& scene, const SceneSource& source, std::size_t index);

}  // namespace eisph
