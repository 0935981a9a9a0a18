#pragma once

#include "core/grey_picture.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// Where a grey level lies on a calibration curve.
enum class LevelRange : std::uint8_t {
  Inside,
  Clamped,    ///< beyond an end by no more than the tolerance: the depth of that end
  TooBright,  ///< no depth
  TooDark,    ///< no depth
  Unusable,   ///< the pixel has no curve
};

struct CalibratedDepth {
  float depth = 0.0F;  ///< m; not-a-number without one
  LevelRange range = LevelRange::Inside;
};

/// A photograph of still water over the whole floor.
struct CalibrationStep {
  std::string name;    ///< for messages
  double depth = 0.0;  ///< m
  GreyPicture picture;
};

struct CalibrationPoint {
  double level = 0.0;  ///< 0 to 1
  double depth = 0.0;  ///< m
};

/// From grey level to water depth: the deeper the darker. Between the calibrated levels depth is a monotone
/// cubic (Fritsch & Butland's slopes, SIAM J. Sci. Stat. Comput. 5, 1984); beyond them there is none.
class DepthCalibration {
 public:
  /// Without any point: no level has a depth.
  static DepthCalibration none() { return {}; }
  /// One curve for all pixels. Throws InputError for fewer than two points, and for two whose level does not
  /// fall as depth rises. `tolerance` in levels (0 to 1); default 2/255.
  static DepthCalibration from_points(std::vector<CalibrationPoint> points,
                                      std::optional<double> tolerance = std::nullopt);
  /// One curve for all pixels, through the medians of the pixels with mask != 0. The tolerance is by default
  /// three standard deviations of the pictures' noise, at least 2/255. Throws InputError as from_points(),
  /// for pictures of different sizes and an empty mask.
  static DepthCalibration whole_picture(const std::vector<CalibrationStep>& steps,
                                        const std::vector<std::uint8_t>& mask,
                                        std::optional<double> tolerance = std::nullopt);
  /// A curve for each pixel with mask != 0, after taking out noise by the mean of those of the 5 x 5 pixels
  /// around it that differ from it by no more than a tenth of white. Pixels whose level does not fall as
  /// depth rises are unusable; throws InputError if these are more than a hundredth, else as whole_picture().
  static DepthCalibration per_pixel(const std::vector<CalibrationStep>& steps,
                                    const std::vector<std::uint8_t>& mask,
                                    std::optional<double> tolerance = std::nullopt);

  /// Depth of `level` in a pixel, whose number only matters if each has a curve of its own.
  [[nodiscard]] CalibratedDepth depth_of(std::size_t pixel, float level) const;

  /// The curve of the whole picture, or the medians of the pixels' curves; levels fall, depths rise.
  [[nodiscard]] const std::vector<CalibrationPoint>& points() const { return points_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }  ///< levels, 0 to 1
  [[nodiscard]] double noise() const { return noise_; }          ///< standard deviation, levels, 0 to 1
  [[nodiscard]] std::size_t unusable() const { return unusable_; }
  [[nodiscard]] bool has_pixel_curves() const { return !levels_.empty(); }

 private:
  DepthCalibration() = default;
  void prepare_pixels(const std::vector<CalibrationStep>& steps, const std::vector<std::uint8_t>& mask);

  std::vector<CalibrationPoint> points_;
  std::vector<float> levels_;  ///< by pixel: its levels in the order of the points, or NaN
  double tolerance_ = 0.0;
  double noise_ = 0.0;
  std::size_t unusable_ = 0;
};

}  // namespace eisph
