#include "app/commands.hpp"
#include "app/comparison/run_depths.hpp"
#include "app/comparison/synthetic_settings.hpp"
#include "app/run_files.hpp"
#include "compare/number_table.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"
#include "render/grey_png.hpp"
#include "render/png_file.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kScene = R"(title = "A wave past a block"
dimension = 3
end_time = 0.4
[particles]
spacing = 0.02
[[fluid.region]]
min = [0.0, 0.0, 0.0]
max = [0.4, 0.6, 0.12]
[domain]
min = [0.0, 0.0, 0.0]
max = [1.2, 0.6, 0.4]
[[obstacle]]
name = "block"
min = [0.69, 0.21, 0.0]
max = [0.81, 0.39, 0.3]
[scheme]
name = "shallow_water"
[output]
times = [0.2, 0.4]
)";

/// The lower half of the scene above.
std::string half_of(std::string scene) {
  const auto put = [&scene](const std::string& from, const std::string& to) {
    scene.replace(scene.find(from), from.size(), to);
  };
  put("max = [0.4, 0.6, 0.12]", "max = [0.4, 0.3, 0.12]");
  put("max = [1.2, 0.6, 0.4]", "max = [1.2, 0.3, 0.4]\n[domain.faces]\ny_max = \"symmetry\"");
  put("max = [0.81, 0.39, 0.3]", "max = [0.81, 0.3, 0.3]");
  return scene;
}

/// A finished run of shallow water and its synthetic photographs.
class CompareCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    run_scene_text("whole", kScene);
    PhotographOptions options;
    options.run_folder = run("whole");
    options.out = photographs();
    options.area = std::array<double, 4>{0.4, 0.0, 1.2, 0.6};
    options.overrides = {"camera.width=400", "camera.height=320", "rims.width=0", "light.noise=0.5"};
    std::ostringstream out;
    ASSERT_EQ(photograph_command(options, out), 0);
    EXPECT_THAT(out.str(), HasSubstr("2 synthetic photographs"));
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::filesystem::path run(const std::string& name) { return *folder_ / name; }
  static std::filesystem::path photographs() { return *folder_ / "photographs"; }
  static std::filesystem::path comparison() { return photographs() / "comparison.toml"; }

  static void run_scene_text(const std::string& name, const std::string& text,
                             const std::vector<std::string>& overrides = {}) {
    put_text(*folder_ / (name + ".toml"), text);
    RunOptions options;
    options.scene = *folder_ / (name + ".toml");
    options.out = run(name);
    options.overrides = overrides;
    options.frames = false;
    options.quiet = true;
    std::ostringstream ignored;
    ASSERT_EQ(run_command(options, ignored, ignored), 0);
  }

  static CompareOptions options(const std::string& out, const std::vector<std::string>& overrides = {}) {
    CompareOptions options;
    options.comparison = comparison();
    options.run = run("whole");
    options.out = *folder_ / out;
    options.overrides = overrides;
    options.overrides.emplace_back("rims.detection=none");  // there are none in these photographs
    return options;
  }

  static std::string printed(const CompareOptions& options) {
    std::ostringstream out;
    EXPECT_EQ(compare_command(options, out), 0);
    return out.str();
  }

  /// A statistic of the first row, mm.
  static double statistic(const std::string& out, const std::string& name) {
    const std::string text = text_of(*folder_ / out / "statistics.csv");
    std::istringstream lines(text);
    std::string header;
    std::string row;
    std::getline(lines, header);
    std::getline(lines, row);
    const std::string after_name = row.substr(row.find("\",") + 1);
    const std::string wanted = "," + name + " [";
    const auto fields_before =
        std::count(header.begin(), header.begin() + static_cast<long>(header.find(wanted)), ',');
    std::istringstream fields(after_name);
    std::string field;
    std::getline(fields, field, ',');  // what is left of the name
    for (long k = 0; k <= fields_before; ++k) std::getline(fields, field, ',');
    return 1000.0 * std::stod(field);
  }

  /// Message of a comparison that is refused; nothing may be written.
  static std::string refusal(const std::vector<std::string>& overrides) {
    const CompareOptions refused = options("refused", overrides);
    std::ostringstream out;
    const std::string message = error_of<InputError>([&] { (void)compare_command(refused, out); });
    EXPECT_FALSE(std::filesystem::exists(*refused.out)) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
  }

  static TemporaryFolder* folder_;
};

TemporaryFolder* CompareCommand::folder_ = nullptr;

TEST_F(CompareCommand, ARunAgreesWithItsOwnPhotographs) {
  const std::string out = printed(options("own", {"images.width=700"}));
  EXPECT_THAT(out, AllOf(HasSubstr("synthetic"), HasSubstr("2 photographs"), HasSubstr("report.html")));
  EXPECT_LT(statistic("own", "rms"), 2.0);
  EXPECT_LT(std::abs(statistic("own", "mean")), 0.3);
  EXPECT_GT(statistic("own", "correlation"), 990.0);
  EXPECT_GT(statistic("own", "wetted_overlap"), 950.0);
  const std::filesystem::path folder = *folder_ / "own";
  for (const char* kind : {"photograph_and_depth", "depths", "overlay", "deviation"}) {
    for (const char* number : {"0000", "0001"})
      EXPECT_EQ(read_png(folder / (std::string(kind) + "_" + number + ".png")).image.width, 700);
  }
  const NumberTable classes = read_number_table(folder / "classes.csv");
  EXPECT_EQ(classes.rows(), 60U);
  EXPECT_NEAR(classes.column("cumulative_share").back(), 1.0, 1e-9);
  const std::string html = text_of(folder / "report.html");
  EXPECT_THAT(html,
              AllOf(HasSubstr("The photographs are synthetic"), HasSubstr("thesis, table 4"),
                    HasSubstr("Standard deviation over 40 repetitions"), HasSubstr("depth of the model")));
  EXPECT_THAT(html, testing::Not(HasSubstr("file:")));
}

TEST_F(CompareCommand, SecondComparisonReplacesTheFirst) {
  const std::filesystem::path folder = *folder_ / "again";
  (void)printed(options("again", {"registration.repetitions=0"}));
  put_text(folder / "deviation_0009.png", "left over");
  put_text(folder / "mine.txt", "kept");
  (void)printed(options("again", {"registration.repetitions=0"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "deviation_0009.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "mine.txt"));
}

TEST_F(CompareCommand, BesideTheRunItFindsTheSameAsAfterwards) {
  run_scene_text("beside", kScene, {"comparison=" + comparison().string()});
  CompareOptions after = options("after");
  after.overrides.clear();
  (void)printed(after);
  EXPECT_EQ(text_of(run("beside") / "comparison" / "statistics.csv"),
            text_of(*folder_ / "after" / "statistics.csv"));
  EXPECT_EQ(text_of(run("beside") / "comparison" / "classes.csv"),
            text_of(*folder_ / "after" / "classes.csv"));
  EXPECT_TRUE(std::filesystem::exists(run("beside") / "comparison" / "overlay_0001.png"));
}

TEST_F(CompareCommand, AHalfDomainIsMirroredAndDrawnAgainstTheWhole) {
  run_scene_text("half", half_of(kScene));
  CompareOptions half =
      options("half_compared", {"registration.repetitions=0", "other_run=" + run("whole").string()});
  half.run = run("half");
  (void)printed(half);
  EXPECT_LT(statistic("half_compared", "rms"), 2.0);
  EXPECT_GT(statistic("half_compared", "wetted_overlap"), 950.0);
  EXPECT_TRUE(std::filesystem::exists(*folder_ / "half_compared" / "halves_0000.png"));
}

TEST_F(CompareCommand, DepthGridsServeWhereNoStatesAreSaved) {
  run_scene_text("grids", kScene, {"output.particles_times=[]"});
  ASSERT_FALSE(std::filesystem::exists(RunFiles{run("grids")}.particles_collection()));
  CompareOptions grids = options("grids_compared", {"registration.repetitions=0"});
  grids.run = run("grids");
  (void)printed(grids);
  (void)printed(options("states_compared", {"registration.repetitions=0"}));
  EXPECT_NEAR(statistic("grids_compared", "rms"), statistic("states_compared", "rms"), 1e-3);
}

TEST_F(CompareCommand, DistortedPhotographsAreStraightened) {
  PhotographOptions photograph;
  photograph.run_folder = run("whole");
  photograph.out = *folder_ / "distorted";
  photograph.overrides = {"camera.width=400",
                          "camera.height=320",
                          "rims.width=0",
                          "light.noise=0",
                          "camera.radial_distortion=-0.05",
                          "camera.bit_depth=16"};
  std::ostringstream ignored;
  ASSERT_EQ(photograph_command(photograph, ignored), 0);
  CompareOptions straight = options("straight", {"registration.repetitions=0"});
  straight.comparison = *folder_ / "distorted" / "comparison.toml";
  (void)printed(straight);
  EXPECT_LT(statistic("straight", "rms"), 2.5);
  CompareOptions bent = straight;
  bent.out = *folder_ / "bent";
  bent.overrides.emplace_back("registration.radial_distortion=false");
  (void)printed(bent);
  EXPECT_GT(statistic("bent", "rms"), 1.5 * statistic("straight", "rms"));
}

TEST_F(CompareCommand, BadInputIsNamedAndNothingIsWritten) {
  EXPECT_THAT(
      refusal({"photograph.1.time=0.35"}),
      AllOf(HasSubstr("comparison.toml"), HasSubstr("photograph.1.time = 0.35"), HasSubstr("0.2, 0.4 s")));
  EXPECT_THAT(refusal({"photograph.0.file=none.png"}),
              AllOf(HasSubstr("photograph.0.file"), HasSubstr("none.png")));
  put_text(photographs() / "text.png", "no picture");
  EXPECT_THAT(refusal({"photograph.0.file=text.png"}), HasSubstr("text.png: not a PNG file"));
  write_grey_png(photographs() / "small.png", GreyPicture(40, 30), 8, {});
  EXPECT_THAT(refusal({"photograph.1.file=small.png"}),
              AllOf(HasSubstr("small.png: 40 x 30"), HasSubstr("400 x 320")));
  EXPECT_THAT(refusal({"deviation.cell_size=0.0005"}),
              AllOf(HasSubstr("deviation.cell_size"), HasSubstr("smaller than the pixels")));
  EXPECT_THAT(refusal({"calibration.photograph.1.depth=0.03", "calibration.photograph.3.depth=0.005"}),
              AllOf(HasSubstr("calibration"), HasSubstr("not monotone")));
  EXPECT_THAT(refusal({"area=[0.4, 0.0, 1.3, 0.6]"}),
              AllOf(HasSubstr("area"), HasSubstr("beyond the domain")));
  EXPECT_THAT(refusal({"registration.outline=still_150mm.png", "area=[0.4, 0.0, 1.2, 0.6]",
                       "calibration.per_pixel=1"}),
              HasSubstr("calibration.per_pixel"));
}

TEST_F(CompareCommand, CollinearPointsAreRefused) {
  std::string text = text_of(comparison());
  const std::string outline = "outline = \"empty.png\"\n";
  text.replace(text.find(outline), outline.size(), "");
  for (int k = 0; k < 4; ++k) {
    text += "[[registration.point]]\nname = \"p" + std::to_string(k) + "\"\nposition = [0." +
            std::to_string(4 + k) + ", 0.0]\npixel = [" + std::to_string(100 + 50 * k) + ", 250]\n";
  }
  put_text(photographs() / "line.toml", text);
  CompareOptions line = options("line");
  line.comparison = photographs() / "line.toml";
  std::ostringstream out;
  const std::string message = error_of<InputError>([&] { (void)compare_command(line, out); });
  EXPECT_THAT(message, AllOf(HasSubstr("line.toml: registration"), HasSubstr("lie on one line")));
  EXPECT_FALSE(std::filesystem::exists(*line.out));
}

TEST_F(CompareCommand, ARunThatEndsBeforeAPhotographIsRefused) {
  put_text(*folder_ / "early.toml", kScene);
  RunOptions early;
  early.scene = *folder_ / "early.toml";
  early.out = run("early");
  early.overrides = {"comparison=" + comparison().string(), "end_time=0.3", "output.times=[0.2]"};
  std::ostringstream out;
  EXPECT_THAT(error_of<InputError>([&] { (void)run_command(early, out, out); }),
              AllOf(HasSubstr("photograph.1.time = 0.4"), HasSubstr("0.3 s")));
  EXPECT_FALSE(std::filesystem::exists(run("early")));
}

TEST(SyntheticSettings, ComeFromTheirFileAndErrorsNameTheKey) {
  const SyntheticSettings settings = load_synthetic_settings(std::nullopt, {"light.noise=2.5"});
  SyntheticSettings defaults;
  EXPECT_EQ(settings.light.noise, 2.5);
  EXPECT_EQ(settings.camera, defaults.camera);
  EXPECT_EQ(settings.calibration_depths, defaults.calibration_depths);
  EXPECT_THAT(
      error_of<InputError>([] { (void)load_synthetic_settings(std::nullopt, {"camera.bit_depth=12"}); }),
      AllOf(HasSubstr("camera.bit_depth = 12"), HasSubstr("8 or 16")));
  EXPECT_THAT(synthetic_schema_text(), HasSubstr("extinction_length"));
}

}  // namespace
}  // namespace eisph
