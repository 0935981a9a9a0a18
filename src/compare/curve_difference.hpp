#pragma once

#include "compare/curve.hpp"

#include <cstddef>
#include <vector>

namespace eisph {

/// A model curve m against a reference r, at those points of the reference that lie in the range of the
/// model. Not-a-number (with points = 0) if there is none.
struct CurveDifference {
  std::size_t points = 0;
  double relative_l2 = 0.0;  ///< sqrt(sum (m - r)^2 / sum r^2)
  double rms = 0.0;          ///< sqrt(mean (m - r)^2), in units of y
  double bias = 0.0;         ///< mean (m - r)
  double max_abs = 0.0;      ///< largest |m - r|
};
[[nodiscard]] CurveDifference curve_difference(const Curve& model, const Curve& reference);

/// Share (0 to 1) of the points of a measured band that the model passes inside of, lower <= m <= upper.
/// lower and upper have the same x, else std::invalid_argument.
struct BandShare {
  std::size_t points = 0;
  double inside = 0.0;
  double below = 0.0;
  double above = 0.0;
};
[[nodiscard]] BandShare band_share(const Curve& model, const Curve& lower, const Curve& upper);

/// The shift of the model in x, between `least` and `most`, at which its relative L2 is smallest: for an
/// unknown delay of a gate. All shifts are judged by the same points of the reference: those in the range of
/// the model at every shift allowed (see extended()).
struct ShiftedDifference {
  double shift = 0.0;  ///< to be added to the model's x
  CurveDifference difference;
};
[[nodiscard]] ShiftedDifference best_shift(const Curve& model, const Curve& reference, double least,
                                           double most);

/// A point of a vertical plane, m.
struct PlanePoint {
  double x = 0.0;
  double z = 0.0;
};

/// Points of a measured surface, in any order and possibly overturning, against a model's.
struct ProfileDifference {
  std::size_t points = 0;      ///< compared vertically: in the x range of the model's curve
  double vertical_rms = 0.0;   ///< m, to the model's surface curve z(x)
  double vertical_bias = 0.0;  ///< m, mean of model - measurement
  double nearest_rms = 0.0;    ///< m, distance to the nearest point of the model's surface, over all points
};
/// `surface` is the model's highest surface as a function of x, `surface_points` all of its surface points,
/// those under an overturning wave included; empty: the corners of `surface`.
[[nodiscard]] ProfileDifference profile_difference(const std::vector<PlanePoint>& measured,
                                                   const Curve& surface,
                                                   const std::vector<PlanePoint>& surface_points = {});

}  // namespace eisph
