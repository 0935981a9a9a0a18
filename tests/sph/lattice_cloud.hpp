#pragma once

#include "sph/pair_operators.hpp"

#include <cmath>
#include <vector>

namespace eisph {

inline constexpr double kSmoothingRatio = 1.32;  ///< h / dx of all lattices in these tests

/// Nodes of the undisturbed lattice, in smoothing lengths, within a little more than the support of the
/// origin, which is one of them.
template <int Dim>
struct LatticeCloud {
  double spacing = 1.0 / kSmoothingRatio;
  double volume = std::pow(spacing, Dim);
  std::vector<Vector<Dim, double>> nodes;

  explicit LatticeCloud(double smoothing_ratio = kSmoothingRatio) : spacing(1.0 / smoothing_ratio) {
    const int reach = static_cast<int>(2.0 * smoothing_ratio) + 1;
    const int depth = Dim == 3 ? reach : 0;
    for (int k = -depth; k <= depth; ++k) {
      for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
          Vector<Dim, double> node{};
          node.x[0] = spacing * i;
          node.x[Dim - 1] = spacing * j;
          if constexpr (Dim == 3) node.x[1] = spacing * k;
          nodes.push_back(node);
        }
      }
    }
  }

  /// Calls visit(pair, node) with the geometry between the origin and every node.
  template <class Visit>
  void for_pairs(const Visit& visit) const {
    const Vector<Dim, double> origin{};
    for (const auto& node : nodes) visit(pair_geometry<Dim, double, CubicSpline>(origin, node), node);
  }
};

}  // namespace eisph
