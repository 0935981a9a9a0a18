#include "app/commands.hpp"
#include "app/validate/cases.hpp"
#include "app/validate/sampling.hpp"
#include "app/validate/validator.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double kSpacing = 0.01;
constexpr double kLevel = 0.1;

/// A 2D tank of 0.4 m.
Scene tank() {
  Scene scene;
  scene.dimension = 2;
  scene.particle_spacing = kSpacing;
  scene.reference_depth = kLevel;
  scene.domain_max = {0.4, 0.0, 0.3};
  scene.faces[kZMax].kind = FaceKind::Open;
  return scene;
}

/// Water at rest, 0.1 m deep from x = 0 to `length`, with its hydrostatic pressure.
Snapshot still_water(const Scene& scene, double length) {
  Snapshot state;
  state.dimension = 2;
  state.particle_spacing = kSpacing;
  state.smoothing_length = scene.smoothing_length();
  state.particle_mass = scene.density * kSpacing * kSpacing;
  state.reference_density = scene.density;
  state.objects = std::make_shared<ObjectParticles>();
  for (double z = 0.5 * kSpacing; z < kLevel; z += kSpacing) {
    for (double x = 0.5 * kSpacing; x < length; x += kSpacing) {
      state.id.push_back(static_cast<std::uint32_t>(state.id.size()));
      state.position.push_back(Vec3d(x, 0.0, z).cast<float>());
      state.velocity.emplace_back(0.03F, 0.0F, 0.04F);
      state.pressure.push_back(static_cast<float>(9810.0 * (kLevel - z)));
      state.number_density.push_back(1.0F);
    }
  }
  return state;
}

TEST(Sampling, SurfaceProfileOfStillWaterIsItsLevelAndZeroWhereItIsDry) {
  const Scene scene = tank();
  const Curve profile = surface_profile(scene, still_water(scene, 0.2), {0.0, 0.4, 0.0});
  ASSERT_THAT(profile.x, SizeIs(81));
  for (std::size_t k = 0; k < profile.size(); ++k) {
    if (profile.x[k] < 0.18) {
      EXPECT_NEAR(profile.y[k], kLevel, 1e-4) << profile.x[k];
    } else if (profile.x[k] > 0.22) {
      EXPECT_EQ(profile.y[k], 0.0) << profile.x[k];
    }
  }
}

TEST(Sampling, SurfaceProfileReadsTheColumnsOfADepthAveragedModel) {
  const Scene scene = tank();
  Snapshot state = still_water(scene, 0.4);
  auto columns = std::make_shared<ColumnField>();
  columns->cell_size = 0.1;
  columns->origin_y = -0.05;
  columns->columns = 4;
  columns->rows = 1;
  columns->bed = {0.0F, 0.05F, 0.0F, 0.05F};
  columns->depth = {0.25F, 0.125F, 0.5F, 0.0F};
  columns->velocity_x = columns->velocity_y = {0.0F, 0.0F, 0.0F, 0.0F};
  state.columns = columns;
  const Curve profile = surface_profile(scene, state, {0.0, 0.4, 0.0});
  EXPECT_FLOAT_EQ(static_cast<float>(value_at(profile, 0.05)), 0.25F);
  EXPECT_FLOAT_EQ(static_cast<float>(value_at(profile, 0.15)), 0.175F);
  EXPECT_EQ(value_at(profile, 0.35), 0.0);
}

TEST(Sampling, SurfacePointsLieOnTheLevelAndOnTheFreeSide) {
  const Scene scene = tank();
  const std::vector<PlanePoint> points = surface_points(scene, still_water(scene, 0.2), {0.0, 0.4, 0.0}, 0.2);
  ASSERT_FALSE(points.empty());
  for (const PlanePoint& point : points) {
    const bool on_top = std::abs(point.z - kLevel) < 1e-3 && point.x < 0.21;
    const bool on_side = std::abs(point.x - 0.2) < 0.01 && point.z < kLevel + 0.01;
    EXPECT_TRUE(on_top || on_side) << point.x << ", " << point.z;
  }
}

TEST(Sampling, PressureFieldIsHydrostaticInsideTheWaterAndEmptyOutside) {
  const Scene scene = tank();
  const GridValues pressure = pressure_field(scene, still_water(scene, 0.4), {0.0, 0.4, 0.0}, 0.2);
  EXPECT_EQ(pressure.columns, 81U);
  EXPECT_NEAR(pressure.at(40, 10), 9810.0 * 0.05, 1.0);  // z = 0.05
  EXPECT_TRUE(std::isnan(pressure.at(40, 30)));          // z = 0.15
  EXPECT_NEAR(largest(pressure), 9810.0 * 0.095, 60.0) << "half a spacing above the floor, one-sided";
}

TEST(Sampling, HydrostaticErrorAndSpeedOfAKnownState) {
  const Scene scene = tank();
  Snapshot state = still_water(scene, 0.4);
  EXPECT_NEAR(hydrostatic_error(scene, state, kLevel), 0.0, 1e-6);
  for (float& pressure : state.pressure) pressure += 98.1F;
  EXPECT_NEAR(hydrostatic_error(scene, state, kLevel), 0.1, 1e-5);
  EXPECT_NEAR(speed_rms(state), 0.05, 1e-7);
}

class Validation : public ::testing::Test {
 protected:
  [[nodiscard]] Validator validator(const std::function<bool()>& stop = [] { return false; }) {
    return {{folder_.path(), 2, false, true}, progress_, stop};
  }
  static const ValidationCase& named(const std::string& name) {
    const auto& cases = validation_cases();
    return *std::find_if(cases.begin(), cases.end(), [&](const auto& known) { return known.name == name; });
  }

  TemporaryFolder folder_;
  std::ostringstream progress_;
};

TEST_F(Validation, OfTheTallColumnHoldsItsLimitsAndLeavesItsFigures) {
  Validator runs = validator();
  const CaseReport report = carry_out(named("martin_moyce_n2"), runs);
  EXPECT_TRUE(report.holds()) << report.failure;
  EXPECT_EQ(report.limits(), 4U) << "front, height, penetrations, lost particles";
  EXPECT_EQ(report.run.particles, 1152U);
  EXPECT_GT(report.run.steps, 1000U);
  EXPECT_GT(report.run.peak_memory_bytes, 0U);
  for (const ReportFigure& figure : report.figures) {
    EXPECT_GT(std::filesystem::file_size(figure.path), 1000U) << figure.path;
  }
}

TEST_F(Validation, RunKeepsTheStatesAskedForAndItsTables) {
  Validator runs = validator();
  runs.begin_case("mine");
  const ValidationRun run = runs.run(
      {.scene = "martin_moyce_n1", .label = "short", .overrides = {"end_time=0.02"}, .states = {0.01, 0.02}});
  ASSERT_THAT(run.states, SizeIs(2));
  EXPECT_EQ(run.state(0.01).time, 0.01);
  EXPECT_THROW((void)run.state(0.015), std::logic_error);
  EXPECT_EQ(run.table("front_front").rows(), 9U) << "every 2.5 ms from 0 to 20 ms";
  EXPECT_EQ(run.files.folder, folder_ / "runs" / "mine_short");
  EXPECT_THROW((void)run.table("nothing"), InputError);
}

TEST_F(Validation, ThatIsStoppedEndsAtOnce) {
  Validator runs = validator([] { return true; });
  EXPECT_THROW((void)carry_out(named("martin_moyce_n1"), runs), ValidationInterrupted);
}

TEST_F(Validation, OfACaseThatBlowsUpFailsWithTheReason) {
  Validator runs = validator();
  const ValidationCase wild{"wild", "Too large a step", true, [](Validator& maker, CaseReport&) {
                              (void)maker.run({.scene = "still_water",
                                               .overrides = {"end_time=0.5", "scheme.time_step=0.05",
                                                             "scheme.clamp_pressure=false"}});
                            }};
  const CaseReport report = carry_out(wild, runs);
  EXPECT_THAT(report.failure, HasSubstr("blew up"));
  EXPECT_FALSE(report.holds());
}

TEST_F(Validation, CommandRefusesAnUnknownCaseAndNamesTheKnownOnes) {
  ValidateOptions options;
  options.cases = {"nonsense"};
  options.out = folder_ / "report";
  std::ostringstream out;
  EXPECT_THAT(error_of<InputError>([&] { (void)validate_command(options, out, progress_); }),
              AllOf(HasSubstr("nonsense"), HasSubstr("still_water"), HasSubstr("lobovsky")));
  EXPECT_FALSE(std::filesystem::exists(options.out));
}

TEST_F(Validation, CommandWritesAReportAndComparesWithAnEarlierOne) {
  ValidateOptions options;
  options.cases = {"martin_moyce_n1"};
  options.out = folder_ / "first";
  options.quiet = true;
  std::ostringstream out;
  EXPECT_EQ(validate_command(options, out, progress_), kSuccess);
  EXPECT_EQ(out.str(), "");
  const Report report = read_report_json(options.out / "report.json");
  ASSERT_THAT(report.cases, SizeIs(1));
  EXPECT_EQ(report.cases[0].name, "martin_moyce_n1");
  EXPECT_EQ(report.header.mode, "quick");
  EXPECT_THAT(text_of(options.out / "report.html"), HasSubstr("data:image/png;base64,"));

  options.against = options.out;
  options.out = folder_ / "second";
  EXPECT_EQ(validate_command(options, out, progress_), kSuccess);
  EXPECT_THAT(report_changes(read_report_json(options.out / "report.json"), report),
              ::testing::Contains(::testing::Truly([](const MetricChange& change) {
                return change.metric == "front" && change.before == change.now;
              })))
      << "the same bits again";
}

TEST_F(Validation, CommandListsItsCases) {
  ValidateOptions options;
  options.list = true;
  std::ostringstream out;
  EXPECT_EQ(validate_command(options, out, progress_), kSuccess);
  for (const ValidationCase& known : validation_cases()) EXPECT_THAT(out.str(), HasSubstr(known.name));
}

}  // namespace
}  // namespace eisph
