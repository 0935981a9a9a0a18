#include "compare/ritter.hpp"

#include <cmath>
#include <stdexcept>

namespace eisph {

RitterSolution::RitterSolution(double reservoir_depth, double gravity)
    : reservoir_depth_(reservoir_depth), gravity_(gravity), celerity_(std::sqrt(gravity * reservoir_depth)) {
  if (!(reservoir_depth > 0.0) || !(gravity > 0.0)) {
    throw std::invalid_argument("Ritter's solution needs a positive depth and gravity");
  }
}

double RitterSolution::depth(double x, double t) const {
  if (!(t > 0.0)) return x < 0.0 ? reservoir_depth_ : 0.0;
  if (x <= rarefaction_end(t)) return reservoir_depth_;
  if (x >= front(t)) return 0.0;
  const double root = 2.0 * celerity_ - x / t;
  return root * root / (9.0 * gravity_);
}

double RitterSolution::velocity(double x, double t) const {
  if (x <= rarefaction_end(t) || x >= front(t)) return 0.0;
  return 2.0 / 3.0 * (celerity_ + x / t);
}

}  // namespace eisph
