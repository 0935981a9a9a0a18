#include "probe/nearest_neighbours.hpp"

#include "probe/hand_made.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// The same by looking at every pair.
NeighbourDistances by_brute_force(const Snapshot& snapshot) {
  std::vector<double> nearest;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < snapshot.size(); ++j) {
      Vec3d offset = snapshot.position[i].cast<double>() - snapshot.position[j].cast<double>();
      if (snapshot.dimension == 2) offset.y() = 0.0;
      if (i != j) least = std::min(least, offset.norm());
    }
    nearest.push_back(least / snapshot.particle_spacing);
  }
  std::sort(nearest.begin(), nearest.end());
  NeighbourDistances result;
  result.particles = nearest.size();
  const auto count = static_cast<double>(nearest.size());
  const auto upper = [&](double distance) {
    return static_cast<std::size_t>(std::upper_bound(nearest.begin(), nearest.end(), distance) -
                                    nearest.begin());
  };
  result.paired_fraction = static_cast<double>(upper(0.6)) / count;
  result.isolated_particles = nearest.size() - upper(2.0);
  result.isolated_fraction = static_cast<double>(result.isolated_particles) / count;
  // The least value that at least 5 % of the particles do not exceed.
  for (const double value : nearest) {
    if (static_cast<double>(upper(value)) < 0.05 * count) continue;
    result.nearest_distance_p5 = std::min(value, 2.0);
    break;
  }
  return result;
}

void expect_equal(const NeighbourDistances& found, const NeighbourDistances& expected) {
  EXPECT_EQ(found.particles, expected.particles);
  EXPECT_EQ(found.paired_fraction, expected.paired_fraction);
  EXPECT_NEAR(found.nearest_distance_p5, expected.nearest_distance_p5, 1e-12);
  EXPECT_EQ(found.isolated_particles, expected.isolated_particles);
  EXPECT_EQ(found.isolated_fraction, expected.isolated_fraction);
}

class NearestNeighboursTest : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] NeighbourDistances distances_of(const std::vector<Vec3f>& positions) const {
    return neighbour_distances(hand_made_snapshot(scene_, positions));
  }
  /// Particles at random in a box of `sides` (dx) about the middle of the tank. In 2D their y differ, which
  /// is not to count.
  [[nodiscard]] std::vector<Vec3f> random_cloud(std::size_t count, double sides, unsigned seed) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-0.5 * sides, 0.5 * sides);
    std::vector<Vec3f> positions;
    while (positions.size() < count) {
      const Vec3d offset(place(random), place(random), place(random));
      positions.emplace_back((Vec3d(0.5, 0.25, 0.35) + scene_.particle_spacing * offset).cast<float>());
    }
    return positions;
  }

  Scene scene_ = hand_made_scene(GetParam());
};

TEST_P(NearestNeighboursTest, AgreeWithAllPairsFromDenseToScattered) {
  for (const double sides : {6.0, 10.0, 20.0, 60.0, 2000.0}) {
    std::vector<Vec3f> positions = random_cloud(400, sides, static_cast<unsigned>(sides));
    for (std::size_t k = 0; k < 8; ++k) positions.push_back(positions[7 * k]);  // at the same place
    positions.emplace_back(50.0F, 0.25F, 40.0F);                                // far from all others
    const Snapshot snapshot = hand_made_snapshot(scene_, positions);
    const NeighbourDistances expected = by_brute_force(snapshot);
    expect_equal(neighbour_distances(snapshot), expected);
    EXPECT_GE(expected.paired_fraction, 16.0 / 409.0);
    EXPECT_GE(expected.isolated_particles, 1U);
  }
}

TEST_P(NearestNeighboursTest, AgreeWithAllPairsInShakenWaterWithSprayAboveIt) {
  Snapshot water = hand_made_snapshot(scene_, lattice(scene_, Vec3d(0.4, 0.2, 0.2)));
  shake(water, 0.4 * scene_.particle_spacing);
  std::vector<Vec3f> positions = water.position;
  for (int k = 0; k < 20; ++k)
    positions.emplace_back(0.05F * static_cast<float>(k), 0.1F, 0.35F + 0.01F * static_cast<float>(k % 7));
  const Snapshot snapshot = hand_made_snapshot(scene_, positions);
  const NeighbourDistances expected = by_brute_force(snapshot);
  expect_equal(neighbour_distances(snapshot), expected);
  EXPECT_GT(expected.paired_fraction, 0.0);
  EXPECT_LT(expected.paired_fraction, 1.0);
  EXPECT_GT(expected.isolated_particles, 10U);
}

TEST_P(NearestNeighboursTest, OfALatticeAreOneSpacingAway) {
  const NeighbourDistances distances = distances_of(lattice(scene_, Vec3d(0.4, 0.2, 0.2)));
  EXPECT_EQ(distances.paired_fraction, 0.0);
  EXPECT_NEAR(distances.nearest_distance_p5, 1.0, 1e-5);
  EXPECT_EQ(distances.isolated_particles, 0U);
}

TEST_P(NearestNeighboursTest, CountParticlesAtTheSamePlaceAsPairs) {
  const NeighbourDistances distances =
      distances_of({{0.5F, 0.1F, 0.2F}, {0.5F, 0.1F, 0.2F}, {0.7F, 0.1F, 0.2F}});
  EXPECT_DOUBLE_EQ(distances.paired_fraction, 2.0 / 3.0);
  EXPECT_EQ(distances.nearest_distance_p5, 0.0);
  EXPECT_EQ(distances.isolated_particles, 1U);
  EXPECT_DOUBLE_EQ(distances.isolated_fraction, 1.0 / 3.0);
}

TEST_P(NearestNeighboursTest, TellWhatIsJustWithinALimit) {
  const auto apart = [&](double spacings) {
    const double z = 0.2 + spacings * scene_.particle_spacing;
    return distances_of({{0.0F, 0.0F, 0.2F}, {0.0F, 0.0F, static_cast<float>(z)}});
  };
  EXPECT_EQ(apart(0.5999).paired_fraction, 1.0);
  EXPECT_EQ(apart(0.6001).paired_fraction, 0.0);
  EXPECT_NEAR(apart(0.6001).nearest_distance_p5, 0.6001, 1e-5);
  EXPECT_EQ(apart(1.9999).isolated_particles, 0U);
  EXPECT_EQ(apart(2.0001).isolated_particles, 2U);
}

TEST_P(NearestNeighboursTest, OfASingleParticleAndOfNone) {
  const NeighbourDistances one = distances_of({{0.5F, 0.1F, 0.2F}});
  EXPECT_EQ(one.particles, 1U);
  EXPECT_EQ(one.paired_fraction, 0.0);
  EXPECT_EQ(one.nearest_distance_p5, 2.0);
  EXPECT_EQ(one.isolated_fraction, 1.0);
  const NeighbourDistances none = distances_of({});
  EXPECT_EQ(none.particles, 0U);
  EXPECT_EQ(none.paired_fraction, 0.0);
  EXPECT_EQ(none.isolated_fraction, 0.0);
  EXPECT_TRUE(std::isnan(none.nearest_distance_p5));
}

TEST_P(NearestNeighboursTest, LeaveOutWhatIsNotANumber) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const NeighbourDistances distances = distances_of({{nan, 0.1F, 0.2F}, {0.5F, 0.1F, 0.2F}});
  EXPECT_EQ(distances.particles, 1U);
  EXPECT_EQ(distances.isolated_particles, 1U);
}

INSTANTIATE_TEST_SUITE_P(Dimension, NearestNeighboursTest, testing::Values(2, 3));

TEST(NeighbourHistory, KeepsTheWorstOfEachFigureAndTheLast) {
  NeighbourHistory history;
  history.add({.particles = 10,
               .paired_fraction = 0.4,
               .nearest_distance_p5 = 0.5,
               .isolated_particles = 1,
               .isolated_fraction = 0.1});
  history.add({.particles = 8,
               .paired_fraction = 0.1,
               .nearest_distance_p5 = 0.9,
               .isolated_particles = 2,
               .isolated_fraction = 0.25});
  EXPECT_EQ(history.worst.paired_fraction, 0.4);
  EXPECT_EQ(history.worst.nearest_distance_p5, 0.5);
  EXPECT_EQ(history.worst.isolated_particles, 2U);
  EXPECT_EQ(history.worst.isolated_fraction, 0.25);
  EXPECT_EQ(history.last.paired_fraction, 0.1);
  EXPECT_EQ(history.last.particles, 8U);
}

}  // namespace
}  // namespace eisph
