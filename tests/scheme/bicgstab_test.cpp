#include "scheme/bicgstab.hpp"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace eisph {
namespace {

/// A matrix without symmetry whose rows are dominated by the diagonal, and a right side.
struct LinearSystem {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right_side;

  explicit LinearSystem(int size) : matrix(size, size), right_side(size) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) matrix(i, j) = unit(generator);
      matrix(i, i) += 0.8 * size;
      right_side[i] = unit(generator);
    }
  }
  void apply(const std::vector<double>& in, std::vector<double>& out) const {
    const auto size = static_cast<Eigen::Index>(in.size());
    Eigen::Map<Eigen::VectorXd>(out.data(), size) =
        matrix * Eigen::Map<const Eigen::VectorXd>(in.data(), size);
  }
};

std::vector<double> solution(const LinearSystem& system, int threads, int& iterations) {
  ThreadPool pool(threads);
  BiCgStab solver(pool);
  std::vector<double> x(static_cast<std::size_t>(system.right_side.size()), 0.0);
  std::vector<double> residual(system.right_side.data(), system.right_side.data() + system.right_side.size());
  iterations =
      solver.solve(x, residual, 1e-10, 200, [&](const auto& in, auto& out) { system.apply(in, out); });
  return x;
}

TEST(BiCgStab, SolvesASystemWithoutSymmetry) {
  const LinearSystem system(120);
  int iterations = 0;
  const std::vector<double> x = solution(system, 1, iterations);
  const Eigen::VectorXd exact = system.matrix.partialPivLu().solve(system.right_side);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], exact[static_cast<Eigen::Index>(k)], 1e-10);
  EXPECT_LT(iterations, 40);
}

TEST(BiCgStab, GivesTheSameBitsWithAnyNumberOfThreads) {
  const LinearSystem system(3000);
  int iterations = 0;
  const std::vector<double> one = solution(system, 1, iterations);
  EXPECT_EQ(solution(system, 3, iterations), one);
}

TEST(BiCgStab, GivesTheBestThatItMetWhereItMayNotGoOn) {
  const LinearSystem system(120);
  ThreadPool pool(1);
  BiCgStab solver(pool);
  std::vector<double> x(120, 0.0);
  std::vector<double> residual(system.right_side.data(), system.right_side.data() + 120);
  const double before = system.right_side.norm();
  EXPECT_EQ(solver.solve(x, residual, 1e-12, 2, [&](const auto& in, auto& out) { system.apply(in, out); }),
            2);
  EXPECT_LT((system.right_side - system.matrix * Eigen::Map<Eigen::VectorXd>(x.data(), 120)).norm(), before);
}

}  // namespace
}  // namespace eisph
