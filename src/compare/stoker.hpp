#pragma once

namespace eisph {

/// Dam break onto water at rest, horizontal frictionless bed (Stoker 1957, Water Waves, section 10.8). The
/// dam stands at x = 0, the reservoir (x < 0) is h0 deep and endless, the water downstream h1. A rarefaction
/// joins the reservoir to a middle state (hm, um), which a bore separates from the water at rest:
///
///     2 (c0 - cm) = um = (hm - h1) sqrt(g (hm + h1) / (2 hm h1)),  bore speed hm um / (hm - h1),
///
/// with c = sqrt(g h). Lengths in m, times in s (t >= 0), speeds in m/s.
class StokerSolution {
 public:
  /// Throws std::invalid_argument unless 0 < downstream_depth < reservoir_depth and gravity is positive.
  StokerSolution(double reservoir_depth, double downstream_depth, double gravity = 9.81);

  [[nodiscard]] double celerity() const { return celerity_; }
  [[nodiscard]] double middle_depth() const { return middle_depth_; }
  [[nodiscard]] double middle_velocity() const { return middle_velocity_; }
  [[nodiscard]] double bore_speed() const { return bore_speed_; }
  [[nodiscard]] double depth(double x, double t) const;
  /// Mean velocity over the depth.
  [[nodiscard]] double velocity(double x, double t) const;
  [[nodiscard]] double bore(double t) const { return bore_speed_ * t; }
  /// Where the rarefaction ends and the middle state begins.
  [[nodiscard]] double middle_begin(double t) const { return (middle_velocity_ - middle_celerity_) * t; }
  [[nodiscard]] double rarefaction_end(double t) const { return -celerity_ * t; }
  /// When the rarefaction meets the end wall of a reservoir of this length.
  [[nodiscard]] double valid_until(double reservoir_length) const { return reservoir_length / celerity_; }

 private:
  double reservoir_depth_;
  double downstream_depth_;
  double gravity_;
  double celerity_;
  double middle_depth_ = 0.0;
  double middle_velocity_ = 0.0;
  double middle_celerity_ = 0.0;
  double bore_speed_ = 0.0;
};

}  // namespace eisph
