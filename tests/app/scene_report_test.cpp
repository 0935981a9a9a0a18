#include "app/scene_report.hpp"

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A tank of 10 x 10 x 10 water particles with an obstacle, and nothing doubtful about it.
Scene sound_scene() {
  Scene scene;
  scene.name = "tank";
  scene.source_file = "tank.toml";
  scene.dimension = 3;
  scene.end_time = 1.0;
  scene.particle_spacing = 0.01;
  scene.reference_depth = 0.1;
  scene.domain_max = {0.5, 0.1, 0.3};
  FluidRegion water;
  water.shape.max = {0.1, 0.1, 0.1};
  scene.fluid = {water};
  Obstacle obstacle;
  obstacle.name = "block";
  obstacle.shape.min = {0.3, 0.0, 0.0};
  obstacle.shape.max = {0.32, 0.1, 0.1};
  scene.obstacles = {obstacle};
  scene.scheme.phi = 0.17;
  scene.kernel = KernelKind::WendlandC2;
  scene.smoothing_ratio = 1.32;
  return scene;
}

SimulationPlan plan_of(const Scene& scene) {
  SimulationPlan plan;
  plan.fluid_particles = 1000;
  plan.object_particles = 200;
  plan.time_step = scene.scheme.phi * scene.particle_spacing / scene.reference_speed();
  plan.effective_sound_speed = 10.0 * scene.reference_speed();
  plan.estimated_bytes = 500000;
  plan.estimated_steps = 1200;
  return plan;
}

std::vector<std::string> warnings_of(const Scene& scene) { return scene_warnings(scene, plan_of(scene)); }

TEST(SceneWarnings, TellOfAKernelWithWhichParticlesPair) {
  Scene scene = sound_scene();
  scene.kernel = KernelKind::CubicSpline;
  EXPECT_THAT(warnings_of(scene), ElementsAre(AllOf(HasSubstr("particles.smoothing_ratio = 1.32"),
                                                    HasSubstr("cubic spline particles pair above 1.1"))));
  scene.smoothing_ratio = 1.1;
  EXPECT_THAT(warnings_of(scene), IsEmpty());
  scene.smoothing_ratio = 1.2;
  EXPECT_THAT(warnings_of(scene), SizeIs(1));
  for (const KernelKind kernel : {KernelKind::WendlandC2, KernelKind::QuinticSpline}) {
    scene.kernel = kernel;
    EXPECT_THAT(warnings_of(scene), IsEmpty());
    scene.smoothing_ratio = 1.7;
    EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("particles pair above 1.")));
    scene.smoothing_ratio = 1.32;
  }
}

TEST(SceneWarnings, OfASoundSceneAreNone) { EXPECT_THAT(warnings_of(sound_scene()), IsEmpty()); }

TEST(SceneWarnings, OfIntervalsOfHardlyMoreThanAStep) {
  Scene scene = sound_scene();
  const double time_step = plan_of(scene).time_step;
  scene.output.ledger_interval = 8.3 * time_step;  // nine steps instead
  EXPECT_THAT(warnings_of(scene), IsEmpty());
  scene.output.ledger_interval = time_step;
  EXPECT_THAT(warnings_of(scene), IsEmpty()) << "as many steps as without";
  scene.output.ledger_interval = 1.25 * time_step;
  scene.end_time = 100.0 * scene.output.ledger_interval;
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("there are about 200 steps")));
}

TEST(SceneWarnings, NameSolidsThinnerThanOneAndAHalfSpacings) {
  Scene scene = sound_scene();
  scene.obstacles[0].shape.max.x() = 0.314;
  Gate gate;
  gate.name = "slide";
  gate.shape.kind = ShapeKind::Cylinder;
  gate.shape.radius = 0.008;
  gate.shape.height = 0.1;
  scene.gates = {gate};
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("obstacle \"block\" is 0.014 m thin")));
  scene.gates[0].shape.radius = 0.005;
  EXPECT_THAT(warnings_of(scene),
              ElementsAre(HasSubstr("\"block\""), HasSubstr("gate \"slide\" is 0.01 m thin")));
}

TEST(SceneWarnings, TellOfATimeStepTooLargeForObjects) {
  Scene scene = sound_scene();
  scene.scheme.phi = 0.2;
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("above 0.17 in a scene with objects")));
  SimulationPlan plan = plan_of(scene);
  plan.object_particles = 0;
  EXPECT_THAT(scene_warnings(scene, plan), IsEmpty());
}

TEST(SceneWarnings, TellOfATimeStepTooLargeForWalls) {
  Scene scene = sound_scene();
  scene.scheme.phi = 0.3;
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("is 0.3 at t = 0, above 0.25")));
}

TEST(SceneWarnings, TellOfAWeightOfTheReferenceSpeedThatMakesTheFirstStepsTooLong) {
  Scene scene = sound_scene();
  SimulationPlan plan = plan_of(scene);
  plan.time_step *= 1.5;
  EXPECT_THAT(scene_warnings(scene, plan), IsEmpty());
  plan.time_step *= 1.1;
  EXPECT_THAT(scene_warnings(scene, plan), ElementsAre(HasSubstr("reference_speed_weight is 0.28")));
}

TEST(SceneWarnings, TellOfStepsAtWhichHardCasesBlewUp) {
  Scene scene = sound_scene();
  scene.obstacles.clear();
  scene.gates.clear();
  scene.scheme.stepping = Stepping::Thesis;
  scene.scheme.phi = 0.06;
  EXPECT_THAT(warnings_of(scene), IsEmpty());
  scene.scheme.phi = 0.1;
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("is 0.1 at t = 0, above 0.06")));
  scene.scheme.name = "delta_sph";
  scene.scheme.sound_speed = 10.0 * scene.expected_speed();
  scene.scheme.stepping = Stepping::RungeKutta;
  scene.scheme.courant = 1.25;
  EXPECT_THAT(warnings_of(scene), IsEmpty());
  scene.scheme.stepping = Stepping::Symplectic;
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("at t = 0, above 0.3: the run may blow up")));
}

TEST(SceneWarnings, TellOfBlowsThatAnImplicitPressureDoesNotBear) {
  Scene scene = sound_scene();
  scene.obstacles.clear();
  scene.fluid.at(0).velocity = Vec3d(-2.0 * scene.reference_speed(), 0.0, 0.0);
  scene.scheme.name = "isph";
  const auto warnings_at = [&scene](double phi) {
    scene.scheme.phi = phi;
    SimulationPlan plan = plan_of(scene);
    plan.object_particles = 0;
    plan.time_step = phi * scene.particle_spacing / scene.expected_speed();
    return scene_warnings(scene, plan);
  };
  EXPECT_THAT(warnings_at(0.17), IsEmpty());
  EXPECT_THAT(warnings_at(0.2), ElementsAre(HasSubstr("blow up where it strikes")));
  scene.scheme.name = "eisph";
  EXPECT_THAT(warnings_at(0.2), IsEmpty());
  scene.scheme.name = "isph";
  scene.fluid.at(0).velocity.setZero();
  EXPECT_THAT(warnings_at(0.2), IsEmpty());
}

TEST(SceneWarnings, TellOfNegativePressureAtAFreeSurface) {
  Scene scene = sound_scene();
  scene.scheme.clamp_pressure = false;
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("clamp_pressure")));
  scene.scheme.free_surface_threshold = 0.0;
  EXPECT_THAT(warnings_of(scene), IsEmpty()) << "a closed domain";
}

TEST(SceneWarnings, TellWhenTheViscousLimitGoverns) {
  Scene scene = sound_scene();
  scene.kinematic_viscosity = 1.0;
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("viscous limit governs")));
}

TEST(SceneWarnings, NameWaterThinnerThanALayer) {
  Scene scene = sound_scene();
  scene.fluid[0].shape.max.z() = 0.105;
  EXPECT_THAT(warnings_of(scene), IsEmpty()) << "the lattice is fitted to the depth";
  FluidRegion cut;
  cut.cut = true;
  cut.shape.min = {0.05, 0.0, 0.0};
  cut.shape.max = {0.1, 0.1, 0.102};
  scene.fluid.push_back(cut);
  EXPECT_THAT(
      warnings_of(scene),
      ElementsAre(HasSubstr("fluid.region.0 from (0.05, 0, 0.102) to (0.1, 0.1, 0.105) m is 0.003 m thin "
                            "in z, less than a particle spacing (0.01 m): it gets 0 of its 1.5e-05 m^3")));
}

TEST(FitReport, StatesGapsAndCompression) {
  EXPECT_THAT(fit_report({}), HasSubstr("water touches neither walls nor solids"));
  InitialFit fit;
  fit.gaps = {{"x_min", 0.5}, {"\"block\"", 0.4804}};
  fit.compression = 0.0123;
  EXPECT_THAT(fit_report(fit), HasSubstr("x_min 0.500, \"block\" 0.480 spacings"));
  EXPECT_THAT(fit_report(fit), HasSubstr("1.2 % at t = 0"));
}

TEST(SceneReport, StatesParticlesMemoryTimeStepAndSound) {
  const Scene scene = sound_scene();
  const std::string report = scene_report(scene, plan_of(scene), 8'000'000'000);
  EXPECT_THAT(report, HasSubstr("1000 fluid, 200 object"));
  EXPECT_THAT(report, HasSubstr("0.5 MB of solver state, 8e+03 MB available"));
  EXPECT_THAT(report, HasSubstr("about 1200 steps"));
  EXPECT_THAT(report, HasSubstr("Mach number 0.1"));
}

TEST(SceneReport, CountsTheOutputs) {
  Scene scene = sound_scene();
  scene.output.particles.interval = 0.25;
  scene.output.depth.times = {0.5, 2.0};
  ImageSettings image;
  image.name = "view";
  image.schedule.times = {0.2, 0.4, 1.0};
  scene.images = {image};
  Gauge gauge;
  gauge.name = "upstream";
  gauge.interval = 0.1;
  scene.gauges = {gauge};
  const std::string report = scene_report(scene, plan_of(scene), 1);
  EXPECT_THAT(report, HasSubstr("3 of \"view\": particles, speed, 1280 x 720"));
  EXPECT_THAT(report, HasSubstr("5 .vtp files"));
  EXPECT_THAT(report, HasSubstr("1 .vti files"));
  EXPECT_THAT(report, HasSubstr("upstream at (0, 0) m, 11 rows"));
}

}  // namespace
}  // namespace eisph
