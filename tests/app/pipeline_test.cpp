#include "app/pipeline.hpp"

#include "app/simulation_double.hpp"
#include "app/time_loop.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Publication publication_at(double time, std::vector<DueFrame> frames, bool particles = true) {
  auto state = std::make_shared<Snapshot>();
  state->time = time;
  Publication publication{state, {}};
  publication.due.particles = particles;
  publication.due.frames = std::move(frames);
  return publication;
}

/// Stages that keep in memory what they are given. Read after Pipeline::finish, which joins their threads.
struct RecordingStages {
  std::vector<double> written;
  std::vector<double> encoded;
  std::set<std::thread::id> threads;
  std::mutex mutex;

  void note_thread() {
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  }

  PipelineStages stages() {
    PipelineStages result;
    result.make_write = [this] {
      note_thread();
      return [this](const Publication& publication) { written.push_back(publication.snapshot->time); };
    };
    result.make_draw = [this] {
      note_thread();
      return [](const Snapshot& state, const DueFrame&) {
        Frame frame;
        frame.time = state.time;
        return frame;
      };
    };
    result.make_encode = [this] {
      note_thread();
      return [this](const Frame& frame) { encoded.push_back(frame.time); };
    };
    return result;
  }
};

TEST(Pipeline, WritesEverythingThatIsPublishedInOrderOnThreadsOfItsOwn) {
  RecordingStages recording;
  Pipeline pipeline(recording.stages(), 1, QueuePolicy::KeepAll);
  for (const double time : {0.0, 1.0, 2.0, 3.0}) pipeline.publish(publication_at(time, {{0, 0}}));
  pipeline.finish();
  EXPECT_THAT(recording.written, ElementsAre(0.0, 1.0, 2.0, 3.0));
  EXPECT_THAT(recording.encoded, ElementsAre(0.0, 1.0, 2.0, 3.0));
  EXPECT_EQ(pipeline.frames_written(), 4);
  EXPECT_EQ(pipeline.frames_dropped(), 0);
  EXPECT_EQ(recording.threads.size(), 3);
  EXPECT_EQ(recording.threads.count(std::this_thread::get_id()), 0);
}

TEST(Pipeline, DrawsEachFrameThatIsDue) {
  RecordingStages recording;
  Pipeline pipeline(recording.stages(), 2, QueuePolicy::KeepAll);
  pipeline.publish(publication_at(1.0, {{0, 5}, {1, 2}}));
  pipeline.publish(publication_at(2.0, {}));
  pipeline.finish();
  EXPECT_THAT(recording.encoded, ElementsAre(1.0, 1.0));
  EXPECT_THAT(recording.written, ElementsAre(1.0, 2.0));
}

TEST(Pipeline, StartsNoThreadForAStageThatIsMissing) {
  RecordingStages recording;
  PipelineStages stages = recording.stages();
  stages.make_draw = nullptr;
  Pipeline pipeline(stages, 2, QueuePolicy::KeepAll);
  pipeline.publish(publication_at(1.0, {{0, 0}}));
  pipeline.finish();
  EXPECT_THAT(recording.encoded, IsEmpty());
  EXPECT_EQ(recording.threads.size(), 1);
}

TEST(Pipeline, OfTheLatestFramesOnlyDropsTheOldestAndCountsThemButDropsNoRecord) {
  std::promise<void> drawing_first;
  std::promise<void> go_on;
  std::shared_future<void> gate = go_on.get_future().share();
  std::atomic<int> drawn{0};
  RecordingStages recording;
  PipelineStages stages = recording.stages();
  stages.make_draw = [&] {
    return [&, gate](const Snapshot& state, const DueFrame&) {
      if (drawn++ == 0) drawing_first.set_value();
      gate.wait();
      Frame frame;
      frame.time = state.time;
      return frame;
    };
  };
  Pipeline pipeline(stages, 1, QueuePolicy::LatestOnly);
  pipeline.publish(publication_at(0.0, {{0, 0}}));
  drawing_first.get_future().wait();
  for (const double time : {1.0, 2.0, 3.0}) pipeline.publish(publication_at(time, {{0, 0}, {1, 0}}));
  go_on.set_value();
  pipeline.finish();
  EXPECT_THAT(recording.encoded, ElementsAre(0.0, 3.0, 3.0));
  EXPECT_EQ(pipeline.frames_dropped(), 4);
  EXPECT_EQ(pipeline.frames_written(), 3);
  EXPECT_THAT(recording.written, ElementsAre(0.0, 1.0, 2.0, 3.0));
}

/// Publishes until the failure comes back, with queues so short that a producer would wait for a dead thread.
std::string failure_of(const PipelineStages& stages) {
  Pipeline pipeline(stages, 1, QueuePolicy::KeepAll);
  try {
    for (int count = 0; count < 100; ++count) pipeline.publish(publication_at(count, {{0, 0}, {1, 0}}));
    pipeline.finish();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Pipeline, PassesOnWhatTheWriterThrows) {
  RecordingStages recording;
  PipelineStages stages = recording.stages();
  stages.make_write = [] { return [](const Publication&) { throw std::runtime_error("disk full"); }; };
  EXPECT_EQ(failure_of(stages), "disk full");
}

TEST(Pipeline, PassesOnWhatTheRendererThrowsWhenItIsMade) {
  RecordingStages recording;
  PipelineStages stages = recording.stages();
  stages.make_draw = []() -> PipelineStages::Draw { throw std::runtime_error("no drawing context"); };
  EXPECT_EQ(failure_of(stages), "no drawing context");
}

TEST(Pipeline, PassesOnWhatTheEncoderThrows) {
  RecordingStages recording;
  PipelineStages stages = recording.stages();
  stages.make_encode = [] { return [](const Frame&) { throw std::runtime_error("cannot write frame"); }; };
  EXPECT_EQ(failure_of(stages), "cannot write frame");
}

TEST(Pipeline, EndsItsThreadsWhenItIsDestroyedUnfinished) {
  RecordingStages recording;
  {
    Pipeline pipeline(recording.stages(), 2, QueuePolicy::KeepAll);
    pipeline.publish(publication_at(0.0, {{0, 0}}));
  }
  EXPECT_LE(recording.encoded.size(), 1);
}

TEST(Pipeline, BehindTheTimeLoopReceivesEveryOutputTime) {
  Scene scene;
  scene.output.particles.interval = 0.1;
  ImageSettings image;
  image.schedule.interval = 0.25;
  scene.images = {image};
  const OutputPlan plan(scene, true);
  SimulationDouble simulation(0.004);
  RecordingStages recording;
  Pipeline pipeline(recording.stages(), 1, QueuePolicy::KeepAll);
  run_time_loop(simulation, plan, 0.5,
                {[&](const Publication& publication) { pipeline.publish(publication); },
                 [&] { pipeline.check(); }, [] { return false; }});
  pipeline.finish();
  EXPECT_THAT(recording.written, ElementsAre(0.0, 0.1, 0.2, 0.25, 0.30000000000000004, 0.4, 0.5));
  EXPECT_THAT(recording.encoded, ElementsAre(0.0, 0.25, 0.5));
}

TEST(Pipeline, EndsTheTimeLoopWhenAStageFails) {
  Scene scene;
  scene.output.particles.times = {0.0};
  const OutputPlan plan(scene, true);
  SimulationDouble simulation(1e-6);
  RecordingStages recording;
  PipelineStages stages = recording.stages();
  stages.make_write = [] { return [](const Publication&) { throw std::runtime_error("disk full"); }; };
  Pipeline pipeline(stages, 1, QueuePolicy::KeepAll);
  const LoopHooks hooks{[&](const Publication& publication) { pipeline.publish(publication); },
                        [&] { pipeline.check(); }, [] { return false; }};
  EXPECT_THROW(run_time_loop(simulation, plan, 1e6, hooks), std::runtime_error);
}

}  // namespace
}  // namespace eisph
