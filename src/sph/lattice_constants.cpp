#include "sph/lattice_constants.hpp"

#include "sph/pair_operators.hpp"

#include <cmath>

namespace eisph {

template <int Dim>
LatticeConstants lattice_constants(double smoothing_ratio) {
  const double spacing = 1.0 / smoothing_ratio;
  const double volume = std::pow(spacing, Dim);
  const int reach = static_cast<int>(std::ceil(cubic_spline::kSupport / spacing));
  const Vector<Dim, double> centre{};
  DensitySum<double> density;
  LaplacianSums<double> laplacian;
  LatticeConstants constants;
  for (int k = Dim == 3 ? -reach : 0; k <= (Dim == 3 ? reach : 0); ++k) {
    for (int j = -reach; j <= reach; ++j) {
      for (int i = -reach; i <= reach; ++i) {
        Vector<Dim, double> node;
        node.x[0] = spacing * i;
        node.x[1] = spacing * j;
        if constexpr (Dim == 3) node.x[2] = spacing * k;
        const auto pair = pair_geometry<Dim, double>(centre, node);
        density.add(pair, volume);
        laplacian.add(pair, laplacian_weight(pair), volume, 0.0);
        const bool self = i == 0 && j == 0 && k == 0;
        if (!self && pair.q < cubic_spline::kSupport) ++constants.neighbours;
      }
    }
  }
  constants.number_density = cubic_spline::normalisation<Dim>() * density.value;
  constants.laplacian = -2.0 * cubic_spline::normalisation<Dim>() * laplacian.coefficient;
  return constants;
}

template LatticeConstants lattice_constants<2>(double);
template LatticeConstants lattice_constants<3>(double);

}  // namespace eisph
