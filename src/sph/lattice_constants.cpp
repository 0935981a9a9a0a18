#include "sph/lattice_constants.hpp"

#include "sph/pair_operators.hpp"

#include <cmath>

namespace eisph {

namespace {

template <int Dim, class Kernel>
LatticeConstants constants_of(double smoothing_ratio) {
  const double spacing = 1.0 / smoothing_ratio;
  const double volume = std::pow(spacing, Dim);
  const int reach = static_cast<int>(std::ceil(kKernelSupport / spacing));
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
        const auto pair = pair_geometry<Dim, double, Kernel>(centre, node);
        density.add(pair, volume);
        laplacian.add(pair, laplacian_weight(pair), volume, 0.0);
        const bool self = i == 0 && j == 0 && k == 0;
        if (!self && pair.q < kKernelSupport) ++constants.neighbours;
      }
    }
  }
  constants.number_density = Kernel::template normalisation<Dim>() * density.value;
  constants.laplacian = -2.0 * Kernel::template normalisation<Dim>() * laplacian.coefficient;
  return constants;
}

}  // namespace

template <int Dim>
LatticeConstants lattice_constants(KernelKind kernel, double smoothing_ratio) {
  return with_kernel(kernel, [&](auto type) { return constants_of<Dim, decltype(type)>(smoothing_ratio); });
}

template LatticeConstants lattice_constants<2>(KernelKind, double);
template LatticeConstants lattice_constants<3>(KernelKind, double);

}  // namespace eisph
