#include "probe/front.hpp"

#include "probe/hand_made.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace eisph {
namespace {

FrontProbe along(int axis, bool upwards) {
  FrontProbe probe;
  probe.axis = axis;
  probe.upwards = upwards;
  return probe;
}

/// Five particles; the last is spray.
Snapshot drops() {
  Snapshot snapshot = hand_made_snapshot(hand_made_scene(3), {{0.25F, 0.125F, 0.25F},
                                                              {0.5F, 0.25F, 0.125F},
                                                              {0.75F, 0.375F, 0.5F},
                                                              {0.125F, 0.0625F, 0.25F},
                                                              {0.875F, 0.4375F, 0.25F}});
  snapshot.number_density.back() = 0.25F;
  return snapshot;
}

TEST(Front, IsTheFarthestParticleInItsDirection) {
  EXPECT_EQ(front_position(along(0, true), drops()).front, 0.875);
  EXPECT_EQ(front_position(along(0, true), drops()).bulk_front, 0.75);
  EXPECT_EQ(front_position(along(0, false), drops()).front, 0.125);
  EXPECT_EQ(front_position(along(1, true), drops()).bulk_front, 0.375);
  EXPECT_EQ(front_position(along(1, false), drops()).bulk_front, 0.0625);
}

TEST(Front, SeesOnlyItsBand) {
  FrontProbe probe = along(0, true);
  probe.band.range[1] = {0.1, 0.25};
  EXPECT_EQ(front_position(probe, drops()).front, 0.5);
  probe.band.range[2] = {0.2, 0.3};
  EXPECT_EQ(front_position(probe, drops()).front, 0.25);
}

TEST(Front, HasNoValueWithoutParticles) {
  FrontProbe probe = along(0, false);
  probe.band.range[2] = {0.55, 0.6};
  EXPECT_TRUE(std::isnan(front_position(probe, drops()).front));
  EXPECT_TRUE(std::isnan(front_position(probe, drops()).bulk_front));
}

}  // namespace
}  // namespace eisph
