#pragma once

#include "core/thread_pool.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace eisph {

/// Solves A x = b for a matrix that need not be symmetric by the stabilised method of bi-conjugate gradients
/// (van der Vorst 1992, SIAM J. Sci. Stat. Comput. 13). Sums are taken block by block in order, so that
/// results do not depend on the number of threads.
class BiCgStab {
 public:
  explicit BiCgStab(ThreadPool& pool) : pool_(pool) {}

  /// `apply(v, out)` writes A v. `x` holds the first guess and `residual` b - A x; both are brought up to
  /// date. Ends when the norm of the residual is below `target`, after `most_iterations`, or where the method
  /// breaks down; x is then the best that was met. Returns the number of iterations, of two products each.
  template <class Apply>
  int solve(std::vector<double>& x, std::vector<double>& residual, double target, int most_iterations,
            const Apply& apply) {
    const std::size_t count = x.size();
    start(residual);
    best_ = x;
    double norm = std::sqrt(dot(residual, residual));
    double best_norm = norm;
    double rho = 1.0;
    double alpha = 1.0;
    double omega = 1.0;
    int iteration = 0;
    for (; iteration < most_iterations && norm > target; ++iteration) {
      const double next = dot(shadow_, residual);
      const double beta = next / rho * alpha / omega;
      rho = next;
      each(count, [&](std::size_t k) {
        direction_[k] = residual[k] + beta * (direction_[k] - omega * product_[k]);
      });
      apply(direction_, product_);
      alpha = rho / dot(shadow_, product_);
      each(count, [&](std::size_t k) {
        residual[k] -= alpha * product_[k];
        x[k] += alpha * direction_[k];
      });
      apply(residual, second_);
      omega = dot(second_, residual) / dot(second_, second_);
      each(count, [&](std::size_t k) {
        x[k] += omega * residual[k];
        residual[k] -= omega * second_[k];
      });
      norm = std::sqrt(dot(residual, residual));
      if (!std::isfinite(norm) || norm > kDivergence * best_norm) break;
      if (norm < best_norm) {
        best_norm = norm;
        best_ = x;
      }
    }
    x = best_;
    return iteration;
  }

  /// sum a_k b_k
  [[nodiscard]] double dot(const std::vector<double>& a, const std::vector<double>& b) {
    sums_.assign((a.size() + kBlock - 1) / kBlock, 0.0);
    pool_.run_blocks(a.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
      double sum = 0.0;
      for (std::size_t k = first; k < last; ++k) sum += a[k] * b[k];
      sums_[first / kBlock] = sum;
    });
    double total = 0.0;
    for (const double sum : sums_) total += sum;
    return total;
  }

 private:
  static constexpr std::size_t kBlock = 1024;
  static constexpr double kDivergence = 1e4;  ///< of the residual over the smallest met, at which to give up

  template <class Body>
  void each(std::size_t count, const Body& body) {
    pool_.run_blocks(count, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) body(k);
    });
  }

  void start(const std::vector<double>& residual) {
    shadow_ = residual;
    for (std::vector<double>* array : {&direction_, &product_, &second_}) array->assign(residual.size(), 0.0);
  }

  ThreadPool& pool_;
  std::vector<double> shadow_, direction_, product_, second_, best_, sums_;
};

}  // namespace eisph
