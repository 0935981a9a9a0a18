#include "core/pack.hpp"

#include "sph/pair_operators.hpp"

#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Relative difference allowed between single and double precision: a sum of three squares, a reciprocal
/// square root good to 2e-7 and a cubic whose terms cancel near the support.
constexpr double kSingle = 2e-6;

template <int Dim>
struct EightPairs {
  Vector<Dim, Pack> offset_pack{};
  Vector<Dim, Pack> vector_i{};
  Vector<Dim, Pack> vector_j{};
  Pack volume{};
  Pack pressure_i{};
  Pack pressure_j{};

  explicit EightPairs(unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> offset(-1.2F, 1.2F);
    std::uniform_real_distribution<float> unit(0.5F, 1.5F);
    for (std::size_t lane = 0; lane < kPackWidth; ++lane) {
      for (int d = 0; d < Dim; ++d) {
        offset_pack.x[d][lane] = offset(generator);
        vector_i.x[d][lane] = offset(generator);
        vector_j.x[d][lane] = offset(generator);
      }
      volume[lane] = unit(generator);
      pressure_i[lane] = unit(generator);
      pressure_j[lane] = unit(generator);
    }
  }
  static Vector<Dim, double> lane_of(const Vector<Dim, Pack>& pack, std::size_t lane) {
    Vector<Dim, double> vector;
    for (int d = 0; d < Dim; ++d) vector.x[d] = pack.x[d][lane];
    return vector;
  }
};

template <int Dim>
void expect_pack_operators_equal_double() {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const EightPairs<Dim> eight(seed);
    const Vector<Dim, Pack> origin{};
    const auto pack = pair_geometry<Dim, Pack, CubicSpline>(origin, eight.offset_pack);
    LaplacianSums<Pack> laplacian;
    DensitySum<Pack> density;
    ViscousSum<Dim, Pack> viscous;
    DivergenceSum<Pack> divergence;
    PressureGradientSum<Dim, Pack> gradient;
    laplacian.add(pack, eight.volume, eight.pressure_j);
    density.add(pack, eight.volume);
    viscous.add(pack, eight.volume, eight.vector_i, eight.vector_j);
    divergence.add(pack, eight.volume, eight.vector_i, eight.vector_j);
    gradient.add(pack, eight.volume, eight.pressure_i, eight.pressure_j);

    for (std::size_t lane = 0; lane < kPackWidth; ++lane) {
      const Vector<Dim, double> zero{};
      const auto u_i = EightPairs<Dim>::lane_of(eight.vector_i, lane);
      const auto u_j = EightPairs<Dim>::lane_of(eight.vector_j, lane);
      const double volume = eight.volume[lane];
      const auto pair =
          pair_geometry<Dim, double, CubicSpline>(zero, EightPairs<Dim>::lane_of(eight.offset_pack, lane));
      LaplacianSums<double> lane_laplacian;
      DensitySum<double> lane_density;
      ViscousSum<Dim, double> lane_viscous;
      DivergenceSum<double> lane_divergence;
      PressureGradientSum<Dim, double> lane_gradient;
      lane_laplacian.add(pair, volume, static_cast<double>(eight.pressure_j[lane]));
      lane_density.add(pair, volume);
      lane_viscous.add(pair, volume, u_i, u_j);
      lane_divergence.add(pair, volume, u_i, u_j);
      lane_gradient.add(pair, volume, static_cast<double>(eight.pressure_i[lane]),
                        static_cast<double>(eight.pressure_j[lane]));

      // Terms are at most about 10 in these units.
      EXPECT_NEAR(laplacian.coefficient[lane], lane_laplacian.coefficient, 10.0 * kSingle);
      EXPECT_NEAR(laplacian.pressure[lane], lane_laplacian.pressure, 10.0 * kSingle);
      EXPECT_NEAR(density.value[lane], lane_density.value, kSingle);
      EXPECT_NEAR(divergence.value[lane], lane_divergence.value, 10.0 * kSingle);
      for (int d = 0; d < Dim; ++d) {
        EXPECT_NEAR(viscous.value.x[d][lane], lane_viscous.value.x[d], 10.0 * kSingle);
        EXPECT_NEAR(gradient.value.x[d][lane], lane_gradient.value.x[d], 10.0 * kSingle);
      }
    }
  }
}

TEST(Pack, OperatorsEqualDoubleOperatorsLaneByLane) {
  expect_pack_operators_equal_double<2>();
  expect_pack_operators_equal_double<3>();
}

TEST(Pack, ReciprocalSquareRootHoldsItsAccuracyOverManyOrdersOfMagnitude) {
  for (int power = 0; power < 108; ++power) {
    const auto value = static_cast<float>(1e-12 * std::pow(1.7, power));
    const float result = reciprocal_sqrt(splat<Pack>(value))[3];
    EXPECT_NEAR(result * std::sqrt(static_cast<double>(value)), 1.0, 3e-7) << "at " << value;
  }
}

TEST(Pack, PositivePartActsOnEachLane) {
  constexpr std::array<float, 8> kValues = {-1.0F, 0.0F, 2.0F, -3.5F, 4.0F, -0.0F, 1e-30F, -1e30F};
  Pack value{};
  for (std::size_t lane = 0; lane < kPackWidth; ++lane) value[lane] = kValues[(lane + lane / 8) % 8];
  const Pack result = positive_part(value);
  for (std::size_t lane = 0; lane < kPackWidth; ++lane) EXPECT_EQ(result[lane], std::max(value[lane], 0.0F));
}

TEST(Pack, HorizontalSumAddsAllLanes) {
  Pack value{};
  for (std::size_t lane = 0; lane < kPackWidth; ++lane) value[lane] = static_cast<float>(1U << lane);
  EXPECT_EQ(horizontal_sum(value), std::exp2(kPackWidth) - 1.0);
}

TEST(Pack, GatheredRowsAreThoseOfTheTable) {
  std::vector<Float4> table(100);
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto value = static_cast<float>(row);
    table[row] = {value, value + 0.25F, value + 0.5F, value + 0.75F};
  }
  std::array<std::uint32_t, kPackWidth> index{};
  for (std::uint32_t lane = 0; lane < kPackWidth; ++lane) index[lane] = (17 + 86 * lane * lane) % 100;
  const PackRows rows = gather_rows(table.data(), index.data());
  for (std::size_t lane = 0; lane < kPackWidth; ++lane) {
    const Float4& row = table[index[lane]];
    EXPECT_EQ(rows.x[lane], row.x);
    EXPECT_EQ(rows.y[lane], row.y);
    EXPECT_EQ(rows.z[lane], row.z);
    EXPECT_EQ(rows.w[lane], row.w);
  }
}

TEST(Pack, HasOnesWhereTheIndexIsBelowTheLimit) {
  constexpr std::array<std::uint32_t, 8> kIndices = {17, 3, 99, 0, 16, 42, 18, 2'000'000'000};
  std::array<std::uint32_t, kPackWidth> index{};
  for (std::size_t lane = 0; lane < kPackWidth; ++lane) index[lane] = kIndices[(lane + lane / 8) % 8];
  const Pack ones = ones_below(index.data(), 18);
  for (std::size_t lane = 0; lane < kPackWidth; ++lane) {
    EXPECT_EQ(ones[lane], index[lane] < 18 ? 1.0F : 0.0F) << lane;
  }
}

TEST(Pack, AppendsThoseBelowTheLimitInOrderForEveryPatternOfLanes) {
  std::array<std::uint32_t, kPackWidth> index{};
  for (std::uint32_t lane = 0; lane < kPackWidth; ++lane) index[lane] = 10 + lane;
  for (unsigned pattern = 0; pattern < 1U << kPackWidth; ++pattern) {
    Pack squared{};
    std::vector<std::uint32_t> expected;
    for (std::size_t lane = 0; lane < kPackWidth; ++lane) {
      const bool below = (pattern >> lane & 1U) != 0;
      squared[lane] = below ? 3.999F : 4.0F;  // at the limit is not below it
      if (below) expected.push_back(index[lane]);
    }
    std::array<std::uint32_t, kPackWidth> out{};
    const std::size_t count = append_below(squared, 4.0F, index.data(), out.data());
    const std::vector<std::uint32_t> appended(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count));
    EXPECT_EQ(appended, expected) << "pattern " << pattern;
  }
}

}  // namespace
}  // namespace eisph
