#include "app/commands.hpp"
#include "app/pareto/pareto_study.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Pareto, TakesTheMedianOfTheRepetitions) {
  ParetoPoint point;
  EXPECT_TRUE(std::isnan(point.cpu_time()));
  point.cpu_times = {3.0, 9.0, 1.0};
  EXPECT_EQ(point.cpu_time(), 3.0);
  point.cpu_times.push_back(5.0);
  EXPECT_EQ(point.cpu_time(), 4.0);
}

/// Water at rest at the coarsest spacing, to the end of 20 ms.
ParetoCase small_case() {
  ParetoCase small;
  small.name = "small";
  small.title = "Small";
  small.scene = "still_water";
  small.quick_spacings = {0.05};
  small.quick_end = 0.02;
  small.errors = {{"particles", "number of particles over a hundred",
                   [](const ValidationRun& run, const ValidationRun* reference) {
                     return 0.01 * static_cast<double>(run.summary.fluid_particles) +
                            (reference == nullptr ? 0.0 : 0.5);
                   }}};
  return small;
}

TEST(Pareto, RunsEverySettingAsOftenAsAskedAndCostsIt) {
  const TemporaryFolder folder;
  std::ostringstream progress;
  Validator validator({folder.path(), 1, false, true}, progress, [] { return false; });
  ParetoCase small = small_case();
  const ParetoResult result = study(small, pareto_settings(), 2, validator);
  ASSERT_EQ(result.points.size(), pareto_settings().size());
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    const ParetoPoint& point = result.points[k];
    EXPECT_EQ(point.scheme, pareto_settings()[k].scheme) << "in the order of the settings";
    EXPECT_EQ(point.step, pareto_settings()[k].step);
    EXPECT_EQ(point.failure, "");
    EXPECT_EQ(point.cpu_times.size(), 2U);
    EXPECT_GT(point.cpu_time(), 0.0);
    EXPECT_GT(point.pair_evaluations, 0.0);
    EXPECT_THAT(point.errors, testing::ElementsAre(testing::DoubleEq(1.2)));
  }
  EXPECT_EQ(result.reference_spacing, 0.0);
}

TEST(Pareto, HoldsRunsAgainstAReferenceAtHalfTheSpacingAndWritesAllOfIt) {
  const TemporaryFolder folder;
  std::ostringstream progress;
  Validator validator({folder.path(), 1, false, true}, progress, [] { return false; });
  ParetoCase small = small_case();
  small.reference = {"scheme.phi=0.1"};
  const ParetoResult result = study(small, pareto_settings(), 1, validator);
  EXPECT_EQ(result.reference_spacing, 0.025);
  EXPECT_THAT(result.reference_spread, testing::ElementsAre(testing::DoubleEq(5.3)));
  EXPECT_THAT(result.points[0].errors, testing::ElementsAre(testing::DoubleEq(1.7)));

  write_pareto_case(folder.path(), result);
  write_pareto_report(folder.path(), {result}, "test");
  std::ifstream json_file(folder.path() / "pareto.json");
  const auto json = nlohmann::json::parse(json_file);
  EXPECT_EQ(json["cases"][0]["points"].size(), result.points.size());
  EXPECT_EQ(json["cases"][0]["points"][0]["errors"]["particles"]["value"], 1.7);
  std::ifstream csv_file(folder.path() / "small.csv");
  std::string line;
  std::size_t lines = 0;
  while (std::getline(csv_file, line)) ++lines;
  EXPECT_EQ(lines, 1 + result.points.size());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "small_particles.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "small_particles_pairs.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "report.html"));
}

TEST(Pareto, ChoosesSettingsByAPartOfTheirNames) {
  EXPECT_EQ(choose_settings({}).size(), pareto_settings().size());
  const auto chosen = choose_settings({"ISPH, phi 0.06", "delta-SPH, Courant"});
  std::vector<std::string> names;
  for (const ParetoSetting& setting : chosen) names.push_back(setting_name(setting.scheme, setting.step));
  EXPECT_THAT(names,
              testing::ElementsAre("ISPH, phi 0.06", "delta-SPH, Courant 0.25", "delta-SPH, Courant 0.5"));
  try {
    static_cast<void>(choose_settings({"WCSPH", "phi 0.99"}));
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("phi 0.99"), HasSubstr("'EISPH, phi 0.17'")));
  }
}

TEST(Pareto, NamesTheCasesItKnows) {
  ParetoOptions options;
  options.cases = {"tsunami"};
  std::ostringstream out;
  try {
    static_cast<void>(pareto_command(options, out, out));
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("tsunami"), HasSubstr("buchner"), HasSubstr("ritter_long")));
  }
  options.list = true;
  EXPECT_EQ(pareto_command(options, out, out), 0);
  EXPECT_THAT(out.str(), HasSubstr("shao_lo_3d"));
}

}  // namespace
}  // namespace eisph
