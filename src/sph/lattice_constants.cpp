#include "sph/lattice_constants.hpp"

#include "sph/pair_operators.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace eisph {

namespace {

/// Wave numbers per axis that are tried, from zero to the shortest wave that the lattice holds (2 dx).
constexpr int kWaveNumbers = 9;

/// Calls visit(node, is_centre) for every node within the kernel's reach of the origin, in smoothing lengths.
template <int Dim, class Kernel, class Visit>
void visit_nodes(double spacing, const Visit& visit) {
  const int reach = static_cast<int>(std::ceil(Kernel::kReach / spacing));
  for (int k = Dim == 3 ? -reach : 0; k <= (Dim == 3 ? reach : 0); ++k) {
    for (int j = -reach; j <= reach; ++j) {
      for (int i = -reach; i <= reach; ++i) {
        Vector<Dim, double> node;
        node.x[0] = spacing * i;
        node.x[1] = spacing * j;
        if constexpr (Dim == 3) node.x[2] = spacing * k;
        double squared = 0.0;
        for (const double component : node.x) squared += component * component;
        if (squared >= Kernel::kReach * Kernel::kReach) continue;
        visit(node, i == 0 && j == 0 && k == 0);
      }
    }
  }
}

/// A wave of velocity with wave vector k and polarisation e decays at the rate e . M e nu / h^2 with
///   M = 2 (D + 2) sum a_j (1 - cos(k . xi_j)) xi_j (x) xi_j   under ViscousSum,
///   M = 2 sum a_j (1 - cos(k . xi_j)) q_j^2                   under VelocityLaplacianSum,
/// a_j = alpha h^Dim V_j |dW/dq|/q / q^2.
template <int Dim, class Kernel>
void find_viscous_eigenvalues(double spacing, LatticeConstants& constants) {
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  using Column = Eigen::Matrix<double, Dim, 1>;
  const double volume = std::pow(spacing, Dim);
  const double factor = 2.0 * Kernel::template normalisation<Dim>();
  std::vector<std::pair<Column, double>> terms;
  visit_nodes<Dim, Kernel>(spacing, [&](const Vector<Dim, double>& node, bool is_centre) {
    if (is_centre) return;
    const auto pair = pair_geometry<Dim, double, Kernel>(Vector<Dim, double>{}, node);
    Column offset;
    for (int d = 0; d < Dim; ++d) offset[d] = node.x[d];
    terms.emplace_back(offset, -factor * volume * pair.gradient / pair.squared);
  });
  const int waves = Dim == 2 ? kWaveNumbers * kWaveNumbers : kWaveNumbers * kWaveNumbers * kWaveNumbers;
  for (int n = 0; n < waves; ++n) {
    Column wave;
    int rest = n;
    for (int d = 0; d < Dim; ++d) {
      wave[d] = std::numbers::pi / spacing * (rest % kWaveNumbers) / (kWaveNumbers - 1);
      rest /= kWaveNumbers;
    }
    Matrix decay = Matrix::Zero();
    for (const auto& [offset, weight] : terms) {
      decay += weight * (1.0 - std::cos(wave.dot(offset))) * offset * offset.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(decay, Eigen::EigenvaluesOnly);
    constants.radial_viscous_eigenvalue =
        std::max(constants.radial_viscous_eigenvalue, (Dim + 2) * solver.eigenvalues()[Dim - 1]);
    constants.viscous_eigenvalue = std::max(constants.viscous_eigenvalue, decay.trace());
  }
}

template <int Dim, class Kernel>
LatticeConstants constants_of(double smoothing_ratio) {
  const double spacing = 1.0 / smoothing_ratio;
  const double volume = std::pow(spacing, Dim);
  DensitySum<double> density;
  LaplacianSums<double> laplacian;
  double spread = 0.0;
  LatticeConstants constants;
  visit_nodes<Dim, Kernel>(spacing, [&](const Vector<Dim, double>& node, bool is_centre) {
    const auto pair = pair_geometry<Dim, double, Kernel>(Vector<Dim, double>{}, node);
    density.add(pair, volume);
    spread += volume * pair.value() * node.x[0] * node.x[0];
    if (is_centre) return;
    laplacian.add(pair, volume, 0.0);
    ++constants.neighbours;
  });
  constants.number_density = Kernel::template normalisation<Dim>() * density.value;
  constants.spread = spread / density.value;
  constants.laplacian = -2.0 * Kernel::template normalisation<Dim>() * laplacian.coefficient;
  find_viscous_eigenvalues<Dim, Kernel>(spacing, constants);
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
