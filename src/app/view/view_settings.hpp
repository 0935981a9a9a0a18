#pragma once

#include "core/scene.hpp"
#include "scheme/simulation.hpp"

#include <array>

namespace eisph {

/// Where the ends of the colour bar come from.
enum class RangeMode {
  Automatic,  ///< the scene alone, as in frames without a range
  Fitted,     ///< the state that is shown
  Held,       ///< what was typed, or what it was when it was held
};

/// Key of the factor that sets the time step of the scene's scheme.
[[nodiscard]] inline const char* step_factor_name(const Scene& scene) {
  const bool courant = scene.scheme.weakly_compressible() || scene.scheme.name == "shallow_water";
  return courant ? "courant" : "phi";
}

/// What the user of a viewer has chosen.
struct ViewSettings {
  ImageSettings picture;  ///< without a size; the camera is always set
  RangeMode range_mode = RangeMode::Automatic;
  std::array<double, 2> held_range = {0.0, 1.0};  ///< units of the colour bar
  std::array<bool, 6> cut{};                      ///< clip planes in use: x, y, z; lower, upper of each
  std::array<double, 6> cut_at{};                 ///< m
  bool side_panel = true;                         ///< depth and curves
  bool help = false;
  double run_to = 0.0;              ///< s
  double record_interval = 0.0;     ///< s
  std::array<int, 2> frame_size{};  ///< of screenshots and recorded frames, pixels
  RunningParameters parameters;     ///< as typed; in force once applied
};

}  // namespace eisph
