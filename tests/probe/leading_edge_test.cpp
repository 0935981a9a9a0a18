#include "probe/leading_edge.hpp"

#include "probe/hand_made.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(LeadingEdge, TellsTheFarthestParticleFromTheFarthestOfTheBulk) {
  const Scene scene = hand_made_scene(3);
  Snapshot snapshot = hand_made_snapshot(
      scene, {{0.25F, 0.1F, 0.2F}, {0.5F, 0.1F, 0.2F}, {0.75F, 0.1F, 0.5F}, {0.1F, 0, 0.2F}});
  snapshot.number_density = {1.0F, 0.57F, 0.2F, 0.9F};
  const LeadingEdge edge = leading_edge(snapshot);
  EXPECT_EQ(edge.front, 0.75);
  EXPECT_EQ(edge.bulk_front, 0.5);
  EXPECT_EQ(leading_edge(snapshot, 0.8).bulk_front, 0.25);
}

TEST(LeadingEdge, AgreesForNegativeCoordinates) {
  const Scene scene = hand_made_scene(2);
  const LeadingEdge edge = leading_edge(hand_made_snapshot(scene, {{-0.5F, 0, 0.2F}, {-0.25F, 0, 0.2F}}));
  EXPECT_EQ(edge.front, -0.25);
  EXPECT_EQ(edge.bulk_front, -0.25);
}

TEST(LeadingEdge, HasNoValueWhereNoParticleQualifies) {
  const Scene scene = hand_made_scene(3);
  EXPECT_TRUE(std::isnan(leading_edge(hand_made_snapshot(scene, {})).front));
  Snapshot spray = hand_made_snapshot(scene, {{0.5F, 0.1F, 0.2F}});
  spray.number_density = {0.14F};
  EXPECT_EQ(leading_edge(spray).front, 0.5);
  EXPECT_TRUE(std::isnan(leading_edge(spray).bulk_front));
}

}  // namespace
}  // namespace eisph
