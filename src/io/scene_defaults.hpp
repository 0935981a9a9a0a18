#pragma once

#include "core/scene.hpp"
#include "io/toml_source.hpp"

namespace eisph {

/// Fills in what depends on other keys, where the source does not give it.
void complete_scene(Scene& scene, const TomlSource& source);

}  // namespace eisph
