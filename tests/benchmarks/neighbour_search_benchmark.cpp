// Three ways to find all neighbours within the support radius (De Castro 2019, section 3.3.2): all pairs, a
// k-d tree (nanoflann) and cells with linked lists as the solver has them. Each benchmark searches for 10^3
// to 10^6 particles of a randomly displaced lattice, everything built anew as in every step, on one thread.
// Counters: seconds for each number of particles (the best of three), and the exponent p of time = c N^p,
// fitted by least squares to the logarithms.

#include "sph/particle_cloud.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <nanoflann.hpp>

namespace {

using namespace eisph;

constexpr double kSpacing = 1.0 / 1.32;  ///< smoothing lengths
constexpr float kSupportSquared = 4.0F;  ///< smoothing lengths
constexpr int kRepetitions = 3;
constexpr double kMostPairs = 2e9;  ///< beyond which all pairs are not tried

/// A cube of about `count` particles, each displaced by up to a fifth of the spacing.
std::vector<Float4> displaced_lattice(std::size_t count) {
  const auto side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(count))));
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> displacement(-0.2, 0.2);
  std::vector<Float4> points;
  for (int k = 0; k < side; ++k) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const auto at = [&](int node) {
          return static_cast<float>(kSpacing * (node + 0.5 + displacement(generator)));
        };
        points.push_back({at(i), at(j), at(k), 0.0F});
      }
    }
  }
  return points;
}

/// Number of neighbours found, the particles themselves among them.
std::size_t all_pairs(const std::vector<Float4>& points) {
  std::vector<std::vector<std::uint32_t>> lists(points.size());
  std::size_t found = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      const float x = points[i].x - points[j].x;
      const float y = points[i].y - points[j].y;
      const float z = points[i].z - points[j].z;
      if (x * x + y * y + z * z < kSupportSquared) lists[i].push_back(static_cast<std::uint32_t>(j));
    }
    found += lists[i].size();
  }
  return found;
}

/// What nanoflann asks of a cloud of points.
struct TreePoints {
  const std::vector<Float4>& points;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] float kdtree_get_pt(std::size_t index, std::size_t axis) const {
    return (&points[index].x)[axis];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

std::size_t tree(const std::vector<Float4>& points) {
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, TreePoints>, TreePoints, 3>;
  const TreePoints cloud{points};
  Tree index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  index.buildIndex();
  std::vector<std::vector<std::pair<std::uint32_t, float>>> lists(points.size());
  nanoflann::SearchParams parameters;
  parameters.sorted = false;
  std::size_t found = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    found += index.radiusSearch(&points[i].x, kSupportSquared, lists[i], parameters);
  return found;
}

std::size_t linked_list(const std::vector<Float4>& points) {
  const double extent = kSpacing * std::cbrt(static_cast<double>(points.size()));
  const ParticleCloud<3> cloud({extent, extent, extent}, {{{}, {}, points, {}}});
  NeighbourList<3> list;
  ThreadPool pool(1);
  cloud.build(list, pool);
  std::size_t found = 0;
  for (std::uint32_t i = cloud.table().first_fluid; i < cloud.table().first_image; ++i) {
    const Neighbours near = list.of(i);
    found += static_cast<std::size_t>(std::count_if(
        near.begin, near.end, [](std::uint32_t index) { return index != SourceTable::kNothing; }));
  }
  return found;
}

/// Best of some repetitions, s.
double seconds(std::size_t (*search)(const std::vector<Float4>&), const std::vector<Float4>& points,
               std::size_t& found) {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kRepetitions; ++k) {
    const auto start = std::chrono::steady_clock::now();
    found = search(points);
    benchmark::DoNotOptimize(found);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void search_method(benchmark::State& run, std::size_t (*search)(const std::vector<Float4>&), bool quadratic) {
  std::vector<double> logarithms[2];
  for (auto _ : run) {
    for (const std::size_t count : {1'000U, 8'000U, 27'000U, 125'000U, 1'000'000U}) {
      const std::vector<Float4> points = displaced_lattice(count);
      if (quadratic && std::pow(static_cast<double>(points.size()), 2) > kMostPairs) continue;
      std::size_t found = 0;
      const double time = seconds(search, points, found);
      run.counters[fmt::format("s_{}", count)] = time;
      run.counters[fmt::format("near_{}", count)] =
          static_cast<double>(found) / static_cast<double>(points.size());
      logarithms[0].push_back(std::log(static_cast<double>(points.size())));
      logarithms[1].push_back(std::log(time));
    }
  }
  double mean[2] = {0.0, 0.0};
  const auto size = static_cast<double>(logarithms[0].size());
  for (int axis = 0; axis < 2; ++axis) {
    for (const double value : logarithms[axis]) mean[axis] += value / size;
  }
  double squares = 0.0;
  double products = 0.0;
  for (std::size_t k = 0; k < logarithms[0].size(); ++k) {
    squares += std::pow(logarithms[0][k] - mean[0], 2);
    products += (logarithms[0][k] - mean[0]) * (logarithms[1][k] - mean[1]);
  }
  run.counters["exponent"] = products / squares;
}

BENCHMARK_CAPTURE(search_method, all_pairs, all_pairs, true)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(search_method, tree, tree, false)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(search_method, linked_list, linked_list, false)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
