#include "io/scene_file.hpp"

#include "core/fluid_fit.hpp"
#include "core/lattice.hpp"
#include "io/scene_text.hpp"

#include <algorithm>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The scene after a way through its resolved text.
Scene round_trip(const Scene& scene) {
  SceneLoader loader;
  Scene again = loader.load(resolved_scene_toml(scene));
  again.source_file = scene.source_file;
  return again;
}

std::filesystem::path scene_folder() { return std::filesystem::path(EISPH_SOURCE_DIR) / "scenes"; }

TEST(SceneFile, ReadsEverySection) {
  SceneLoader loader;
  const Scene scene = loader.load(kSceneText);
  EXPECT_EQ(scene.name, "test");
  EXPECT_EQ(scene.source_file, loader.file().string());
  EXPECT_EQ(scene.domain_max, Vec3d(4.0, 1.0, 2.0));
  EXPECT_EQ(scene.faces[kZMax].kind, FaceKind::Open);
  EXPECT_EQ(scene.faces[kXMin].kind, FaceKind::Wall);
  ASSERT_EQ(scene.obstacles.size(), 2U);
  EXPECT_EQ(scene.obstacles[0].name, "pillar");
  EXPECT_EQ(scene.obstacles[1].name, "dam");
  ASSERT_EQ(scene.gates.size(), 1U);
  EXPECT_DOUBLE_EQ(scene.gates[0].speed, 4.0) << "stroke over duration";
  EXPECT_EQ(scene.probes.at(0).position, Vec3d(0.5, 0.5, 0.1));
  ASSERT_EQ(scene.images.size(), 1U);
  EXPECT_EQ(scene.images[0].camera.value().eye, Vec3d(2.0, -5.0, 2.0));
  EXPECT_EQ(count_fluid_particles(scene), 500U);
}

TEST(SceneFile, ReadsFacesByWordOrSlipFactor) {
  SceneLoader loader;
  const std::string faces =
      "x_min = \"no_slip\"\nx_max = 0.25\ny_min = \"symmetry\"\ny_max = 1\nz_max = \"open\"";
  const Scene scene = loader.load(edited(kSceneText, "z_max = \"open\"", faces));
  EXPECT_EQ(scene.faces[kXMin], (Face{FaceKind::Wall, 0.0}));
  EXPECT_EQ(scene.faces[kXMax], (Face{FaceKind::Wall, 0.25}));
  EXPECT_EQ(scene.faces[kYMin], (Face{FaceKind::Symmetry, 1.0}));
  EXPECT_EQ(scene.faces[kYMax], (Face{FaceKind::Wall, 1.0}));
  EXPECT_EQ(round_trip(scene), scene);
}

TEST(SceneFile, WaterMayCrossAPlaneOfSymmetry) {
  SceneLoader loader;
  const std::string ball =
      "[[fluid.region]]\nshape = \"sphere\"\ncentre = [3.0, 0.0, 0.5]\nradius = 0.3\n[domain]";
  const std::string text = edited(kSceneText, "[domain]", ball);
  EXPECT_THAT(loader.error(text), HasSubstr("out of the domain in y"));
  EXPECT_NO_THROW(
      (void)loader.load(edited(text, "z_max = \"open\"", "z_max = \"open\"\ny_min = \"symmetry\"")));
}

TEST(SceneFile, TakesTwoComponentsInTwoDimensions) {
  SceneLoader loader;
  const Scene scene =
      loader.load(edited(kSceneText2d, "[[image]]", "[[gauge]]\nname = \"a\"\nposition = [0.5]\n[[image]]"));
  EXPECT_EQ(scene.domain_max, Vec3d(4.0, 0.0, 2.0));
  EXPECT_EQ(scene.gauges.at(0).x, 0.5);
  EXPECT_EQ(scene.gravity, Vec3d(0.0, 0.0, -9.81));
  EXPECT_EQ(count_fluid_particles(scene), 50U);
  EXPECT_EQ(round_trip(scene), scene);
}

TEST(SceneFile, DefaultsFollowOtherKeys) {
  SceneLoader loader;
  const Scene scene = loader.load(kSceneText);
  EXPECT_EQ(scene.title, "test");
  EXPECT_DOUBLE_EQ(scene.reference_depth, 0.5);
  EXPECT_DOUBLE_EQ(scene.gauges.at(0).size, 0.15);
  EXPECT_DOUBLE_EQ(scene.gauges.at(0).height, 2.0);
  EXPECT_DOUBLE_EQ(scene.gauges.at(0).interval, 0.01);
  EXPECT_DOUBLE_EQ(scene.output.depth_cell_size, 0.15);
  EXPECT_THAT(scene.output.particles.times, ElementsAre(0.25, 0.5));
  EXPECT_THAT(scene.output.depth.times, ElementsAre(0.25, 0.5));
  EXPECT_THAT(scene.images.at(0).schedule.times, ElementsAre(0.25, 0.5));
  EXPECT_EQ(scene.scheme.source_factor, 3.0);
  EXPECT_FALSE(scene.scheme.volume_correction.has_value());
}

/// Every kind of probe with every key.
const std::string kProbes = R"([[pressure_sensor]]
name = "p1"
position = [0.0, 0.5, 0.16]
shape = "square"
size = 0.09
response_time = 0.002
interval = 0.001
[[pressure_sensor]]
name = "on_pillar"
position = [2.0, 0.45, 0.2]
normal = [-3.0, 0.0, 0.0]
[[front]]
name = "back"
direction = "-y"
x_range = [1.0, 2.0]
z_range = [0.0, 0.5]
[[front]]
name = "strip"
direction = "+x"
y_range = [0.045, 0.055]
[[line]]
name = "profile"
start = [0.5, 0.5, 0.0]
end = [0.5, 0.5, 1.0]
points = 11
[[force]]
name = "on_gate"
obstacle = "gate"
moment_point = [1.0, 0.5, 0.0]
[[force]]
name = "on_dam"
obstacle = "dam"
[[discharge]]
name = "breach"
axis = "x"
position = 1.1
y_range = [0.3, 1.0]
z_range = [0.0, 1.0]
)";

TEST(SceneFile, ReadsEveryKindOfProbe) {
  SceneLoader loader;
  const Scene scene =
      loader.load(kSceneText + kProbes, {"output.depth_rule=surface", "output.ignore_spray=false"});
  EXPECT_FALSE(scene.output.ignore_spray);
  ASSERT_EQ(scene.pressure_sensors.size(), 2U);
  EXPECT_EQ(scene.pressure_sensors[0].shape, SensorShape::Square);
  EXPECT_EQ(scene.pressure_sensors[0].normal, Vec3d(1.0, 0.0, 0.0)) << "of the nearest face";
  EXPECT_EQ(scene.pressure_sensors[0].interval, 0.001);
  EXPECT_EQ(scene.pressure_sensors[0].response_time, 0.002);
  EXPECT_EQ(scene.pressure_sensors[1].normal, Vec3d(-3.0, 0.0, 0.0));
  EXPECT_EQ(scene.pressure_sensors[1].size, 0.0);
  EXPECT_EQ(scene.pressure_sensors[1].response_time, 0.0);
  EXPECT_EQ(scene.pressure_sensors[1].interval, 0.01);
  EXPECT_EQ(scene.fronts.at(0).axis, 1);
  EXPECT_FALSE(scene.fronts.at(0).upwards);
  EXPECT_TRUE(scene.fronts.at(0).band.contains(Vec3d(1.5, 9.0, 0.25)));
  EXPECT_FALSE(scene.fronts.at(0).band.contains(Vec3d(2.5, 0.5, 0.25)));
  EXPECT_EQ(scene.lines.at(0).points, 11);
  EXPECT_EQ(scene.forces.at(0).moment_point, Vec3d(1.0, 0.5, 0.0));
  EXPECT_NEAR((*scene.forces.at(1).moment_point - Vec3d(1.1, 0.15, 0.0)).norm(), 0.0, 1e-12) << "of the base";
  EXPECT_EQ(scene.discharges.at(0).position, 1.1);
  EXPECT_EQ(scene.output.depth_rule, DepthRule::Surface);
  EXPECT_THAT(probe_intervals(scene), testing::SizeIs(10));
  EXPECT_EQ(round_trip(scene), scene);
  EXPECT_EQ(resolved_scene_toml(round_trip(scene)), resolved_scene_toml(scene));
}

TEST(SceneFile, ReadsProbesInTwoDimensions) {
  SceneLoader loader;
  const Scene scene = loader.load(kSceneText2d + R"([[obstacle]]
name = "block"
min = [2.0, 0.0]
max = [2.5, 0.5]
[[pressure_sensor]]
name = "p"
position = [4.0, 0.5]
[[line]]
name = "l"
start = [0.5, 0.0]
end = [0.5, 1.0]
[[force]]
name = "f"
obstacle = "block"
[[front]]
name = "x"
direction = "-x"
[[discharge]]
name = "q"
axis = "z"
position = 0.25
x_range = [0.0, 1.0]
)");
  EXPECT_EQ(scene.pressure_sensors.at(0).normal, Vec3d(-1.0, 0.0, 0.0));
  EXPECT_EQ(scene.forces.at(0).moment_point, Vec3d(2.25, 0.0, 0.0));
  EXPECT_EQ(round_trip(scene), scene);
}

TEST(SceneFile, NameDefaultsToThatOfTheFile) {
  SceneLoader loader;
  EXPECT_EQ(loader.load(edited(kSceneText, "name = \"test\"", "")).name, "case");
}

TEST(SceneFile, ReferenceDepthIsBetweenTheHighestAndTheLowestWater) {
  SceneLoader loader;
  const std::string more = "[[fluid.region]]\nmin = [3.0, 0.0, 1.0]\nmax = [3.5, 1.0, 1.25]\n[domain]";
  EXPECT_DOUBLE_EQ(loader.load(edited(kSceneText, "[domain]", more)).reference_depth, 1.25);
  const std::string given = "density = 1000.0\nreference_depth = 0.7";
  EXPECT_DOUBLE_EQ(loader.load(edited(kSceneText, "density = 1000.0", given)).reference_depth, 0.7);
}

TEST(SceneFile, ThesisSteppingBringsItsOwnParameters) {
  SceneLoader loader;
  const Scene scene = loader.load(kSceneText + "[scheme]\nstepping = \"thesis\"\n");
  EXPECT_EQ(scene.scheme.phi, 0.06);
  EXPECT_EQ(scene.scheme.source_factor, 1.0);
  EXPECT_EQ(scene.scheme.volume_correction, 0.1);
  EXPECT_EQ(round_trip(scene), scene);
  const Scene chosen = loader.load(
      kSceneText +
      "[scheme]\nstepping = \"thesis\"\nphi = 0.1\nsource_factor = 2.0\nvolume_correction = 0.0\n");
  EXPECT_EQ(chosen.scheme.phi, 0.1);
  EXPECT_EQ(chosen.scheme.source_factor, 2.0);
  EXPECT_EQ(chosen.scheme.volume_correction, 0.0);
}

TEST(SceneFile, OptionsThatTradeSpeedForCareAreTakenOnlyIfGiven) {
  SceneLoader loader;
  const Scene scene = loader.load(kSceneText);
  EXPECT_EQ(scene.scheme.reference_speed_weight, 1.0);
  EXPECT_FALSE(scene.scheme.viscous_source);
  const Scene chosen =
      loader.load(kSceneText + "[scheme]\nreference_speed_weight = 0.67\nviscous_source = true\n");
  EXPECT_EQ(chosen.scheme.reference_speed_weight, 0.67);
  EXPECT_TRUE(chosen.scheme.viscous_source);
  EXPECT_EQ(round_trip(chosen), chosen);
}

TEST(SceneFile, AnEmptyScheduleMeansNever) {
  SceneLoader loader;
  const Scene scene = loader.load(edited(kSceneText, "times = [0.25, 0.5]",
                                         "interval = 0.1\nparticles_times = []\ndepth_interval = 0.5"));
  EXPECT_TRUE(scene.output.particles.empty());
  EXPECT_THAT(scene.output.depth.times, IsEmpty());
  EXPECT_EQ(scene.output.depth.interval, 0.5);
  EXPECT_EQ(scene.images.at(0).schedule.interval, 0.1);
  EXPECT_EQ(round_trip(scene), scene);
}

TEST(SceneFile, WithoutTimesThereIsOneFrameAtTheEnd) {
  SceneLoader loader;
  const Scene scene = loader.load(edited(kSceneText, "times = [0.25, 0.5]", ""));
  EXPECT_THAT(scene.images.at(0).schedule.times, ElementsAre(1.0));
}

TEST(SceneFile, WithoutImagesThereIsAViewAndInThreeDimensionsADepthMap) {
  SceneLoader loader;
  const std::size_t images = kSceneText.find("[[image]]");
  const Scene scene = loader.load(kSceneText.substr(0, images), {"image.depth.width=640"});
  ASSERT_EQ(scene.images.size(), 2U);
  EXPECT_EQ(scene.images[0].kind, ImageKind::Particles);
  EXPECT_EQ(scene.images[0].colour_map, "viridis");
  EXPECT_EQ(scene.images[1].kind, ImageKind::DepthMap);
  EXPECT_EQ(scene.images[1].field, "depth");
  EXPECT_EQ(scene.images[1].colour_map, "depth_blue");
  EXPECT_EQ(scene.images[1].width, 640);
  EXPECT_THAT(scene.images[1].schedule.times, ElementsAre(0.25, 0.5));
  EXPECT_EQ(loader.load(edited(kSceneText2d, "[[image]]\nname = \"view\"\n", "")).images.size(), 1U);
}

TEST(SceneFile, ASurfaceIsPlainWaterUnlessAFieldIsGiven) {
  SceneLoader loader;
  const std::string plain = edited(kSceneText, "name = \"view\"", "name = \"view\"\nstyle = \"surface\"");
  const Scene scene = loader.load(plain);
  EXPECT_EQ(scene.images.at(0).style, WaterStyle::Surface);
  EXPECT_EQ(scene.images.at(0).field, "water");
  EXPECT_EQ(round_trip(scene), scene);
  EXPECT_EQ(loader.load(plain, {"image.view.field=speed"}).images.at(0).field, "speed");
  EXPECT_EQ(loader.load(kSceneText).images.at(0).field, "speed");
}

TEST(SceneFile, PanelsNameImagesAndGauges) {
  SceneLoader loader;
  const Scene scene = loader.load(kSceneText +
                                  "[[image]]\nname = \"all\"\nkind = \"panels\"\npanels = [\"view\"]\n"
                                  "gauges = [\"level\"]\ncaption = \"A view\"\n");
  EXPECT_THAT(scene.images.at(1).panels, ElementsAre("view"));
  EXPECT_THAT(scene.images.at(1).gauges, ElementsAre("level"));
  EXPECT_EQ(scene.images.at(1).caption, "A view");
  EXPECT_EQ(round_trip(scene), scene);
}

TEST(SceneFile, ResolvedTextHoldsEveryFeature) {
  SceneLoader loader;
  const std::string more = R"([[fluid.region]]
shape = "cylinder"
centre = [3.0, 0.5, 0.0]
radius = 0.3
height = 0.4
velocity = [0.1, -0.2, 0.3]
[[fluid.region]]
shape = "sphere"
centre = [0.5, 0.5, 0.5]
radius = 0.2
cut = true
[[obstacle]]
name = "turned"
min = [3.5, 0.4, 0.0]
max = [3.7, 0.6, 0.2]
rotation_z = 33.3
[[image]]
name = "map"
kind = "depth_map"
colour_map = "grey_depth"
mirror = true
dry_depth = 0.001
interval = 0.1
[[image]]
name = "side"
field = "pressure"
range = [0.0, 1234.5]
background = "dark"
times = [0.1]
[image.camera]
projection = "orthographic"
eye = [2.0, -3.0, 1.0]
target = [2.0, 0.5, 1.0]
orthographic_height = 2.2
[scheme]
time_step = 1.1e-4
volume_correction = 0.3
initial_pressure = "hydrostatic"
[boundary]
repulsion_cap = 3.3
)";
  const std::string title = "name = \"test\"\ntitle = 'a \"quoted\" \\ title, ω'";
  const Scene scene = loader.load(edited(kSceneText, "name = \"test\"", title) + more);
  EXPECT_DOUBLE_EQ(scene.obstacles.at(1).shape.rotation_z, 33.3 * std::numbers::pi / 180.0);
  EXPECT_EQ(scene.scheme.time_step_mode, TimeStepMode::Fixed);
  EXPECT_EQ(round_trip(scene), scene);
  EXPECT_EQ(resolved_scene_toml(round_trip(scene)), resolved_scene_toml(scene));
}

TEST(SceneFile, KeyTableNamesEveryKeyOfTheResolvedScene) {
  SceneLoader loader;
  const std::string schema = scene_schema_text();
  std::istringstream lines(resolved_scene_toml(loader.load(kSceneText + kProbes)));
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    const std::string wanted =
        line.front() == '[' ? "\n" + line + " " : "\n  " + line.substr(0, line.find(' ')) + " ";
    EXPECT_THAT(schema, HasSubstr(wanted));
  }
  EXPECT_THAT(schema, HasSubstr("a number above 0, in m; required"));
  EXPECT_THAT(schema, HasSubstr("a number from 1 to 2; default quintic_spline 1.42 (2D), 1.32 (3D)"));
  EXPECT_THAT(schema, HasSubstr("default highest minus lowest water"));
}

TEST(SceneFile, SchemaIsAtMost110ColumnsWide) {
  std::istringstream lines(scene_schema_text());
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110U) << line;
}

TEST(SceneFile, AvailableMemoryIsPlausible) { EXPECT_GT(available_memory_bytes(), 10'000'000U); }

struct ShippedScene {
  const char* name;
  std::uint64_t fluid_particles;
};
class ShippedSceneTest : public testing::TestWithParam<ShippedScene> {};

TEST_P(ShippedSceneTest, LoadsWithItsParticlesAndComesBackFromItsResolvedText) {
  const Scene scene = load_scene(scene_folder() / (std::string(GetParam().name) + ".toml"));
  EXPECT_EQ(scene.name, GetParam().name);
  EXPECT_EQ(count_fluid_particles(scene), GetParam().fluid_particles);
  EXPECT_TRUE(fit_fluid(scene).aligned);
  EXPECT_EQ(round_trip(scene), scene);
}

constexpr ShippedScene kShippedScenes[] = {
    {"aureli_test1", 144000},
    {"aureli_test2", 186660},
    {"aureli_test3", 144000},
    {"aureli_test4_full", 144000},
    {"aureli_test4_half", 576000},
    {"aureli_coarse", 31104},
    {"block_impact", 76800},
    {"shao_lo_3d", 16000},
    {"shao_lo_2d", 800},
    {"martin_moyce_n1", 576},
    {"martin_moyce_n2", 1152},
    {"ritter", 27000},
    {"ritter_long", 6000},
    {"stoker", 28800},
    {"buchner", 7200},
    {"janosi_d38", 29583},
    {"lobovsky_h300", 7200},
    {"sloshing", 12000},
    {"still_water", 3000},
    {"taylor_green", 10000},
    {"square_patch", 10000},
};
INSTANTIATE_TEST_SUITE_P(Scenes, ShippedSceneTest, testing::ValuesIn(kShippedScenes),
                         [](const auto& shipped) { return shipped.param.name; });

TEST(ShippedScenes, AreAllTested) {
  for (const auto& entry : std::filesystem::directory_iterator(scene_folder())) {
    if (entry.is_directory()) continue;
    const std::string name = entry.path().stem().string();
    EXPECT_TRUE(std::any_of(std::begin(kShippedScenes), std::end(kShippedScenes),
                            [&](const ShippedScene& scene) { return scene.name == name; }))
        << name;
  }
}

}  // namespace
}  // namespace eisph
