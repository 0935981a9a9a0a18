#include "app/commands.hpp"
#include "app/scene_report.hpp"
#include "app/stability/stability_atlas.hpp"
#include "core/assets.hpp"
#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "io/temporary_folder.hpp"
#include "scheme/simulation.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

bool never() { return false; }

Scene hard_scene(const std::string& name, const std::vector<std::string>& overrides) {
  return load_scene(home_folder() / "scenes" / (name + ".toml"), overrides);
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Stability, JudgesByLossesCompressionAndEnergy) {
  RunSummary summary;
  summary.energy_initial = 100.0;
  summary.simulated_time = 2.0;
  EXPECT_EQ(judge(summary, 0.04).stability, Stability::Stable);
  EXPECT_EQ(judge(summary, 0.04).time, 2.0);
  EXPECT_THAT(judge(summary, 0.06).reason, HasSubstr("compression 6 %"));
  summary.energy_gain_max = 3.0;
  summary.penetrations = 4;
  summary.lost_particles = 2;
  const StabilityOutcome outcome = judge(summary, 0.0);
  EXPECT_EQ(outcome.stability, Stability::Degraded);
  EXPECT_THAT(outcome.reason, AllOf(HasSubstr("2 particles lost"), HasSubstr("4 penetrations"),
                                    HasSubstr("energy gain 3 %")));
}

TEST(Stability, TellsAStableRunFromABlowUp) {
  const std::vector<std::string> short_run = {"particles.spacing=0.02", "end_time=0.4"};
  EXPECT_EQ(try_out(hard_scene("hard/narrow_gap", short_run), 1, never).stability, Stability::Stable);
  const StabilityOutcome outcome = try_out(
      hard_scene("hard/wall_impact", {"particles.spacing=0.04", "scheme.name=wcsph", "scheme.courant=4.0"}),
      1, never);
  EXPECT_EQ(outcome.stability, Stability::BlownUp);
  EXPECT_THAT(outcome.reason, AllOf(HasSubstr("t = "), HasSubstr("particle"), HasSubstr("scheme.courant")));
  EXPECT_LT(outcome.time, 1.5);
}

TEST(Stability, EveryHardSceneLoadsWithoutAWarning) {
  for (const StabilityCase& hard : stability_cases(true)) {
    std::vector<std::string> overrides = hard.overrides;
    if (!hard.variants.empty()) {
      overrides.insert(overrides.end(), hard.variants[0].begin(), hard.variants[0].end());
    }
    const Scene scene = hard_scene(hard.scene, overrides);
    const auto warnings = scene_warnings(scene, Simulation::create(scene, 1)->plan());
    if (hard.name == "square_patch") {
      EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("clamp_pressure"))) << hard.name;
    } else {
      EXPECT_THAT(warnings, testing::IsEmpty()) << hard.name;
    }
  }
}

TEST(Stability, TheLongestStepOfEverySchemeIsAccepted) {
  const double longest = *std::max_element(std::begin(kFullStepFactors), std::end(kFullStepFactors));
  for (const StabilityScheme& scheme : stability_schemes()) {
    std::vector<std::string> overrides = scheme.overrides;
    overrides.push_back("scheme." + scheme.step_key + "=" + std::to_string(longest * scheme.step));
    EXPECT_NO_THROW(hard_scene("hard/drop", overrides)) << scheme.name;
  }
}

TEST(Stability, WritesTablesMapsAndAReport) {
  const TemporaryFolder folder;
  StabilityOptions options;
  options.cases = {"drop"};
  options.out = folder.path() / "atlas";
  std::ostringstream out;
  EXPECT_EQ(stability_command(options, out), 0);
  EXPECT_THAT(out.str(),
              AllOf(HasSubstr("drop"), HasSubstr("delta-SPH, Runge-Kutta"), HasSubstr("report in")));
  const std::string csv = text_of(options.out / "atlas.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 6 * 2) << "six schemes at two time steps";
  EXPECT_THAT(text_of(options.out / "atlas.json"), HasSubstr("\"outcome\": \"blown up\""));
  EXPECT_THAT(text_of(options.out / "report.html"), HasSubstr("Where the schemes are stable"));
  EXPECT_TRUE(std::filesystem::exists(options.out / "EISPHthesis.png"));
}

TEST(Stability, RunsOnlyTheSchemesAskedFor) {
  const TemporaryFolder folder;
  StabilityOptions options;
  options.cases = {"narrow_gap"};
  options.only = {"ISPH"};
  options.out = folder.path() / "atlas";
  std::ostringstream out;
  EXPECT_EQ(stability_command(options, out), 0);
  const std::string csv = text_of(options.out / "atlas.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2) << "one scheme at two time steps";
  EXPECT_THAT(csv, testing::Not(HasSubstr("EISPH")));
  options.only = {"upwind"};
  EXPECT_THROW(static_cast<void>(stability_command(options, out)), InputError);
}

TEST(Stability, NamesTheCasesItKnows) {
  StabilityOptions options;
  options.cases = {"tsunami"};
  std::ostringstream out;
  try {
    static_cast<void>(stability_command(options, out));
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("tsunami"), HasSubstr("still_water"), HasSubstr("odd_tank")));
  }
}

}  // namespace
}  // namespace eisph
