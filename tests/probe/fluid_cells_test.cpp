#include "probe/fluid_cells.hpp"

#include "probe/hand_made.hpp"

#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace eisph {
namespace {

class FluidCellsTest : public testing::TestWithParam<int> {
 protected:
  Scene scene_ = hand_made_scene(GetParam());

  /// Particles within the box about `centre` that the cells visit, and all that are in it.
  void expect_all_found(const Snapshot& snapshot, const Vec3d& centre, double reach) const {
    const auto is_near = [&](std::size_t k) {
      Vec3d offset = snapshot.position[k].cast<double>() - centre;
      if (snapshot.dimension == 2) offset.y() = 0.0;
      return offset.cwiseAbs().maxCoeff() <= reach;
    };
    std::multiset<std::size_t> found;
    FluidCells(snapshot, 0.05).visit_near(centre, reach, [&](std::size_t k, const Vec3f& position) {
      EXPECT_EQ(position, snapshot.position[k]);
      if (is_near(k)) found.insert(k);
    });
    std::multiset<std::size_t> expected;
    for (std::size_t k = 0; k < snapshot.size(); ++k) {
      if (is_near(k)) expected.insert(k);
    }
    EXPECT_EQ(found, expected) << centre.transpose();
  }
};

TEST_P(FluidCellsTest, FindEveryParticleNearAPointOnce) {
  Snapshot water = hand_made_snapshot(scene_, lattice(scene_, Vec3d(0.3, 0.3, 0.2)));
  shake(water, 0.01);
  const double y = GetParam() == 2 ? 0.7 : 0.0;  // no matter in two dimensions
  for (const Vec3d& centre : {Vec3d(0.0, y, 0.1), Vec3d(0.15, y + 0.13, 0.2), Vec3d(0.33, y + 0.3, 0.31),
                              Vec3d(-0.2, y, 0.1), Vec3d(2.0, y, 3.0)}) {
    for (const double reach : {0.01, 0.05, 0.3}) expect_all_found(water, centre, reach);
  }
}

TEST_P(FluidCellsTest, FindDropsFarApart) {
  const Snapshot drops = hand_made_snapshot(scene_, {{0.0F, 0.0F, 0.0F}, {900.0F, 0.0F, -3000.0F}});
  expect_all_found(drops, Vec3d(0.01, 0.0, 0.01), 0.05);
  expect_all_found(drops, Vec3d(900.0, 0.0, -3000.0), 0.05);
}

TEST_P(FluidCellsTest, LeaveOutWhatIsNotANumber) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const Snapshot snapshot = hand_made_snapshot(scene_, {{none, 0.0F, 0.2F}, {0.5F, 0.0F, 0.2F}});
  int visits = 0;
  FluidCells(snapshot, 0.05).visit_near(Vec3d(0.5, 0.0, 0.2), 0.1, [&](std::size_t k, const Vec3f&) {
    EXPECT_EQ(k, 1U);
    ++visits;
  });
  EXPECT_EQ(visits, 1);
  FluidCells(hand_made_snapshot(scene_, {}), 0.05)
      .visit_near(Vec3d::Zero(), 1.0, [](std::size_t, const Vec3f&) { ADD_FAILURE(); });
}

INSTANTIATE_TEST_SUITE_P(Dimension, FluidCellsTest, testing::Values(2, 3));

}  // namespace
}  // namespace eisph
