#include "app/frame_stage.hpp"
#include "app/in_situ_run.hpp"
#include "app/saved_states.hpp"
#include "app/scene_report.hpp"
#include "io/scene_text.hpp"
#include "io/temporary_folder.hpp"
#include "render/png_file.hpp"

#include <memory>
#include <sstream>

#include <gmock/gmock.h>
#include <spdlog/sinks/null_sink.h>

namespace eisph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kScene = R"(title = "A stream past a block"
dimension = 3
end_time = 0.4
[particles]
spacing = 0.04
[[fluid.region]]
min = [0.0, 0.0, 0.0]
max = [0.4, 0.6, 0.16]
[domain]
min = [0.0, 0.0, 0.0]
max = [1.2, 0.6, 0.4]
[[obstacle]]
name = "block"
min = [0.6, 0.2, 0.0]
max = [0.76, 0.4, 0.3]
[[gauge]]
name = "upstream"
position = [0.2, 0.3]
interval = 0.1
[scheme]
name = "shallow_water"
[output]
interval = 0.2
[[image]]
name = "view"
width = 320
height = 180
[[image]]
name = "depth"
kind = "depth_map"
width = 320
height = 180
)";

TEST(ShallowWaterRun, WritesDepthGridsGaugesAndFramesOfTheSameScene) {
  const TemporaryFolder folder;
  SceneLoader loader;
  const Scene scene = loader.load(kScene);
  const RunFiles files{folder.path()};
  std::ostringstream out;
  ProgressReporter progress(out, ProgressStyle::Plain, 80);
  spdlog::logger log("test", std::make_shared<spdlog::sinks::null_sink_mt>());
  const auto simulation = Simulation::create(scene, 1);
  const RunSummary summary =
      run_in_situ(*simulation, scene, files, {scene.end_time, true}, progress, log, [] { return false; });
  EXPECT_EQ(summary.status, "finished");
  EXPECT_EQ(summary.scheme, "shallow_water");
  EXPECT_EQ(summary.fluid_particles, 30U * 15U);
  EXPECT_EQ(summary.frames_written, 6U);
  EXPECT_THAT(out.str(), HasSubstr("450 cells"));
  EXPECT_TRUE(std::filesystem::exists(files.depth(2)));
  EXPECT_THAT(text_of(files.folder / "gauge_upstream.csv"), HasSubstr("\n0,0.159999"));
  EXPECT_THAT(text_of(files.folder / "ledger.csv"), HasSubstr("\n0,0,150,38.3999"));
  EXPECT_THAT(text_of(files.folder / "leading_edge.csv"), HasSubstr("\n0,0.4,0.4"));

  // Frames drawn again from the saved states are the same, those of the depth grid included.
  const std::vector<SavedState> states = saved_states(files);
  ASSERT_THAT(states, SizeIs(3));
  FrameStage stage(scene);
  const Snapshot last = read_state(states.back());
  EXPECT_EQ(last.columns->depth, simulation->snapshot()->columns->depth);
  EXPECT_EQ(stage.draw(last, 0).rgb, read_png(files.frames() / "view_0002.png").image.rgb);
  EXPECT_EQ(stage.draw(last, 1).rgb, read_png(files.frames() / "depth_0002.png").image.rgb);
}

TEST(ShallowWaterReport, CountsCellsInsteadOfParticles) {
  SceneLoader loader;
  const Scene scene = loader.load(kScene);
  const SimulationPlan plan = Simulation::create(scene, 1)->plan();
  const std::string report = scene_report(scene, plan, 8'000'000'000);
  EXPECT_THAT(report, HasSubstr("450 of 0.04 m, 20 of them on solids, 150 wet at t = 0"));
  EXPECT_THAT(report, HasSubstr("0.0384 m^3"));
  EXPECT_THAT(report, HasSubstr("Manning coefficient 0.007"));
  EXPECT_THAT(report, HasSubstr("1.25 m/s in water as deep as the reference depth"));
  EXPECT_THAT(report, testing::Not(HasSubstr("object")));
  EXPECT_THAT(scene_warnings(scene, plan), IsEmpty());
}

TEST(ShallowWaterWarnings, TellOfSolidsThatTheCellsDoNotShowAsTheyAre) {
  SceneLoader loader;
  Scene scene = loader.load(kScene);
  scene.obstacles.push_back(scene.obstacles[0]);
  scene.obstacles[1].name = "bridge";
  scene.obstacles[1].shape.min = Vec3d(0.9, 0.0, 0.1);
  scene.obstacles[1].shape.max = Vec3d(0.92, 0.6, 0.2);
  const SimulationPlan plan = Simulation::create(scene, 1)->plan();
  EXPECT_THAT(scene_warnings(scene, plan),
              ElementsAre(HasSubstr("\"bridge\" begins 0.1 m above the floor"),
                          HasSubstr("\"bridge\" is 0.02 m thin, less than a cell")));
}

}  // namespace
}  // namespace eisph
