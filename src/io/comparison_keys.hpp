#pragma once

#include "core/comparison.hpp"
#include "io/schema_table.hpp"

namespace eisph {

/// All keys of a comparison file.
[[nodiscard]] KeyTable<Comparison> comparison_keys();

}  // namespace eisph
