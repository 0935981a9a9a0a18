#pragma once

namespace eisph {

/// Dam break over a dry, horizontal, frictionless bed (Ritter 1892; thesis (2.6), (2.7)). The dam stands at
/// x = 0, the water behind it (x < 0) is h0 deep and endless, and the dam vanishes at t = 0:
///
///     h = (2 c0 - x/t)^2 / (9 g),  u = 2/3 (c0 + x/t)   for -c0 <= x/t <= 2 c0,  c0 = sqrt(g h0).
///
/// Lengths in m, times in s (t >= 0), speeds in m/s.
class RitterSolution {
 public:
  /// Throws std::invalid_argument unless both are positive.
  explicit RitterSolution(double reservoir_depth, double gravity = 9.81);

  /// Speed c0 of small waves on the reservoir.
  [[nodiscard]] double celerity() const { return celerity_; }
  /// Water depth; zero downstream of the front.
  [[nodiscard]] double depth(double x, double t) const;
  /// Mean velocity over the depth; zero in still water and where it is dry.
  [[nodiscard]] double velocity(double x, double t) const;
  [[nodiscard]] double front_speed() const { return 2.0 * celerity_; }
  [[nodiscard]] double front(double t) const { return front_speed() * t; }
  /// How far the reservoir is disturbed: x < 0.
  [[nodiscard]] double rarefaction_end(double t) const { return -celerity_ * t; }
  /// Depth at the dam, the same at all t > 0: 4/9 h0.
  [[nodiscard]] double depth_at_dam() const { return 4.0 / 9.0 * reservoir_depth_; }
  /// When the rarefaction meets the end wall of a reservoir of this length. The solution holds until then
  /// (and, ahead of the reflected wave, for some time after).
  [[nodiscard]] double valid_until(double reservoir_length) const { return reservoir_length / celerity_; }

 private:
  double reservoir_depth_;
  double gravity_;
  double celerity_;
};

}  // namespace eisph
