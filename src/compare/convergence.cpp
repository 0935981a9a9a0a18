#include "compare/convergence.hpp"

#include "compare/curve.hpp"

#include <cmath>
#include <stdexcept>

namespace eisph {

ConvergenceOrder observed_order(const std::vector<double>& spacings, const std::vector<double>& errors) {
  if (spacings.size() != errors.size() || spacings.size() < 2) {
    throw std::invalid_argument("An order of convergence needs two spacings or more, and an error for each");
  }
  std::vector<double> log_spacings;
  std::vector<double> log_errors;
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    if (!(spacings[k] > 0.0) || !(errors[k] > 0.0)) {
      throw std::invalid_argument("An order of convergence needs positive spacings and errors");
    }
    log_spacings.push_back(std::log(spacings[k]));
    log_errors.push_back(std::log(errors[k]));
  }
  const Curve curve = make_curve(log_spacings, log_errors);
  if (curve.size() != spacings.size()) {
    throw std::invalid_argument("An order of convergence needs spacings that differ");
  }
  ConvergenceOrder order;
  order.least_squares = mean_slope(curve, curve.x.front(), curve.x.back());
  for (std::size_t k = curve.size() - 1; k > 0; --k) {
    order.pairwise.push_back((curve.y[k] - curve.y[k - 1]) / (curve.x[k] - curve.x[k - 1]));
  }
  return order;
}

}  // namespace eisph
