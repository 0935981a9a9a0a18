#pragma once

#include "core/kernel.hpp"

#include <optional>
#include <string>

namespace eisph {

/// Warning for a kernel and a ratio h / dx with which particles pair: more than a few per cent of them come
/// to lie within 0.6 dx of another (NeighbourDistances), by measurements of still water, collapsing columns
/// and the tank of Aureli et al. Nothing for those with which they stay apart.
[[nodiscard]] std::optional<std::string> pairing_warning(KernelKind kernel, double smoothing_ratio,
                                                         int dimension);

}  // namespace eisph
