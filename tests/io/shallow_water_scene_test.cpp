#include "io/scene_text.hpp"
#include "io/vtk_output.hpp"

#include <memory>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kShallow = "scheme.name=shallow_water";

TEST(ShallowWaterScene, TakesDefaultsAndKeys) {
  SceneLoader loader;
  const Scene plain = loader.load(kSceneText, {kShallow});
  EXPECT_EQ(plain.scheme.name, "shallow_water");
  EXPECT_DOUBLE_EQ(plain.shallow_water.cell_size, 0.1) << "the particle spacing fits 4 m and 1 m";
  EXPECT_EQ(plain.shallow_water.manning, 0.007);
  EXPECT_EQ(plain.shallow_water.courant, 0.9);
  EXPECT_EQ(plain.shallow_water.limiter, SlopeLimiter::MonotonisedCentral);
  const Scene set = loader.load(kSceneText, {kShallow, "shallow_water.cell_size=0.05",
                                             "shallow_water.manning=0.0", "shallow_water.courant=0.5",
                                             "shallow_water.dry_depth=1e-5", "shallow_water.limiter=minmod"});
  EXPECT_EQ(set.shallow_water.cell_size, 0.05);
  EXPECT_EQ(set.shallow_water.manning, 0.0);
  EXPECT_EQ(set.shallow_water.courant, 0.5);
  EXPECT_EQ(set.shallow_water.dry_depth, 1e-5);
  EXPECT_EQ(set.shallow_water.limiter, SlopeLimiter::Minmod);
  EXPECT_EQ(loader.load(resolved_scene_toml(set)).shallow_water, set.shallow_water);
}

TEST(ShallowWaterScene, FindsACellThatFitsADomainThatTheSpacingDoesNot) {
  SceneLoader loader;
  const std::string text = edited(kSceneText, "spacing = 0.1", "spacing = 0.09");
  const double cell = loader.load(text, {kShallow}).shallow_water.cell_size;
  EXPECT_NEAR(cell, 1.0 / 12.0, 1e-12) << "the largest that divides 4 m and 1 m";
  EXPECT_NEAR(loader.load(edited(kSceneText2d, "spacing = 0.1", "spacing = 0.09"), {kShallow})
                  .shallow_water.cell_size,
              4.0 / 45.0, 1e-12);
}

TEST(ShallowWaterScene, NamesWhatItCannotUse) {
  SceneLoader loader;
  EXPECT_THAT(loader.error(kSceneText, {kShallow, "shallow_water.cell_size=0.15"}),
              AllOf(HasSubstr("shallow_water.cell_size = 0.15"), HasSubstr("4 m long in x"),
                    HasSubstr("0.148148 or 0.153846")));
  EXPECT_THAT(loader.error(kSceneText, {kShallow, "shallow_water.cell_size=0.16"}),
              HasSubstr("1 m long in y"));
  EXPECT_THAT(loader.error(kSceneText, {kShallow, "gravity=[0.1, 0.0, -9.81]"}),
              AllOf(HasSubstr("gravity"), HasSubstr("straight down")));
  EXPECT_THAT(loader.error(kSceneText, {kShallow, "domain.faces.z_min=\"open\""}),
              HasSubstr("needs a floor"));
  EXPECT_THAT(loader.error(kSceneText, {kShallow, "shallow_water.courant=1.5"}),
              HasSubstr("expected a number above 0 and at most 1"));
  EXPECT_THAT(loader.error(kSceneText, {"scheme.name=swe"}), HasSubstr("\"isph\", \"shallow_water\""));
}

TEST(ShallowWaterScene, HoldsTheCellsAgainstTheMemory) {
  SceneLoader loader;
  put_text(loader.file(), kSceneText);
  EXPECT_THAT(error_of<InputError>([&] {
                (void)load_scene(loader.file(), {kShallow, "shallow_water.cell_size=0.0001"}, 1'000'000'000);
              }),
              AllOf(HasSubstr("shallow_water.cell_size"), HasSubstr("4e+08 cells need 100 GB")));
}

TEST(WriteParticles, KeepsTheColumnsOfADepthAveragedModel) {
  const TemporaryFolder folder;
  Snapshot snapshot;
  snapshot.objects = std::make_shared<const ObjectParticles>();
  auto columns = std::make_shared<ColumnField>();
  columns->origin_x = 0.1;
  columns->origin_y = -0.3;
  columns->cell_size = 1.0 / 3.0;
  columns->columns = 3;
  columns->rows = 2;
  columns->bed = {0.0F, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F};
  columns->depth = {1.0F, 1.1F, 1.2F, 1.3F, 1.4F, 1.5F};
  columns->velocity_x = {2.0F, 2.1F, 2.2F, 2.3F, 2.4F, 2.5F};
  columns->velocity_y = {-2.0F, -2.1F, -2.2F, -2.3F, -2.4F, -2.5F};
  snapshot.columns = columns;
  write_particles(folder / "with.vtp", snapshot);
  const Snapshot read = read_particles(folder / "with.vtp");
  ASSERT_NE(read.columns, nullptr);
  EXPECT_EQ(read.columns->origin_x, columns->origin_x);
  EXPECT_EQ(read.columns->origin_y, columns->origin_y);
  EXPECT_EQ(read.columns->cell_size, columns->cell_size);
  EXPECT_EQ(read.columns->columns, 3U);
  EXPECT_EQ(read.columns->rows, 2U);
  EXPECT_EQ(read.columns->bed, columns->bed);
  EXPECT_EQ(read.columns->depth, columns->depth);
  EXPECT_EQ(read.columns->velocity_x, columns->velocity_x);
  EXPECT_EQ(read.columns->velocity_y, columns->velocity_y);
  snapshot.columns = nullptr;
  write_particles(folder / "without.vtp", snapshot);
  EXPECT_EQ(read_particles(folder / "without.vtp").columns, nullptr);
}

}  // namespace
}  // namespace eisph
