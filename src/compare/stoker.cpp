#include "compare/stoker.hpp"

#include <cmath>
#include <stdexcept>

namespace eisph {

namespace {

/// Root of a function that falls from positive at `low` to negative at `high`, to the last bit.
template <typename Function>
double falling_root(Function function, double low, double high) {
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (function(middle) > 0.0 ? low : high) = middle;
  }
}

}  // namespace

StokerSolution::StokerSolution(double reservoir_depth, double downstream_depth, double gravity)
    : reservoir_depth_(reservoir_depth),
      downstream_depth_(downstream_depth),
      gravity_(gravity),
      celerity_(std::sqrt(gravity * reservoir_depth)) {
  if (!(downstream_depth > 0.0) || !(downstream_depth < reservoir_depth) || !(gravity > 0.0)) {
    throw std::invalid_argument("Stoker's solution needs 0 < downstream depth < reservoir depth and gravity");
  }
  const auto behind_rarefaction = [&](double h) { return 2.0 * (celerity_ - std::sqrt(gravity_ * h)); };
  const auto behind_bore = [&](double h) {
    return (h - downstream_depth_) *
           std::sqrt(gravity_ * (h + downstream_depth_) / (2.0 * h * downstream_depth_));
  };
  middle_depth_ = falling_root([&](double h) { return behind_rarefaction(h) - behind_bore(h); },
                               downstream_depth_, reservoir_depth_);
  middle_velocity_ = behind_rarefaction(middle_depth_);
  middle_celerity_ = std::sqrt(gravity_ * middle_depth_);
  // The form without hm - h1 in a denominator, which is small for a weak bore.
  bore_speed_ =
      std::sqrt(gravity_ * middle_depth_ * (middle_depth_ + downstream_depth_) / (2.0 * downstream_depth_));
}

double StokerSolution::depth(double x, double t) const {
  if (!(t > 0.0)) return x < 0.0 ? reservoir_depth_ : downstream_depth_;
  if (x <= rarefaction_end(t)) return reservoir_depth_;
  if (x >= bore(t)) return downstream_depth_;
  if (x >= middle_begin(t)) return middle_depth_;
  const double root = 2.0 * celerity_ - x / t;
  return root * root / (9.0 * gravity_);
}

double StokerSolution::velocity(double x, double t) const {
  if (x <= rarefaction_end(t) || x >= bore(t)) return 0.0;
  if (x >= middle_begin(t)) return middle_velocity_;
  return 2.0 / 3.0 * (celerity_ + x / t);
}

}  // namespace eisph
