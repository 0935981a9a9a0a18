#include "app/time_loop.hpp"

#include "app/simulation_double.hpp"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Keeps what is published, and stops when told to.
struct Recorder {
  std::vector<Publication> published;
  int steps = 0;
  int stop_after_steps = -1;

  LoopHooks hooks() {
    return {[this](const Publication& publication) { published.push_back(publication); }, [this] { ++steps; },
            [this] { return steps == stop_after_steps; }};
  }
  [[nodiscard]] std::vector<double> times() const {
    std::vector<double> result;
    for (const Publication& publication : published) result.push_back(publication.snapshot->time);
    return result;
  }
};

Scene scene_with_states_at(std::vector<double> times) {
  Scene scene;
  scene.output.particles.times = std::move(times);
  return scene;
}

TEST(TimeLoop, PublishesAtExactlyTheOutputTimes) {
  SimulationDouble simulation(0.007);
  Recorder recorder;
  const OutputPlan plan(scene_with_states_at({0.0, 0.1, 0.123, 0.2}), true);
  EXPECT_EQ(run_time_loop(simulation, plan, 0.2, recorder.hooks()), LoopEnd::Finished);
  EXPECT_THAT(recorder.times(), ElementsAre(0.0, 0.1, 0.123, 0.2));
}

TEST(TimeLoop, EndsExactlyAtTheEndTime) {
  SimulationDouble simulation(0.03);
  Recorder recorder;
  run_time_loop(simulation, OutputPlan(Scene{}, true), 0.1, recorder.hooks());
  EXPECT_EQ(simulation.time(), 0.1);
  EXPECT_EQ(recorder.steps, 4);
}

TEST(TimeLoop, TakesNoSnapshotWithoutOutputs) {
  SimulationDouble simulation(0.03);
  Recorder recorder;
  run_time_loop(simulation, OutputPlan(Scene{}, true), 0.1, recorder.hooks());
  EXPECT_EQ(simulation.snapshots(), 0);
  EXPECT_THAT(recorder.published, IsEmpty());
}

TEST(TimeLoop, TakesOneSnapshotForEverythingDueAtOneTime) {
  Scene scene = scene_with_states_at({0.1});
  scene.output.depth.times = {0.1};
  ImageSettings image;
  image.schedule.times = {0.1};
  scene.images = {image, image};
  SimulationDouble simulation(0.03);
  Recorder recorder;
  run_time_loop(simulation, OutputPlan(scene, true), 0.2, recorder.hooks());
  EXPECT_EQ(simulation.snapshots(), 1);
  ASSERT_EQ(recorder.published.size(), 1);
  const DueOutputs& due = recorder.published[0].due;
  EXPECT_TRUE(due.particles);
  EXPECT_TRUE(due.depth);
  EXPECT_EQ(due.frames.size(), 2);
}

TEST(TimeLoop, MakesNoSliverOfAStepWhenAnOutputTimeMissesTheEndByRounding) {
  Scene scene;
  scene.output.particles.interval = 0.1;
  SimulationDouble simulation(0.05);
  Recorder recorder;
  run_time_loop(simulation, OutputPlan(scene, true), 0.3, recorder.hooks());
  EXPECT_EQ(recorder.steps, 6);
  EXPECT_EQ(simulation.time(), 0.3);
  EXPECT_EQ(recorder.published.size(), 4);
}

TEST(TimeLoop, StopsAfterTheStepDuringWhichItIsAskedTo) {
  SimulationDouble simulation(0.01);
  Recorder recorder;
  recorder.stop_after_steps = 7;
  const OutputPlan plan(scene_with_states_at({0.05, 0.5}), true);
  EXPECT_EQ(run_time_loop(simulation, plan, 1.0, recorder.hooks()), LoopEnd::Interrupted);
  EXPECT_EQ(recorder.steps, 7);
  EXPECT_THAT(recorder.times(), ElementsAre(0.05));
}

TEST(TimeLoop, LetsABlowUpOutWithWhatWasPublishedBefore) {
  SimulationDouble simulation(0.01, 0.5);
  Recorder recorder;
  const OutputPlan plan(scene_with_states_at({0.25, 0.75}), true);
  EXPECT_THROW(run_time_loop(simulation, plan, 1.0, recorder.hooks()), BlowUpError);
  EXPECT_THAT(recorder.times(), ElementsAre(0.25));
}

TEST(TimeLoop, StepsTheSameWayWithFramesAndWithoutThem) {
  Scene scene = scene_with_states_at({0.05, 0.1});
  ImageSettings image;
  image.schedule.times = {0.033, 0.1};
  scene.images = {image};
  std::vector<std::vector<double>> ends;
  for (const bool frames : {true, false}) {
    SimulationDouble simulation(0.013);
    Recorder recorder;
    run_time_loop(simulation, OutputPlan(scene, frames), 0.2, recorder.hooks());
    ends.push_back(simulation.step_ends());
  }
  EXPECT_EQ(ends[0], ends[1]);
}

}  // namespace
}  // namespace eisph
