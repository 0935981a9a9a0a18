#include "app/output_plan.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using ::testing::ElementsAre;

Scene scene_with_outputs() {
  Scene scene;
  scene.end_time = 1.0;
  scene.output.particles.interval = 0.5;
  scene.output.depth.times = {0.25, 0.3};
  Gauge gauge;
  gauge.interval = 0.1;
  scene.gauges = {gauge};
  ImageSettings first;
  first.name = "first";
  first.schedule.times = {0.3, 0.75};
  ImageSettings second;
  second.name = "second";
  second.schedule.interval = 0.25;
  scene.images = {first, second};
  return scene;
}

TEST(OutputPlan, NextTimeIsTheEarliestOfAllSchedules) {
  const OutputPlan plan(scene_with_outputs(), true);
  EXPECT_DOUBLE_EQ(plan.next_after(0.0), 0.1);
  EXPECT_DOUBLE_EQ(plan.next_after(0.2), 0.25);
  EXPECT_DOUBLE_EQ(plan.next_after(0.7), 0.75);
}

TEST(OutputPlan, StatesEverythingDueAtOneTime) {
  const OutputPlan plan(scene_with_outputs(), true);
  const DueOutputs start = plan.due_at(0.0);
  EXPECT_TRUE(start.particles);
  EXPECT_TRUE(start.probes);
  EXPECT_FALSE(start.depth);
  ASSERT_EQ(start.frames.size(), 1);
  EXPECT_EQ(start.frames[0].image, 1);

  const DueOutputs later = plan.due_at(0.3);
  EXPECT_FALSE(later.particles);
  EXPECT_TRUE(later.probes);
  EXPECT_TRUE(later.depth);
  ASSERT_EQ(later.frames.size(), 1);
  EXPECT_EQ(later.frames[0].image, 0);
  EXPECT_FALSE(plan.due_at(0.31).any());
}

TEST(OutputPlan, TakesTimesThatDifferByRoundingAsOne) {
  Scene scene;
  scene.output.particles.interval = 0.1;
  scene.output.depth.times = {0.3};
  const OutputPlan plan(scene, true);
  const double first = plan.next_after(0.2);
  EXPECT_TRUE(plan.due_at(first).particles);
  EXPECT_TRUE(plan.due_at(first).depth);
  EXPECT_NEAR(plan.next_after(first), 0.4, 1e-12);
}

TEST(OutputPlan, NumbersFramesWithinTheirOwnSequence) {
  const OutputPlan plan(scene_with_outputs(), true);
  const DueOutputs due = plan.due_at(0.75);
  ASSERT_EQ(due.frames.size(), 2);
  EXPECT_EQ(due.frames[0].index, 1);
  EXPECT_EQ(due.frames[1].index, 3);
}

TEST(OutputPlan, CountsWhatAWholeRunWrites) {
  const OutputCounts counts = OutputPlan(scene_with_outputs(), true).counts(1.0);
  EXPECT_EQ(counts.particles, 3);
  EXPECT_EQ(counts.depth, 2);
  EXPECT_EQ(counts.probe_times, 11);
  EXPECT_THAT(counts.frames, ElementsAre(2, 5));
}

TEST(OutputPlan, WithoutFramesKeepsTheirTimesButHasNothingDueAtThem) {
  const OutputPlan plan(scene_with_outputs(), false);
  EXPECT_FALSE(plan.has_frames());
  EXPECT_TRUE(plan.has_records());
  EXPECT_DOUBLE_EQ(plan.next_after(0.7), 0.75);
  EXPECT_FALSE(plan.due_at(0.75).any());
  EXPECT_THAT(plan.counts(1.0).frames, ElementsAre(0, 0));
}

TEST(OutputPlan, OfASceneWithoutOutputsIsEmpty) {
  const OutputPlan plan(Scene{}, true);
  EXPECT_FALSE(plan.has_frames());
  EXPECT_FALSE(plan.has_records());
  EXPECT_EQ(plan.next_after(0.0), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(plan.due_at(0.0).any());
}

}  // namespace
}  // namespace eisph
