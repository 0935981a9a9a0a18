#include "app/in_situ_run.hpp"

#include "app/saved_states.hpp"
#include "app/simulation_double.hpp"
#include "io/temporary_folder.hpp"
#include "render/png_file.hpp"

#include <cmath>
#include <memory>
#include <sstream>

#include <gmock/gmock.h>
#include <spdlog/sinks/null_sink.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// A scene around the one particle of the double, with a state and a small frame every 0.25 s.
Scene small_scene() {
  Scene scene;
  scene.name = "moving";
  scene.title = "One particle";
  scene.end_time = 1.0;
  scene.particle_spacing = 0.1;
  scene.reference_depth = 0.1;
  scene.domain_max = {1.0, 0.2, 0.5};
  scene.output.particles.interval = 0.25;
  ImageSettings image;
  image.name = "view";
  image.width = 320;
  image.height = 180;
  image.schedule.interval = 0.25;
  scene.images = {image};
  return scene;
}

class InSituRun : public ::testing::Test {
 protected:
  RunSummary run(
      SimulationDouble& simulation, const Scene& scene, bool frames = true,
      const std::function<bool()>& stop = [] { return false; }) {
    return run_in_situ(simulation, scene, files_, {scene.end_time, frames}, progress_, log_, stop);
  }

  TemporaryFolder folder_;
  RunFiles files_{folder_.path()};
  std::ostringstream out_;
  ProgressReporter progress_{out_, ProgressStyle::Quiet, 80};
  spdlog::logger log_{"test", std::make_shared<spdlog::sinks::null_sink_mt>()};
};

TEST_F(InSituRun, WritesFramesStatesAndTables) {
  SimulationDouble simulation(0.01);
  const RunSummary summary = run(simulation, small_scene());
  EXPECT_TRUE(simulation.initialised());
  EXPECT_EQ(summary.status, "finished");
  EXPECT_EQ(summary.scene, "moving");
  EXPECT_EQ(summary.frames_written, 5);
  EXPECT_GT(summary.cpu_time_total, 0.0);
  EXPECT_GT(summary.peak_rss_bytes, 0);
  EXPECT_THAT(saved_states(files_), SizeIs(5));
  EXPECT_THAT(text_of(files_.folder / "ledger.csv"), HasSubstr("\n0.75,"));
  EXPECT_EQ(summary.paired_fraction_max, 0.0);
  EXPECT_EQ(summary.nearest_distance_p5_final, 2.0);
  EXPECT_EQ(summary.isolated_particles_final, 1U) << "the one there is";
  EXPECT_EQ(summary.isolated_fraction_max, 1.0);
}

TEST_F(InSituRun, NamesSceneTimeAndSoftwareInItsFrames) {
  SimulationDouble simulation(0.01);
  (void)run(simulation, small_scene());
  const PngFile frame = read_png(files_.frames() / "view_0003.png");
  EXPECT_EQ(frame.image.width, 320);
  const auto text_of_key = [&frame](const std::string& key) {
    for (const auto& [name, text] : frame.text) {
      if (name == key) return text;
    }
    return std::string();
  };
  EXPECT_EQ(text_of_key("Title"), "One particle");
  EXPECT_EQ(text_of_key("Scene"), "moving");
  EXPECT_EQ(text_of_key("Time"), "0.75 s");
  EXPECT_THAT(text_of_key("Software"), HasSubstr("eisph"));
}

TEST_F(InSituRun, WithoutFramesWritesTheRest) {
  SimulationDouble simulation(0.01);
  const RunSummary summary = run(simulation, small_scene(), false);
  EXPECT_EQ(summary.frames_written, 0);
  EXPECT_FALSE(std::filesystem::exists(files_.frames()));
  EXPECT_THAT(saved_states(files_), SizeIs(5));
}

TEST_F(InSituRun, ThatFailsToRecordDoesNotWaitForTheCurvesOfItsFrames) {
  Scene scene = small_scene();
  scene.gauges = {{.name = "level", .x = 0.5, .y = 0.1, .interval = 0.25}};
  ImageSettings panels = scene.images.front();
  panels.name = "all";
  panels.kind = ImageKind::Panels;
  panels.width = 480;
  panels.height = 360;
  panels.panels = {"view"};
  panels.gauges = {"level"};
  scene.images.push_back(panels);
  {
    SimulationDouble simulation(0.01);
    EXPECT_EQ(run(simulation, scene).frames_written, 10);
  }
  scene.output.comparison.times = {0.5};
  const auto fail = [](const Snapshot&) { throw std::runtime_error("no room left"); };
  SimulationDouble simulation(0.01);
  EXPECT_THAT(
      [&] {
        (void)run_in_situ(simulation, scene, files_, {.end_time = scene.end_time, .compare = fail}, progress_,
                          log_, [] { return false; });
      },
      ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("no room left")));
}

TEST_F(InSituRun, OfASceneWithoutOutputsTakesNoSnapshotAndWritesNothing) {
  Scene scene = small_scene();
  scene.output.particles = {};
  scene.images.clear();
  SimulationDouble simulation(0.01);
  const RunSummary summary = run(simulation, scene);
  EXPECT_EQ(summary.status, "finished");
  EXPECT_EQ(simulation.snapshots(), 0);
  EXPECT_TRUE(std::isnan(summary.paired_fraction_max)) << "nor searches for neighbours";
  EXPECT_EQ(folder_.file_count(), 0);
}

TEST_F(InSituRun, ThatBlowsUpKeepsWhatCameBefore) {
  SimulationDouble simulation(0.01, 0.6);
  const RunSummary summary = run(simulation, small_scene());
  EXPECT_EQ(summary.status, "blown_up");
  EXPECT_THAT(summary.message, HasSubstr("particle 0"));
  EXPECT_EQ(summary.frames_written, 3);
  const std::vector<SavedState> states = saved_states(files_);
  ASSERT_THAT(states, SizeIs(3));
  EXPECT_EQ(read_state(states.back()).time, 0.5);
}

TEST_F(InSituRun, ThatIsStoppedKeepsWhatCameBefore) {
  SimulationDouble simulation(0.01);
  const RunSummary summary = run(simulation, small_scene(), true, [&] { return simulation.time() > 0.3; });
  EXPECT_EQ(summary.status, "interrupted");
  EXPECT_LT(summary.simulated_time, 0.32);
  EXPECT_THAT(saved_states(files_), SizeIs(2));
  EXPECT_EQ(summary.frames_written, 2);
}

TEST_F(InSituRun, EndsWithAClearMessageWhenTheDiskIsFull) {
  std::filesystem::create_symlink("/dev/full", files_.folder / "ledger.csv");
  SimulationDouble simulation(0.01);
  EXPECT_THAT(error_of<std::runtime_error>([&] { (void)run(simulation, small_scene()); }),
              AllOf(HasSubstr("ledger.csv"), HasSubstr("No space left on device")));
}

TEST_F(InSituRun, EndsWithAClearMessageWhenFramesCannotBeWritten) {
  put_text(files_.frames(), "a file where the folder should be");
  SimulationDouble simulation(0.01);
  EXPECT_THAT(error_of<std::runtime_error>([&] { (void)run(simulation, small_scene()); }),
              HasSubstr("frames"));
}

}  // namespace
}  // namespace eisph
