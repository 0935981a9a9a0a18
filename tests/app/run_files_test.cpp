#include "app/run_files.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::HasSubstr;

constexpr const char* kScene = R"(name = "column"
end_time = 1.0
dimension = 2
[particles]
spacing = 0.01
[fluid]
[[fluid.region]]
min = [0.0, 0.0]
max = [0.1, 0.1]
[domain]
min = [0.0, 0.0]
max = [0.3, 0.3]
)";

std::string refusal_of(const RunFiles& files, const std::string& scene_name) {
  return error_of<InputError>([&] { check_run_folder(files, scene_name); });
}

class RunFolder : public ::testing::Test {
 protected:
  /// A file below the run's folder, with the folders above it.
  void put(const std::string& name, const std::string& text = "content") const {
    std::filesystem::create_directories((files_.folder / name).parent_path());
    put_text(files_.folder / name, text);
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return std::filesystem::exists(files_.folder / name);
  }

  TemporaryFolder temporary_;
  RunFiles files_{temporary_ / "run"};
};

TEST_F(RunFolder, ThatDoesNotExistOrIsEmptyIsAccepted) {
  EXPECT_EQ(refusal_of(files_, "column"), "");
  std::filesystem::create_directory(files_.folder);
  EXPECT_EQ(refusal_of(files_, "column"), "");
}

TEST_F(RunFolder, OfTheSameSceneIsAccepted) {
  put("run.json", R"({"scene": "column"})");
  EXPECT_EQ(refusal_of(files_, "column"), "");
}

TEST_F(RunFolder, OfARunThatWasKilledIsKnownByItsScene) {
  put("scene.toml", kScene);
  EXPECT_EQ(refusal_of(files_, "column"), "");
  EXPECT_THAT(refusal_of(files_, "tank"), HasSubstr("\"column\""));
}

TEST_F(RunFolder, OfAnotherSceneIsRefused) {
  put("run.json", R"({"scene": "column"})");
  EXPECT_THAT(refusal_of(files_, "tank"), HasSubstr("a run of the scene \"column\", not of \"tank\""));
}

TEST_F(RunFolder, WithOtherContentIsRefused) {
  put("thesis.txt");
  EXPECT_THAT(refusal_of(files_, "column"), HasSubstr("holds no run of eisph"));
  put("run.json", "not JSON at all");
  EXPECT_THAT(refusal_of(files_, "column"), HasSubstr("holds no run of eisph"));
}

TEST_F(RunFolder, ThatIsAFileIsRefused) {
  put_text(files_.folder, "content");
  EXPECT_THAT(refusal_of(files_, "column"), HasSubstr("is a file"));
}

TEST_F(RunFolder, LosesTheFilesOfAnEarlierRun) {
  for (const char* name : {"scene.toml",
                           "run.json",
                           "run.log",
                           "particles.pvd",
                           "objects.pvd",
                           "depth.pvd",
                           "gauge_a.csv",
                           "probe_corner.csv",
                           "ledger.csv",
                           "leading_edge.csv",
                           "pressure_sensor_a.csv",
                           "front_a.csv",
                           "line_a.csv",
                           "force_a.csv",
                           "discharge_a.csv",
                           "frames/view_0000.png",
                           "frames/view_0001.png.part",
                           "particles/particles_0000.vtp",
                           "particles/objects_0000.vtp",
                           "particles/particles_12345.vtp.tmp",
                           "depth/depth_0000.vti",
                           "rendered/view_0000.png",
                           "rendered/view_t0.25.png",
                           "video/view.mp4"}) {
    put(name);
  }
  prepare_run_folder(files_);
  EXPECT_TRUE(std::filesystem::is_directory(files_.folder));
  EXPECT_TRUE(std::filesystem::is_empty(files_.folder));
}

TEST_F(RunFolder, KeepsFilesThatNoRunHasWritten) {
  const std::vector<std::string> others = {"notes.txt",       "measured.csv",        "frames/view.png",
                                           "frames/film.mp4", "depth/plot_0000.png", "own/view_0000.png",
                                           "particles/a.vtp"};
  for (const std::string& name : others) put(name);
  prepare_run_folder(files_);
  for (const std::string& name : others) EXPECT_TRUE(has(name)) << name;
}

TEST(RunFiles, AreNumberedWithAtLeastFourDigits) {
  const RunFiles files{"run"};
  EXPECT_EQ(files.particles(7), "run/particles/particles_0007.vtp");
  EXPECT_EQ(files.depth(12345), "run/depth/depth_12345.vti");
  EXPECT_EQ(frame_file_name("view", 3), "view_0003.png");
}

}  // namespace
}  // namespace eisph
