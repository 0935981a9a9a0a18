#pragma once

#include <string>
#include <vector>

namespace eisph {

// Settings of the synthetic photographs. Grey levels from 0 (black) to 255 (white).

/// A pinhole camera above the middle of the area that it shows.
struct SyntheticCamera {
  int width = 1000;  ///< pixels
  int height = 800;  ///< pixels
  int bit_depth = 8;
  double elevation = 4.0;          ///< m above the floor
  double tilt = 3.0;               ///< degrees, towards positive x
  double roll = 1.0;               ///< degrees, about the optical axis
  double margin = 0.06;            ///< of the picture left free around the area
  double radial_distortion = 0.0;  ///< k1

  bool operator==(const SyntheticCamera&) const = default;
};

/// Light from below through coloured water: level = bright exp(-depth / extinction_length).
struct SyntheticLight {
  double bright = 235.0;             ///< level of the dry floor
  double extinction_length = 0.067;  ///< m: 0.15 m of water have level 25
  double falloff = 0.10;             ///< share of the light that is missing in the corners
  double gradient = 0.05;            ///< share by which the light changes from left to right
  double noise = 1.0;                ///< standard deviation of a pixel
  double frame = 10.0;               ///< level outside the floor
  double solid = 25.0;               ///< level of solids

  bool operator==(const SyntheticLight&) const = default;
};

/// Dark rims of air bubbles in water at walls and solids.
struct SyntheticRims {
  double width = 0.012;    ///< m, mean
  double darkness = 0.35;  ///< share of the light that is lost at the wall

  bool operator==(const SyntheticRims&) const = default;
};

struct SyntheticSettings {
  std::string source_file;
  /// Depths of the photographs of still water, m.
  std::vector<double> calibration_depths = {0.0, 0.01, 0.02, 0.04, 0.06, 0.08, 0.10, 0.12, 0.15};
  int seed = 1;
  SyntheticCamera camera;
  SyntheticLight light;
  SyntheticRims rims;

  bool operator==(const SyntheticSettings&) const = default;
};

}  // namespace eisph
