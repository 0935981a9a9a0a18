#include "io/scene_text.hpp"

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ParticleSchemeScene, CompletesWhatTheSchemeNeeds) {
  SceneLoader loader;
  const Scene eisph = loader.load(kSceneText);
  EXPECT_EQ(eisph.scheme.source_factor, 3.0);
  const Scene isph = loader.load(kSceneText, {"scheme.name=isph"});
  EXPECT_EQ(isph.scheme.source_factor, 1.0);
  const Scene delta = loader.load(kSceneText, {"scheme.name=delta_sph"});
  EXPECT_DOUBLE_EQ(delta.scheme.sound_speed, 10.0 * delta.reference_speed());
  EXPECT_EQ(delta.scheme.courant, 0.25);
  EXPECT_EQ(loader.load(resolved_scene_toml(delta)).scheme, delta.scheme);
  const Scene steps = loader.load(
      kSceneText, {"scheme.name=delta_sph", "scheme.stepping=runge_kutta", "scheme.sound_speed=30"});
  EXPECT_EQ(steps.scheme.stepping, Stepping::RungeKutta);
  EXPECT_EQ(steps.scheme.courant, 1.25);
  EXPECT_EQ(steps.scheme.sound_speed, 30.0);
}

TEST(ParticleSchemeScene, NamesSteppingsThatTheSchemeDoesNotHave) {
  SceneLoader loader;
  EXPECT_THAT(loader.error(kSceneText, {"scheme.name=wcsph", "scheme.stepping=thesis"}),
              AllOf(HasSubstr("scheme.stepping"), HasSubstr("\"wcsph\""), HasSubstr("runge_kutta")));
  EXPECT_THAT(loader.error(kSceneText, {"scheme.stepping=predictor_corrector"}),
              AllOf(HasSubstr("scheme.stepping"), HasSubstr("\"eisph\""), HasSubstr("\"thesis\"")));
  EXPECT_THAT(loader.error(kSceneText, {"scheme.name=sph"}),
              AllOf(HasSubstr("scheme.name"), HasSubstr("\"delta_sph\""), HasSubstr("\"isph\"")));
}

TEST(ParticleSchemeScene, WithoutGravitySomethingElseMustMove) {
  SceneLoader loader;
  EXPECT_THAT(loader.error(kSceneText, {"gravity=[0.0, 0.0, 0.0]"}),
              AllOf(HasSubstr("gravity"), HasSubstr("nothing moves")));
  const Scene moving =
      loader.load(kSceneText, {"gravity=[0.0, 0.0, 0.0]", "fluid.region.0.angular_velocity=2.0"});
  EXPECT_GT(moving.expected_speed(), 0.0);
  EXPECT_GT(moving.scheme.sound_speed, 0.0);
}

}  // namespace
}  // namespace eisph
