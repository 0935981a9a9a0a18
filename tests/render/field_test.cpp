#include "render/field.hpp"

#include "core/error.hpp"
#include "render/synthetic_scene.hpp"

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

ImageSettings of(const std::string& field) {
  ImageSettings settings;
  settings.name = "front";
  settings.field = field;
  return settings;
}

void expect_scale(const FieldScale& scale, const std::string& label, double lower, double upper) {
  EXPECT_EQ(scale.label, label);
  EXPECT_NEAR(scale.lower, lower, 1e-9);
  EXPECT_NEAR(scale.upper, upper, 1e-9);
}

TEST(FieldScale, FollowsFromTheReferenceDepthOfTheScene) {
  // H = 0.15 m: 2 sqrt(g H) = 2.43 m/s, rho g H = 1471.5 Pa.
  const Scene scene = synthetic::tank_scene(0.02);
  expect_scale(field_scale(scene, of("speed")), "speed (m/s)", 0.0, 2.5);
  expect_scale(field_scale(scene, of("velocity_x")), "velocity in x (m/s)", -2.5, 2.5);
  expect_scale(field_scale(scene, of("velocity_z")), "velocity in z (m/s)", -2.5, 2.5);
  expect_scale(field_scale(scene, of("pressure")), "pressure (Pa)", 0.0, 1500.0);
  expect_scale(field_scale(scene, of("depth")), "water depth (m)", 0.0, 0.15);
}

TEST(FieldScale, LargePressuresAreShownInKilopascals) {
  Scene scene = synthetic::tank_scene(0.02);
  scene.reference_depth = 3.0;
  const FieldScale scale = field_scale(scene, of("pressure"));
  expect_scale(scale, "pressure (kPa)", 0.0, 30000.0);
  EXPECT_EQ(scale.display_unit, 1000.0);
}

TEST(FieldScale, ARangeOfTheSettingsIsKept) {
  ImageSettings settings = of("pressure");
  settings.range = {100.0, 700.0};
  expect_scale(field_scale(synthetic::tank_scene(0.02), settings), "pressure (Pa)", 100.0, 700.0);
}

TEST(FieldScale, ADepthMapShowsDepthWhateverTheFieldSays) {
  ImageSettings settings = of("speed");
  settings.kind = ImageKind::DepthMap;
  expect_scale(field_scale(synthetic::tank_scene(0.02), settings), "water depth (m)", 0.0, 0.15);
}

TEST(FieldScale, UnknownFieldsAndEmptyRangesAreRefused) {
  const Scene scene = synthetic::tank_scene(0.02);
  EXPECT_THAT([&] { return field_scale(scene, of("vorticity")); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("synthetic.toml"), HasSubstr("'front'"),
                                              HasSubstr("\"vorticity\""), HasSubstr("velocity_x"))));
  ImageSettings settings = of("speed");
  settings.range = {2.0, 2.0};
  EXPECT_THAT([&] { return field_scale(scene, settings); },
              ThrowsMessage<InputError>(HasSubstr("range = [2, 2]")));
}

TEST(FieldScale, AnEmptyColourMapNameChoosesByField) {
  ImageSettings settings = of("velocity_y");
  EXPECT_EQ(colour_map_name(settings), "viridis") << "the default of the settings is kept";
  settings.colour_map.clear();
  EXPECT_EQ(colour_map_name(settings), "blue_red");
  settings.field = "speed";
  EXPECT_EQ(colour_map_name(settings), "viridis");
  settings.kind = ImageKind::DepthMap;
  EXPECT_EQ(colour_map_name(settings), "depth_blue");
}

TEST(FieldValues, AreThoseOfTheListedParticles) {
  Snapshot snapshot;
  snapshot.position = {Vec3f(0.05F, 0.05F, 0.0F), Vec3f(0.15F, 0.05F, 0.0F), Vec3f(0.15F, 0.25F, 0.0F)};
  snapshot.velocity = {Vec3f(3.0F, 0.0F, 4.0F), Vec3f(1.0F, -2.0F, 2.0F), Vec3f(0.0F, 0.5F, 0.0F)};
  snapshot.pressure = {10.0F, 20.0F, 30.0F};
  DepthGrid depth;
  depth.cell_size = 0.1;
  depth.columns = 2;
  depth.rows = 2;
  depth.depth = {0.1F, 0.2F, 0.3F, 0.4F};
  const std::vector<std::uint32_t> chosen = {2, 0, 1};
  EXPECT_THAT(field_values("speed", snapshot, depth, chosen), ElementsAre(0.5F, 5.0F, 3.0F));
  EXPECT_THAT(field_values("velocity_x", snapshot, depth, chosen), ElementsAre(0.0F, 3.0F, 1.0F));
  EXPECT_THAT(field_values("velocity_y", snapshot, depth, chosen), ElementsAre(0.5F, 0.0F, -2.0F));
  EXPECT_THAT(field_values("velocity_z", snapshot, depth, chosen), ElementsAre(0.0F, 4.0F, 2.0F));
  EXPECT_THAT(field_values("pressure", snapshot, depth, chosen), ElementsAre(30.0F, 10.0F, 20.0F));
  // The last particle lies beyond the grid and takes the nearest cell.
  EXPECT_THAT(field_values("depth", snapshot, depth, chosen), ElementsAre(0.4F, 0.1F, 0.2F));
}

}  // namespace
}  // namespace eisph
