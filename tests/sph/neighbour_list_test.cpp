#include "sph/neighbour_list.hpp"

#include "sph/particle_cloud.hpp"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Pairs whose squared distance is this close to that of the support may be in a list or not: single
/// precision decides.
constexpr double kUndecided = 1e-4;
constexpr double kSupportSquared = 4.0;

/// Entries of a list without the filling, after checking that the filling is whole and at the end.
std::vector<std::uint32_t> entries(const Neighbours& near) {
  std::vector<std::uint32_t> list(near.begin, near.end);
  EXPECT_EQ(list.size() % kPackWidth, 0U);
  std::size_t filling = 0;
  while (!list.empty() && list.back() == SourceTable::kNothing) {
    list.pop_back();
    ++filling;
  }
  EXPECT_LT(filling, kPackWidth);
  EXPECT_EQ(std::count(list.begin(), list.end(), SourceTable::kNothing), 0);
  return list;
}

/// Compares the list of row `index` with a search through the whole table.
template <int Dim>
void expect_list(const ParticleCloud<Dim>& cloud, const NeighbourList<Dim>& list, std::uint32_t index) {
  const SourceTable& table = cloud.table();
  const Neighbours near = list.of(index);
  const auto found = entries(near);
  const std::set<std::uint32_t> unique(found.begin(), found.end());
  ASSERT_EQ(unique.size(), found.size()) << "an entry comes twice";
  EXPECT_EQ(unique.count(index), 0U) << "the particle itself";
  bool object_found = false;
  for (std::uint32_t j = 1; j < table.end; ++j) {
    if (j == index) continue;
    const double squared = cloud.squared_distance(index, j);
    const bool listed = unique.count(j) == 1;
    const bool decided = std::abs(squared - kSupportSquared) > kUndecided;
    ASSERT_TRUE(!decided || listed == (squared < kSupportSquared)) << index << " and " << j;
    object_found |= listed && j < table.first_fluid;
  }
  EXPECT_EQ(near.near_object, object_found);
}

/// Compares the list of object `index` with a search through the rows of [first_fluid, end).
template <int Dim>
void expect_object_list(const ParticleCloud<Dim>& cloud, const NeighbourList<Dim>& list, std::uint32_t index,
                        std::uint32_t end) {
  const auto found = list.is_wet(index) ? entries(list.of(index)) : std::vector<std::uint32_t>{};
  const std::set<std::uint32_t> unique(found.begin(), found.end());
  ASSERT_EQ(unique.size(), found.size()) << "an entry comes twice";
  if (!found.empty()) {
    ASSERT_GE(*unique.begin(), cloud.table().first_fluid) << "objects see no objects";
    ASSERT_LT(*unique.rbegin(), end);
  }
  for (std::uint32_t j = cloud.table().first_fluid; j < end; ++j) {
    const double squared = cloud.squared_distance(index, j);
    const bool decided = std::abs(squared - kSupportSquared) > kUndecided;
    ASSERT_TRUE(!decided || (unique.count(j) == 1) == (squared < kSupportSquared)) << index << " and " << j;
  }
}

template <int Dim>
void expect_all_lists(const ParticleCloud<Dim>& cloud, const NeighbourList<Dim>& list,
                      bool images_for_objects = true) {
  const SourceTable& table = cloud.table();
  for (std::uint32_t i = table.first_fluid; i < table.first_image; ++i) expect_list(cloud, list, i);
  const std::uint32_t end = images_for_objects ? table.end : table.first_image;
  for (std::uint32_t i = table.first_object; i < table.first_object_image; ++i) {
    expect_object_list(cloud, list, i, end);
  }
}

/// Fluid in the middle, objects in one corner, images and some strays around the domain.
template <int Dim>
ParticleCloud<Dim> mixed_cloud(unsigned seed) {
  std::array<double, Dim> extent;
  extent.fill(11.0);
  const std::size_t many = Dim == 2 ? 500 : 1200;
  auto fluid = random_points<Dim>(many, 1.0F, 10.0F, seed);
  const auto strays = random_points<Dim>(many / 10, -6.0F, 17.0F, seed + 1);
  fluid.insert(fluid.end(), strays.begin(), strays.end());
  return ParticleCloud<Dim>(extent, {random_points<Dim>(many / 4, -1.0F, 4.0F, seed + 2),
                                     random_points<Dim>(many / 10, -2.0F, 0.0F, seed + 3), fluid,
                                     random_points<Dim>(many / 4, -2.0F, 13.0F, seed + 4)});
}

TEST(NeighbourList, EqualsASearchOfAllPairsInThePlane) {
  NeighbourList<2> list;
  ThreadPool pool(1);
  for (const unsigned seed : {1U, 20U, 300U}) {
    const auto cloud = mixed_cloud<2>(seed);
    cloud.build(list, pool);
    expect_all_lists(cloud, list);
  }
}

TEST(NeighbourList, OfObjectsHoldsNoImagesUnlessTheyAreAskedFor) {
  NeighbourList<2> list;
  ThreadPool pool(1);
  for (const unsigned seed : {1U, 20U, 300U}) {
    const auto cloud = mixed_cloud<2>(seed);
    cloud.build(list, pool, false);
    expect_all_lists(cloud, list, false);
  }
}

TEST(NeighbourList, AFilterTakesOutWhatIsNotKeptAndLeavesTheOrder) {
  const auto cloud = mixed_cloud<3>(7);
  NeighbourList<3> list;
  ThreadPool pool(1);
  cloud.build(list, pool);
  const SourceTable& table = cloud.table();
  const auto keep = [](std::uint32_t j) { return j % 3 != 0; };
  for (std::uint32_t i = table.first_fluid; i < table.first_fluid + 50; ++i) {
    std::vector<std::uint32_t> expected = entries(list.of(i));
    std::erase_if(expected, [&](std::uint32_t j) { return !keep(j); });
    const auto next = entries(list.of(i + 1));
    list.filter(i, keep);
    EXPECT_EQ(entries(list.of(i)), expected);
    EXPECT_EQ(entries(list.of(i + 1)), next) << "others stay";
  }
  for (std::uint32_t k = table.first_object; k < table.first_object_image; ++k) {
    list.filter(k, [](std::uint32_t) { return false; });
    EXPECT_FALSE(list.is_wet(k));
  }
}

TEST(NeighbourList, EqualsASearchOfAllPairsInSpace) {
  NeighbourList<3> list;
  ThreadPool pool(1);
  for (const unsigned seed : {1U, 20U}) {
    const auto cloud = mixed_cloud<3>(seed);
    cloud.build(list, pool);
    expect_all_lists(cloud, list);
  }
}

TEST(NeighbourList, IsTheSameWhateverTheNumberOfThreads) {
  const auto cloud = mixed_cloud<3>(5);
  NeighbourList<3> one;
  NeighbourList<3> three;
  ThreadPool pool_of_one(1);
  ThreadPool pool_of_three(3);
  cloud.build(one, pool_of_one);
  for (int round = 0; round < 20; ++round) {
    cloud.build(three, pool_of_three);
    for (std::uint32_t i = cloud.table().first_fluid; i < cloud.table().first_image; ++i) {
      const Neighbours a = one.of(i);
      const Neighbours b = three.of(i);
      ASSERT_EQ(std::vector<std::uint32_t>(a.begin, a.end), std::vector<std::uint32_t>(b.begin, b.end));
      ASSERT_EQ(a.near_object, b.near_object);
    }
    for (std::uint32_t i = cloud.table().first_object; i < cloud.table().first_object_image; ++i) {
      ASSERT_EQ(one.is_wet(i), three.is_wet(i));
    }
  }
}

TEST(NeighbourList, HoldsAClusterOfParticlesInOneCell) {
  // 600 particles within half a smoothing length: each has all the others, and the lists fill several pages.
  const ParticleCloud<3> cloud({8.0, 8.0, 8.0},
                               {random_points<3>(0, 0.0F, 1.0F, 1), random_points<3>(0, 0.0F, 1.0F, 1),
                                random_points<3>(600, 3.0F, 3.5F, 2), random_points<3>(0, 0.0F, 1.0F, 1)});
  NeighbourList<3> list;
  ThreadPool pool(2);
  cloud.build(list, pool);
  expect_all_lists(cloud, list);
  EXPECT_EQ(entries(list.of(cloud.table().first_fluid)).size(), 599U);
}

TEST(NeighbourList, HoldsAListLongerThanAPage) {
  // Far more images about a handful of particles than a page of 65536 indices takes.
  const auto images = random_points<2>(70'000, 3.0F, 4.0F, 3);
  const ParticleCloud<2> cloud({8.0, 8.0},
                               {random_points<2>(0, 0.0F, 1.0F, 1), random_points<2>(0, 0.0F, 1.0F, 1),
                                random_points<2>(5, 3.2F, 3.8F, 4), images});
  NeighbourList<2> list;
  ThreadPool pool(1);
  cloud.build(list, pool);
  for (std::uint32_t i = cloud.table().first_fluid; i < cloud.table().first_image; ++i) {
    EXPECT_EQ(entries(list.of(i)).size(), 70'004U);
  }
  // The same object serves an ordinary cloud afterwards.
  const auto ordinary = mixed_cloud<2>(9);
  ordinary.build(list, pool);
  expect_all_lists(ordinary, list);
}

TEST(NeighbourList, ALoneParticleHasNoNeighbours) {
  const std::vector<Float4> none;
  const ParticleCloud<3> cloud({8.0, 8.0, 8.0}, {none, none, {{4.0F, 4.0F, 4.0F, 0.0F}}, none});
  NeighbourList<3> list;
  ThreadPool pool(1);
  cloud.build(list, pool);
  const Neighbours near = list.of(cloud.table().first_fluid);
  EXPECT_TRUE(entries(near).empty());
  EXPECT_FALSE(near.near_object);
}

TEST(NeighbourList, AFluidParticleAmongSolidsAloneHasThemAsNeighbours) {
  const std::vector<Float4> none;
  const auto objects = random_points<3>(50, 3.5F, 4.5F, 6);
  const ParticleCloud<3> cloud({8.0, 8.0, 8.0}, {objects, none, {{4.0F, 4.0F, 4.0F, 0.0F}}, none});
  NeighbourList<3> list;
  ThreadPool pool(1);
  cloud.build(list, pool);
  const Neighbours near = list.of(cloud.table().first_fluid);
  EXPECT_EQ(entries(near).size(), 50U);
  EXPECT_TRUE(near.near_object);
}

TEST(NeighbourList, LeavesObjectsDryThatHaveOnlyObjectsAround) {
  const std::vector<Float4> none;
  const auto objects = random_points<3>(50, 1.0F, 2.0F, 6);
  const ParticleCloud<3> cloud({20.0, 20.0, 20.0}, {objects, none, {{15.0F, 15.0F, 15.0F, 0.0F}}, none});
  NeighbourList<3> list;
  ThreadPool pool(1);
  cloud.build(list, pool);
  for (std::uint32_t i = cloud.table().first_object; i < cloud.table().first_object_image; ++i) {
    EXPECT_FALSE(list.is_wet(i));
  }
}

TEST(NeighbourList, ALatticeHasItsKnownNumberOfNeighbours) {
  std::vector<Float4> lattice;
  constexpr float kSpacing = 1.0F / 1.32F;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      for (int k = 0; k < 9; ++k) lattice.push_back({kSpacing * i, kSpacing * j, kSpacing * k, 0.0F});
    }
  }
  const std::vector<Float4> none;
  const ParticleCloud<3> cloud({7.0, 7.0, 7.0}, {none, none, lattice, none});
  NeighbourList<3> list;
  ThreadPool pool(1);
  cloud.build(list, pool);
  std::size_t longest = 0;
  for (std::uint32_t i = cloud.table().first_fluid; i < cloud.table().first_image; ++i) {
    longest = std::max(longest, entries(list.of(i)).size());
  }
  EXPECT_EQ(longest, 80U);
}

}  // namespace
}  // namespace eisph
