#pragma once

#include "sph/pair_operators.hpp"

#include <cmath>

#include <Eigen/Dense>

namespace eisph {

/// The renormalisation L of gradients in difference form (Randles & Libersky 1996): the inverse of their
/// first moments. Where the neighbours do not span the space it is the unit matrix.
template <int Dim>
class GradientCorrection {
 public:
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  using Column = Eigen::Matrix<double, Dim, 1>;

  /// `moments` over a neighbourhood, `alpha` the normalisation of the kernel, m^-Dim.
  template <class Real>
  GradientCorrection(const MomentSum<Dim, Real>& moments, double alpha) : alpha_(alpha) {
    Matrix m;
    int entry = Dim;
    for (int a = 0; a < Dim; ++a) {
      m(a, a) = alpha * horizontal_sum(moments.value.x[a]);
      for (int b = a + 1; b < Dim; ++b) m(a, b) = m(b, a) = alpha * horizontal_sum(moments.value.x[entry++]);
    }
    // The moments of a full neighbourhood are the unit matrix, on a straight free surface about half of it.
    regular_ = m.determinant() > kSmallestDeterminant;
    if (regular_) inverse_ = m.inverse();
  }

  [[nodiscard]] bool regular() const { return regular_; }

  /// The gradient per smoothing length.
  template <class Real>
  [[nodiscard]] Column gradient(const ScalarGradientSum<Dim, Real>& sum) const {
    Column plain;
    for (int d = 0; d < Dim; ++d) plain[d] = alpha_ * horizontal_sum(sum.value.x[d]);
    return inverse_ * plain;
  }

 private:
  static constexpr double kSmallestDeterminant = 0.02;

  double alpha_;
  bool regular_ = false;
  Matrix inverse_ = Matrix::Identity();
};

}  // namespace eisph
