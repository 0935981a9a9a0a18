#include "io/scene_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(SceneOverride, ReplacesAndAddsValuesInTomlSyntax) {
  SceneLoader loader;
  const Scene scene =
      loader.load(kSceneText, {"particles.spacing=0.05", "output.times=[0.1, 0.9]", "scheme.phi=0.11",
                               "domain.faces.x_max=0.5", "boundary.ghost_particles=false",
                               "fluid.region.0.velocity=[1, 0, 0]"});
  EXPECT_EQ(scene.particle_spacing, 0.05);
  EXPECT_THAT(scene.output.frames.times, ElementsAre(0.1, 0.9));
  EXPECT_EQ(scene.scheme.phi, 0.11);
  EXPECT_EQ(scene.faces[kXMax].slip_factor, 0.5);
  EXPECT_FALSE(scene.boundary.ghost_particles);
  EXPECT_EQ(scene.fluid.at(0).velocity, Vec3d(1.0, 0.0, 0.0));
}

TEST(SceneOverride, TakesABareWordAsText) {
  SceneLoader loader;
  const Scene scene = loader.load(kSceneText, {"scheme.stepping=thesis", "title=A tank = a box, with gate",
                                               "image.0.field=\"pressure\""});
  EXPECT_EQ(scene.scheme.stepping, Stepping::Thesis);
  EXPECT_EQ(scene.title, "A tank = a box, with gate");
  EXPECT_EQ(scene.images.at(0).field, "pressure");
}

TEST(SceneOverride, FindsElementsByNumberAndByName) {
  SceneLoader loader;
  const Scene scene =
      loader.load(kSceneText + "[[image]]\nname = \"second\"\n",
                  {"image.second.width=640", "image.0.height=480", "image.view.camera.field_of_view=50"});
  EXPECT_EQ(scene.images.at(1).width, 640);
  EXPECT_EQ(scene.images.at(0).height, 480);
  EXPECT_EQ(scene.images.at(0).camera.value().field_of_view, 50.0);
}

TEST(SceneOverride, TheLastOneCounts) {
  SceneLoader loader;
  EXPECT_EQ(loader.load(kSceneText, {"end_time=0.8", "end_time=0.9"}).end_time, 0.9);
}

TEST(SceneOverride, ErrorsNameTheOptionInsteadOfALine) {
  SceneLoader loader;
  const auto error = [&](const std::string& assignment) { return loader.error(kSceneText, {assignment}); };
  EXPECT_THAT(error("particles.spacng=0.02"), AllOf(HasSubstr("case.toml, --set particles.spacng=0.02: "),
                                                    HasSubstr("did you mean spacing?")));
  EXPECT_THAT(error("particle.spacing=0.02"),
              AllOf(HasSubstr("--set particle.spacing=0.02: "), HasSubstr("did you mean particles?")));
  EXPECT_THAT(error("particles.spacing=-1"), AllOf(HasSubstr("--set particles.spacing=-1: "),
                                                   HasSubstr("particles.spacing = -1: expected a number")));
  EXPECT_THAT(error("scheme.phi=fast"),
              AllOf(HasSubstr("--set scheme.phi=fast: "), HasSubstr("scheme.phi = \"fast\"")));
  EXPECT_THAT(error("end_time=0.3"), AllOf(HasSubstr("case.toml:38: "), HasSubstr("end_time = 0.3 s")));
}

TEST(SceneOverride, RejectsWhatHasNoPlace) {
  SceneLoader loader;
  const auto error = [&](const std::string& assignment) { return loader.error(kSceneText, {assignment}); };
  EXPECT_THAT(error("particles.spacing"), HasSubstr("expected section.key=value"));
  EXPECT_THAT(error("=3"), HasSubstr("expected section.key=value"));
  EXPECT_THAT(error("particles..spacing=3"), HasSubstr("expected section.key=value"));
  EXPECT_THAT(error("image.5.width=640"), HasSubstr("image has no element 5; there are: 0 (view)"));
  EXPECT_THAT(error("image.top.width=640"), HasSubstr("image has no element top"));
  EXPECT_THAT(error("image.0=3"), HasSubstr("image.0 is a section"));
  EXPECT_THAT(error("name.short=a"), HasSubstr("name is not a section"));
}

TEST(SceneOverride, CanSetTheDimensionOfASceneWithoutImages) {
  SceneLoader loader;
  const std::string text = edited(kSceneText2d, "[[image]]\nname = \"view\"\n", "");
  EXPECT_EQ(loader.load(edited(text, "dimension = 2", ""), {"image.0.width=64", "dimension=2"}).images.size(),
            1U);
}

}  // namespace
}  // namespace eisph
