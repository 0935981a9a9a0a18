#pragma once

#include "core/scene.hpp"
#include "io/toml_source.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace eisph {

/// What no single key can tell: names, times, cameras, gates. Throws InputError.
void check_settings(const Scene& scene, const TomlSource& source);

/// Domain, bodies, probes, particle counts and memory. Throws InputError.
void check_geometry(const Scene& scene, const TomlSource& source, std::uint64_t available_memory);

/// Water that is thinner than a layer of particles. Throws InputError.
void check_thickness(const Scene& scene, const TomlSource& source);

/// Places and ranges of the probes. Throws InputError.
void check_probes(const Scene& scene, const TomlSource& source);

/// Axes that a scene has.
[[nodiscard]] std::vector<int> scene_axes(const Scene& scene);
/// "the domain from ... to ...", for messages.
[[nodiscard]] std::string domain_text(const Scene& scene);

/// Section that solid `index` was read from, the obstacles counted first and the gates after them.
[[nodiscard]] std::string solid_path(const Scene& scene, const TomlSource& source, std::size_t index);

}  // namespace eisph
