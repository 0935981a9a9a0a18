// The program as a user starts it: as a child process, with real scenes and real files.

#include "app/child_process.hpp"
#include "app/comparison/video.hpp"
#include "app/run_files.hpp"
#include "app/saved_states.hpp"
#include "app/view/recorded_run.hpp"
#include "io/scene_file.hpp"
#include "render/virtual_display.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace eisph {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr const char* kColumn2D = R"(
dimension = 2
end_time = 0.1
[particles]
spacing = 0.01
[fluid]
[[fluid.region]]
min = [0.0, 0.0]
max = [0.1, 0.2]
[domain]
min = [0.0, 0.0]
max = [0.4, 0.3]
[domain.faces]
z_max = "open"
[[gauge]]
name = "wall"
position = [0.02]
interval = 0.01
[[probe]]
name = "corner"
position = [0.01, 0.01]
interval = 0.02
[output]
times = [0.033, 0.1]
particles_times = [0.0, 0.033, 0.05, 0.1]
depth_interval = 0.05
[[image]]
name = "view"
width = 320
height = 180
)";

constexpr const char* kTank3D = R"(
dimension = 3
end_time = 0.06
[particles]
spacing = 0.02
[fluid]
[[fluid.region]]
min = [0.0, 0.0, 0.0]
max = [0.2, 0.2, 0.2]
[domain]
min = [0.0, 0.0, 0.0]
max = [0.5, 0.2, 0.3]
[domain.faces]
z_max = "open"
[[obstacle]]
name = "block"
min = [0.3, 0.06, 0.0]
max = [0.36, 0.14, 0.1]
[[gauge]]
name = "front"
position = [0.25, 0.1]
interval = 0.02
[output]
times = [0.02, 0.06]
[[image]]
name = "view"
style = "surface"
width = 320
height = 180
[[image]]
name = "map"
kind = "depth_map"
width = 320
height = 180
[[image]]
name = "all"
kind = "panels"
panels = ["view", "map"]
gauges = ["front"]
width = 480
height = 361
)";

/// Contents of all files of one sort below a folder, by their path in it.
std::map<std::string, std::string> files_of_sort(const fs::path& folder, const std::string& extension) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != extension) continue;
    contents[fs::relative(entry.path(), folder).string()] = text_of(entry.path());
  }
  return contents;
}

class EndToEnd : public ::testing::Test {
 protected:
  void SetUp() override {
    put_text(column_, kColumn2D);
    put_text(tank_, kTank3D);
  }

  /// eisph run SCENE --quiet --out <folder>/NAME and more options
  [[nodiscard]] ProcessResult run(const fs::path& scene, const std::string& name,
                                  const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"run", scene.string(), "--quiet", "--out",
                                          (folder_ / name).string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program_with(arguments);
  }
  [[nodiscard]] nlohmann::json summary(const std::string& name) const {
    return nlohmann::json::parse(text_of(folder_ / name / "run.json"));
  }

  TemporaryFolder folder_;
  fs::path column_ = folder_ / "column.toml";
  fs::path tank_ = folder_ / "tank.toml";
};

TEST_F(EndToEnd, ARunLeavesEverythingItPromises) {
  const ProcessResult result = run_program_with({"run", tank_.string(), "--out", (folder_ / "run").string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("finished"), HasSubstr("6 in " + (folder_ / "run/frames").string())));
  EXPECT_THAT(result.err, HasSubstr("100.0 %"));
  for (const char* name :
       {"frames/view_0000.png", "frames/view_0001.png", "frames/map_0000.png", "frames/map_0001.png",
        "frames/all_0001.png", "particles/particles_0000.vtp", "particles/particles_0001.vtp",
        "particles/objects_0000.vtp", "depth/depth_0001.vti", "particles.pvd", "objects.pvd", "depth.pvd",
        "gauge_front.csv", "ledger.csv", "leading_edge.csv", "scene.toml", "run.log"}) {
    EXPECT_TRUE(fs::is_regular_file(folder_ / "run" / name)) << name;
  }
  const nlohmann::json figures = summary("run");
  EXPECT_EQ(figures["status"], "finished");
  EXPECT_EQ(figures["fluid_particles"], 1000);
  EXPECT_EQ(figures["simulated_time"], 0.06);
  EXPECT_EQ(figures["frames_written"], 6);
  EXPECT_EQ(load_scene(folder_ / "run/scene.toml").images.size(), 3);
}

TEST_F(EndToEnd, OutputsFallExactlyOnTheirTimes) {
  ASSERT_EQ(run(column_, "run").exit_code, 0);
  std::vector<double> times;
  for (const SavedState& state : saved_states({folder_ / "run"})) times.push_back(read_state(state).time);
  EXPECT_EQ(times, (std::vector<double>{0.0, 0.033, 0.05, 0.1}));
}

TEST_F(EndToEnd, OneThreadAndTwoGiveTheSameBits) {
  for (const fs::path& scene : {column_, tank_}) {
    const std::string name = scene.stem().string();
    for (const char* threads : {"1", "2"}) {
      const ProcessResult result = run(scene, name + "_" + threads, {"--threads", threads});
      ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    for (const char* sort : {".vtp", ".vti", ".csv", ".png"}) {
      const auto one = files_of_sort(folder_ / (name + "_1"), sort);
      EXPECT_THAT(one, Not(IsEmpty()));
      EXPECT_TRUE(one == files_of_sort(folder_ / (name + "_2"), sort)) << scene << " " << sort;
    }
  }
}

TEST_F(EndToEnd, FramesDoNotChangeTheResult) {
  const std::vector<std::string> few_states = {"--set", "output.particles_times=[0.1]"};
  ASSERT_EQ(run(column_, "with", few_states).exit_code, 0);
  std::vector<std::string> without = few_states;
  without.emplace_back("--no-frames");
  ASSERT_EQ(run(column_, "without", without).exit_code, 0);
  const auto states = files_of_sort(folder_ / "with", ".vtp");
  EXPECT_THAT(states, SizeIs(1));
  EXPECT_TRUE(states == files_of_sort(folder_ / "without", ".vtp"));
  EXPECT_THAT(files_of_sort(folder_ / "with", ".png"), SizeIs(2));
  EXPECT_THAT(files_of_sort(folder_ / "without", ".png"), IsEmpty());
}

TEST_F(EndToEnd, RenderRepeatsTheFramesOfTheRun) {
  ASSERT_EQ(run(tank_, "run").exit_code, 0);
  const ProcessResult result = run_program_with({"render", (folder_ / "run").string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto frames = files_of_sort(folder_ / "run/frames", ".png");
  EXPECT_THAT(frames, SizeIs(6));
  EXPECT_TRUE(frames == files_of_sort(folder_ / "run/rendered", ".png"));
}

TEST_F(EndToEnd, ViewShowsASceneAndARunInAWindow) {
  const auto view = [&](const fs::path& subject, const char* until) {
    return run_program_with({"view", subject.string(), "--until", until, "--width", "640", "--height", "480",
                             "--threads", "1", "--out", (folder_ / "seen").string()});
  };
  {
    const WithoutDisplay nothing;
    const ProcessResult result = view(tank_, "0.04");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("no window can be opened"));
  }
  const VirtualDisplay display;
  const ProcessResult live = view(tank_, "0.04");
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_THAT(live.out, HasSubstr("tank: t = 0.04 s"));
  ASSERT_EQ(run(column_, "run", {"--no-frames"}).exit_code, 0);
  const ProcessResult recorded = view(folder_ / "run", "0.05");
  EXPECT_EQ(recorded.exit_code, 0) << recorded.err;
  EXPECT_THAT(recorded.out, HasSubstr("column: t = 0.05 s"));
  EXPECT_FALSE(fs::exists(folder_ / "seen")) << "nothing is written unasked";
  EXPECT_EQ(view(folder_ / "nowhere", "0.1").exit_code, 2);
}

TEST_F(EndToEnd, ARecordedRunIsShownStateByState) {
  ASSERT_EQ(run(column_, "run", {"--no-frames"}).exit_code, 0);
  RecordedRun recorded(folder_ / "run");
  EXPECT_EQ(recorded.saved_times(), (std::vector<double>{0.0, 0.033, 0.05, 0.1}));
  EXPECT_EQ(recorded.latest()->time, 0.0);
  recorded.step();
  EXPECT_EQ(recorded.latest()->time, 0.033);
  EXPECT_FALSE(recorded.status().at_end);
  recorded.show(3);
  EXPECT_EQ(recorded.latest()->time, 0.1);
  EXPECT_TRUE(recorded.status().at_end);
  const auto plots = recorded.plots();
  EXPECT_TRUE(std::any_of(plots->begin(), plots->end(), [](const ProbePlot& plot) {
    return plot.title == "gauge_wall" && plot.x.size() == 11;
  }));
  recorded.restart();
  std::vector<double> taken;
  recorded.record(0.0, [&](const Snapshot& snapshot) { taken.push_back(snapshot.time); });
  recorded.play();
  EXPECT_TRUE(recorded.status().playing);
  std::this_thread::sleep_for(std::chrono::milliseconds(150));  // all states are due, one is shown in a round
  for (int k = 0; k < 20 && recorded.status().playing; ++k) {
    static_cast<void>(recorded.latest());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_FALSE(recorded.status().playing);
  EXPECT_EQ(taken, (std::vector<double>{0.033, 0.05, 0.1}));
}

TEST_F(EndToEnd, VideoJoinsTheFramesOfTheRun) {
  ASSERT_EQ(run(tank_, "run").exit_code, 0);
  const std::string folder = (folder_ / "run").string();
  const ProcessResult unknown = run_program_with({"video", folder, "--image", "absent"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("it has those of all, map, view"));
  EXPECT_THAT(run_program_with({"video", (folder_ / "nothing").string()}).err, HasSubstr("holds no frames"));
  const ProcessResult result = run_program_with({"video", folder, "--rate", "2"});
  if (!has_ffmpeg()) {
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("Debian package ffmpeg"));
    return;
  }
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("all.mp4: 2 frames, 1 s"));
  for (const char* name : {"all.mp4", "map.mp4", "view.mp4"}) {
    const std::string video = text_of(folder_ / "run/video" / name);
    // The index of a video that starts at once stands before its pictures.
    EXPECT_LT(video.find("moov"), video.find("mdat")) << name;
    EXPECT_THAT(video, HasSubstr("avc1"));
  }
}

TEST_F(EndToEnd, RenderDrawsOtherFieldsAndChosenTimes) {
  ASSERT_EQ(run(tank_, "run").exit_code, 0);
  const ProcessResult result =
      run_program_with({"render", (folder_ / "run").string(), "--image", "view", "--time", "0.06", "--set",
                        "image.view.field=pressure", "--out", (folder_ / "again").string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("1 frames in"));
  const auto drawn = files_of_sort(folder_ / "again", ".png");
  ASSERT_THAT(drawn, SizeIs(1));
  EXPECT_EQ(drawn.begin()->first, "view_0001.png");
  EXPECT_NE(drawn.begin()->second, text_of(folder_ / "run/frames/view_0001.png"));
}

TEST_F(EndToEnd, BadInputWritesNothingAndExitsWith2) {
  const std::vector<std::vector<std::string>> faults = {
      {"--set", "particles.spacin=0.1"},
      {"--set", "end_time=-1"},
      {"--until", "7"},
      {"--threads", "0"},
      {"--bogus"},
  };
  for (const auto& options : faults) {
    const ProcessResult result = run(column_, "bad", options);
    EXPECT_EQ(result.exit_code, 2) << options.front();
    EXPECT_THAT(result.err, StartsWith("eisph: "));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(fs::exists(folder_ / "bad"));
  }
  EXPECT_EQ(run(folder_ / "missing.toml", "bad").exit_code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "bad"));
}

TEST_F(EndToEnd, AFolderThatIsNoRunOfTheSceneIsLeftAlone) {
  fs::create_directory(folder_ / "mine");
  put_text(folder_ / "mine/notes.txt", "notes");
  EXPECT_EQ(run(column_, "mine").exit_code, 2);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "mine"), {}), 1);

  ASSERT_EQ(run(tank_, "tank", {"--until", "0.02"}).exit_code, 0);
  const ProcessResult refused = run(column_, "tank");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("a run of the scene \"tank\", not of \"column\""));
  EXPECT_EQ(summary("tank")["scene"], "tank");
}

TEST_F(EndToEnd, ASecondRunReplacesTheFirst) {
  ASSERT_EQ(run(column_, "run").exit_code, 0);
  put_text(folder_ / "run/notes.txt", "notes");
  ASSERT_EQ(run(column_, "run", {"--until", "0.04"}).exit_code, 0);
  EXPECT_THAT(saved_states({folder_ / "run"}), SizeIs(2));
  EXPECT_FALSE(fs::exists(folder_ / "run/particles/particles_0002.vtp"));
  EXPECT_THAT(files_of_sort(folder_ / "run", ".png"), SizeIs(1));
  EXPECT_TRUE(fs::exists(folder_ / "run/notes.txt"));
  EXPECT_EQ(summary("run")["simulated_time"], 0.04);
}

TEST_F(EndToEnd, ABlowUpExitsWith3AndKeepsWhatCameBefore) {
  // The first two steps still end within the range, the third does not.
  std::vector<std::string> options;
  for (const char* setting :
       {"scheme.time_step=0.05", "end_time=20.0", "gauge.wall.interval=20.0", "probe.corner.interval=20.0",
        "output.depth_interval=0", "output.times=[0.05, 10.0]", "output.particles_times=[0.0, 0.05, 10.0]"}) {
    options.insert(options.end(), {"--set", setting});
  }
  const ProcessResult result = run(column_, "run", options);
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, AllOf(StartsWith("eisph: "), HasSubstr("t = 0.1 s"), HasSubstr("particle ")));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  const nlohmann::json figures = summary("run");
  EXPECT_EQ(figures["status"], "blown_up");
  EXPECT_THAT(figures["message"].get<std::string>(), HasSubstr("particle "));
  EXPECT_EQ(figures["frames_written"], 1);
  const std::vector<SavedState> states = saved_states({folder_ / "run"});
  ASSERT_THAT(states, SizeIs(2));
  EXPECT_THAT(read_state(states[1]).position, SizeIs(200));
}

/// Waits until the file is there; false after half a minute.
bool appears(const fs::path& file) {
  for (int wait = 0; wait < 3000 && !fs::exists(file); ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return fs::exists(file);
}

TEST_F(EndToEnd, CtrlCLeavesAValidRunAndExitsWith130) {
  const fs::path run_folder = folder_ / "run";
  ChildProcess child({"run", column_.string(), "--quiet", "--out", run_folder.string(), "--set",
                      "end_time=10000.0", "--set", "output.particles_times=[]", "--set",
                      "output.particles_interval=0.01"});
  ASSERT_TRUE(appears(run_folder / "particles/particles_0003.vtp"));
  child.send(SIGINT);
  EXPECT_EQ(child.wait().exit_code, 130);
  EXPECT_EQ(summary("run")["status"], "interrupted");
  const std::vector<SavedState> states = saved_states({run_folder});
  EXPECT_GE(states.size(), 4);
  EXPECT_THAT(read_state(states.back()).position, SizeIs(200));
  EXPECT_EQ(run_program_with({"render", run_folder.string(), "--time", "0.02"}).exit_code, 0);
}

TEST_F(EndToEnd, CheckTellsWhatWouldBeSimulatedAndWritesNothing) {
  const ProcessResult result = run_program_with({"check", tank_.string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("1000 fluid"), HasSubstr("time step"), HasSubstr("2 of \"view\"")));
  EXPECT_THAT(result.out, Not(HasSubstr("warning")));
  EXPECT_EQ(folder_.file_count(), 2);
  const ProcessResult thin =
      run_program_with({"check", tank_.string(), "--set", "obstacle.block.max=[0.32,0.14,0.1]"});
  EXPECT_THAT(thin.out, HasSubstr("warning: obstacle \"block\""));
}

TEST_F(EndToEnd, SchemaHelpAndVersionArePrinted) {
  const ProcessResult schema = run_program_with({"check", "--schema"});
  EXPECT_EQ(schema.exit_code, 0);
  EXPECT_THAT(schema.out, HasSubstr("smoothing_ratio"));
  EXPECT_THAT(run_program_with({"--version"}).out, StartsWith("eisph "));
  const ProcessResult help = run_program_with({"run", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("--until"), HasSubstr("--no-frames")));
}

}  // namespace
}  // namespace eisph
