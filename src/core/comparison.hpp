#pragma once

#include "core/scene.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

// The content of a comparison file, checked and with defaults filled in: photographs of a tank from above,
// how they are turned into water depth, and the run that they are compared with. SI units; pixels from the
// upper left corner of the picture, grey levels from 0 (black) to 255 (white) whatever the depth of the file.

using PlanePoint = std::array<double, 2>;  ///< x, y

struct TimedPhotograph {
  std::filesystem::path file;
  double time = 0.0;  ///< s

  bool operator==(const TimedPhotograph&) const = default;
};

/// A point of the floor that is seen in the photographs.
struct ReferencePointSettings {
  std::string name;
  PlanePoint position{};  ///< m
  PlanePoint pixel{};

  bool operator==(const ReferencePointSettings&) const = default;
};

/// How pixels are related to the floor of the tank.
struct RegistrationSettings {
  std::filesystem::path outline;  ///< photograph in which the floor's corners are found; empty: points given
  std::vector<ReferencePointSettings> points;
  bool radial_distortion = false;
  double pick_error = 1.0;  ///< pixels, standard deviation of a picked point in each direction
  int repetitions = 40;     ///< of the registration with perturbed points; 0: none
  int seed = 1;

  bool operator==(const RegistrationSettings&) const = default;
};

/// A photograph of still water.
struct CalibrationPhotograph {
  std::filesystem::path file;
  double depth = 0.0;  ///< m

  bool operator==(const CalibrationPhotograph&) const = default;
};

struct CalibrationLevel {
  double level = 0.0;  ///< grey level, 0 to 255
  double depth = 0.0;  ///< m

  bool operator==(const CalibrationLevel&) const = default;
};

/// How grey levels are turned into depth: by photographs, or by a table.
struct CalibrationSettings {
  std::vector<CalibrationPhotograph> photographs;
  std::vector<CalibrationLevel> levels;
  bool per_pixel = true;            ///< a curve for each pixel, instead of one for all
  std::optional<double> tolerance;  ///< grey levels beyond the ends that still count as the end

  bool operator==(const CalibrationSettings&) const = default;
};

/// Which parts of the photographs are dark for another reason than depth.
enum class RimDetection {
  Detect,  ///< cells of the band that are deeper than the water beyond it
  Band,    ///< the whole band
  None,
};

/// What stands in for the depth of dark rims.
enum class RimFill {
  NearestPlus10,  ///< the nearest valid depth and 10 % more (thesis section 4.2.1)
  LeaveOut,
  Keep,
};

struct RimSettings {
  double band = 0.03;  ///< m from walls and solids
  RimDetection detection = RimDetection::Detect;
  RimFill fill = RimFill::NearestPlus10;
  std::vector<std::vector<PlanePoint>> polygons = {};  ///< further dark areas, m

  bool operator==(const RimSettings&) const = default;
};

struct DeviationSettings {
  double cell_size = 0.0;  ///< m; 0: 1.5 particle spacings of the run, or the cells of its depth grids
  DepthRule depth_rule = DepthRule::HighestParticle;
  bool ignore_spray = true;   ///< by the rule HighestParticle
  double dry_depth = 0.005;   ///< m
  bool treat_as_dry = false;  ///< depths below dry_depth count as zero on both sides
  int classes = 60;

  bool operator==(const DeviationSettings&) const = default;
};

struct ComparisonImages {
  int width = 1200;        ///< pixels
  double depth = 0.15;     ///< m, deepest of the grey scale
  double deviation = 0.0;  ///< m, end of the colour bar; 0: a third of the depth
  bool video = true;       ///< where ffmpeg is present

  bool operator==(const ComparisonImages&) const = default;
};

struct Comparison {
  std::string source_file;  ///< where it was read from
  std::string title;
  bool synthetic = false;           ///< the photographs are computed: every picture and the report say so
  std::filesystem::path run;        ///< folder of the run; empty: named on the command line or run in situ
  std::filesystem::path other_run;  ///< folder of a run drawn beside it, half by half; empty: none
  std::string experiment = "experiment";  ///< what the photographs show, for captions
  /// Part of the floor that the photographs show, m: lower and upper corner. Default: all of it.
  std::optional<std::array<double, 4>> area;
  std::array<double, 3> grey_weights = {0.299, 0.587, 0.114};  ///< of red, green and blue
  std::vector<TimedPhotograph> photographs;                    ///< in the order of time
  RegistrationSettings registration;
  CalibrationSettings calibration;
  RimSettings rims;
  DeviationSettings deviation;
  ComparisonImages images;

  bool operator==(const Comparison&) const = default;
};

}  // namespace eisph
