#include "io/comparison_file.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using testing::HasSubstr;

const std::string kText = R"(title = "Test 4"
run = "../run"
area = [0.825, 0.0, 2.6, 1.2]
[[photograph]]
file = "a.png"
time = 0.4
[[photograph]]
file = "b.png"
time = 0.75
[registration]
radial_distortion = false
[[registration.point]]
name = "lower left"
position = [0.825, 0.0]
pixel = [20.5, 780.0]
[[registration.point]]
name = "lower right"
position = [2.6, 0.0]
pixel = [980.0, 781.0]
[[registration.point]]
name = "upper right"
position = [2.6, 1.2]
pixel = [979.0, 20.0]
[[registration.point]]
name = "upper left"
position = [0.825, 1.2]
pixel = [21.0, 19.0]
[calibration]
[[calibration.photograph]]
file = "dry.png"
depth = 0.0
[[calibration.photograph]]
file = "full.png"
depth = 0.15
[rims]
fill = "leave_out"
polygons = [[[0.9, 0.1], [1.0, 0.1], [1.0, 0.2]]]
)";

/// A folder with the comparison file and empty files where photographs are meant to be.
class ComparisonFile : public testing::Test {
 protected:
  ComparisonFile() {
    for (const char* name : {"a.png", "b.png", "dry.png", "full.png"}) put_text(folder_ / name, "");
  }

  Comparison load(const std::string& text, const std::vector<std::string>& overrides = {}) {
    put_text(folder_ / "case.toml", text);
    return load_comparison(folder_ / "case.toml", overrides);
  }

  std::string error(const std::string& from, const std::string& to) {
    std::string text = kText;
    text.replace(text.find(from), from.size(), to);
    return error_of<InputError>([&] { (void)load(text); });
  }

  TemporaryFolder folder_;
};

TEST_F(ComparisonFile, FillsSettingsAndResolvesPathsFromItsFolder) {
  const Comparison comparison = load(kText);
  EXPECT_EQ(comparison.title, "Test 4");
  ASSERT_EQ(comparison.photographs.size(), 2U);
  EXPECT_EQ(comparison.photographs[1].file, folder_ / "b.png");
  EXPECT_EQ(comparison.photographs[1].time, 0.75);
  EXPECT_EQ(comparison.run, (folder_.path().parent_path() / "run"));
  ASSERT_EQ(comparison.registration.points.size(), 4U);
  EXPECT_EQ(comparison.registration.points[2].pixel, (PlanePoint{979.0, 20.0}));
  EXPECT_EQ(comparison.calibration.photographs[1].depth, 0.15);
  EXPECT_EQ(comparison.rims.fill, RimFill::LeaveOut);
  ASSERT_EQ(comparison.rims.polygons.size(), 1U);
  EXPECT_EQ(comparison.rims.polygons[0][2], (PlanePoint{1.0, 0.2}));
  EXPECT_EQ((*comparison.area)[2], 2.6);
}

TEST_F(ComparisonFile, DefaultsAreThoseOfTheThesis) {
  const Comparison comparison = load(kText, {"rims.fill=nearest_plus_10"});
  EXPECT_EQ(comparison.rims.fill, RimFill::NearestPlus10);
  EXPECT_EQ(comparison.deviation.classes, 60);
  EXPECT_EQ(comparison.deviation.depth_rule, DepthRule::HighestParticle);
  EXPECT_EQ(comparison.deviation.dry_depth, 0.005);
  EXPECT_FALSE(comparison.synthetic);
}

TEST_F(ComparisonFile, SprayIsIgnoredUnlessItIsToCount) {
  EXPECT_TRUE(load(kText).deviation.ignore_spray);
  EXPECT_FALSE(load(kText, {"deviation.ignore_spray=false"}).deviation.ignore_spray);
}

TEST_F(ComparisonFile, WhatIsWrittenReadsBackTheSame) {
  Comparison comparison =
      load(kText, {"calibration.tolerance=4", "synthetic=true", "deviation.ignore_spray=false"});
  Comparison again = load(comparison_toml(comparison));
  EXPECT_EQ(again, comparison);
}

TEST_F(ComparisonFile, ATableOfLevelsHoldsForAllPixels) {
  std::string text = kText;
  const std::size_t begin = text.find("[[calibration.photograph]]");
  text.replace(begin, text.find("[rims]") - begin,
               "[[calibration.level]]\nlevel = 235\ndepth = 0.0\n[[calibration.level]]\nlevel = 25\n"
               "depth = 0.15\n");
  const Comparison comparison = load(text);
  EXPECT_EQ(comparison.calibration.levels.size(), 2U);
  EXPECT_FALSE(comparison.calibration.per_pixel);
}

TEST_F(ComparisonFile, ReferenceNamesAllSections) {
  const std::string text = comparison_schema_text();
  for (const char* piece : {"[[photograph]]", "[registration]", "[[registration.point]]", "[calibration]",
                            "[rims]", "[deviation]", "[images]"}) {
    EXPECT_THAT(text, HasSubstr(piece));
  }
}

TEST_F(ComparisonFile, ErrorsNameFileLineKeyAndValue) {
  struct Case {
    const char* from;
    const char* to;
    std::vector<std::string> pieces;
  };
  const std::vector<Case> cases = {
      {"file = \"b.png\"", "file = \"c.png\"", {"case.toml:8: ", "photograph.1.file = \"c.png\"", "no file"}},
      {"time = 0.75", "time = 0.4", {"case.toml:9: ", "photograph.1.time = 0.4", "more than 0.4 s"}},
      {"position = [2.6, 0.0]", "position = [2.6]", {"registration.point.1.position", "two numbers"}},
      {"[[registration.point]]\nname = \"upper left\"\nposition = [0.825, 1.2]\npixel = [21.0, 19.0]\n",
       "",
       {"case.toml:10: ", "3 reference points", "at least 4"}},
      {"radial_distortion = false", "radial_distortion = true", {"4 reference points", "at least 5"}},
      {"[[calibration.photograph]]\nfile = \"full.png\"\ndepth = 0.15\n", "", {"calibration", "two or more"}},
      {"fill = \"leave_out\"", "fill = \"guess\"", {"rims.fill = \"guess\"", "nearest_plus_10"}},
      {"[1.0, 0.1], [1.0, 0.2]]]", "[1.0, 0.1]]]", {"rims.polygons", "at least three points"}},
      {"area = [0.825, 0.0, 2.6, 1.2]", "area = [2.6, 0.0, 0.825, 1.2]", {"case.toml:3: ", "x_min < x_max"}},
      {"[rims]", "[rims]\nbannd = 1.0", {"rims.bannd", "band"}},
  };
  for (const Case& error_case : cases) {
    const std::string message = error(error_case.from, error_case.to);
    for (const std::string& piece : error_case.pieces) EXPECT_THAT(message, HasSubstr(piece));
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST_F(ComparisonFile, MissingFileIsNamed) {
  const std::string message = error_of<InputError>([&] { (void)load_comparison(folder_ / "none.toml"); });
  EXPECT_THAT(message, HasSubstr("none.toml"));
  EXPECT_THAT(message, HasSubstr("comparison file"));
}

}  // namespace
}  // namespace eisph
