#include "core/assets.hpp"
#include "core/error.hpp"
#include "render/egl_context.hpp"
#include "render/frame_renderer.hpp"
#include "render/gl_window.hpp"
#include "render/offscreen_target.hpp"
#include "render/os_mesa_context.hpp"
#include "render/shader_program.hpp"
#include "render/synthetic_scene.hpp"
#include "render/temporary_folder.hpp"
#include "render/virtual_display.hpp"

#include <fstream>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(OsMesaContext, AMissingLibraryNamesThePackage) {
  EXPECT_THAT([] { OsMesaContext context("libno_such_mesa.so.1"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("libno_such_mesa.so.1"), HasSubstr("libosmesa6"))));
}

TEST(EglContext, AMissingLibraryNamesThePackages) {
  EXPECT_THAT([] { EglContext context("libno_such_egl.so.1"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("libno_such_egl.so.1"), HasSubstr("libegl-mesa0"))));
}

TEST(DynamicLibrary, AnotherLibraryIsNamedWithWhatItLacks) {
  EXPECT_THAT(
      [] { OsMesaContext context("libz.so.1"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("libz.so.1"), HasSubstr("OSMesaCreateContextAttribs"))));
  EXPECT_THAT([] { EglContext context("libz.so.1"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("libz.so.1"), HasSubstr("eglGetProcAddress"))));
}

TEST(GlWindow, AMissingDisplayNamesTheOtherContexts) {
  const WithoutDisplay nothing;
  EXPECT_THAT([] { GlWindow window(WindowSettings{}); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("--context osmesa or egl"), HasSubstr("xvfb"))));
}

TEST(GlContext, HasANameForEveryKind) {
  for (const auto kind :
       {ContextKind::Automatic, ContextKind::OsMesa, ContextKind::Egl, ContextKind::Window}) {
    EXPECT_EQ(context_kind(context_name(kind)), kind);
  }
  EXPECT_THAT([] { static_cast<void>(context_kind("glut")); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("glut"), HasSubstr("osmesa"), HasSubstr("egl"))));
}

TEST(GlContext, EveryKindDrawsIntoMemory) {
  const VirtualDisplay display;
  for (const auto kind :
       {ContextKind::OsMesa, ContextKind::Egl, ContextKind::Window, ContextKind::Automatic}) {
    const auto context = create_context(kind);
    const auto name = std::string(context_name(kind));
    context->make_current();
    if (kind != ContextKind::Automatic) {
      EXPECT_EQ(context->kind(), kind);
      EXPECT_THAT(context->description(), AllOf(HasSubstr(name + ": "), HasSubstr("OpenGL ")));
    }
    const OffscreenTarget target(context->functions(), 4, 4);
    target.begin({0.0F, 1.0F, 0.0F});
    EXPECT_EQ(target.read().rgb[1], 255) << name;
  }
}

TEST(OsMesaContext, TwoOnOneThreadDrawApart) {
  OsMesaContext first;
  const OffscreenTarget red(first.functions(), 4, 4);
  OsMesaContext second;
  const OffscreenTarget green(second.functions(), 4, 4);
  first.make_current();
  red.begin({1.0F, 0.0F, 0.0F});
  second.make_current();
  green.begin({0.0F, 1.0F, 0.0F});
  first.make_current();
  EXPECT_EQ(red.read().rgb[0], 255);
  second.make_current();
  EXPECT_EQ(green.read().rgb[0], 0);
  first.make_current();
}

TEST(OffscreenTarget, SizesBeyondTheDriverAreRefused) {
  const OsMesaContext context;
  EXPECT_THROW(OffscreenTarget(context.functions(), 100'000, 10), std::runtime_error);
}

TEST(ShaderProgram, MissingAndBrokenFilesAreReportedByName) {
  const TemporaryFolder folder;
  const OsMesaContext context;
  const auto make = [&] { const ShaderProgram program(context.functions(), folder.path(), "test"); };
  EXPECT_THAT(make, ThrowsMessage<InputError>(AllOf(HasSubstr("test.vert"), HasSubstr("cannot be read"))));
  std::ofstream(folder.path() / "test.vert")
      << "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
  std::ofstream(folder.path() / "test.frag") << "#version 330 core\nvoid main() { undeclared = 1.0; }\n";
  EXPECT_THAT(make, ThrowsMessage<InputError>(AllOf(HasSubstr("test.frag"), HasSubstr("undeclared"))));
  std::ofstream(folder.path() / "test.vert") << "#version 330 core\nout vec4 shared_value;\nvoid main() { "
                                                "gl_Position = shared_value = vec4(0.0); }\n";
  std::ofstream(folder.path() / "test.frag") << "#version 330 core\nin vec3 shared_value;\nout vec4 c;\nvoid "
                                                "main() { c = vec4(shared_value, 1.0); }\n";
  EXPECT_THAT(make, ThrowsMessage<InputError>(AllOf(HasSubstr("do not link"), HasSubstr("shared_value"))));
}

/// Sets EISPH_HOME while it lives.
class HomeFolder {
 public:
  explicit HomeFolder(const std::filesystem::path& path) { setenv("EISPH_HOME", path.c_str(), 1); }
  HomeFolder(const HomeFolder&) = delete;
  HomeFolder& operator=(const HomeFolder&) = delete;
  ~HomeFolder() { unsetenv("EISPH_HOME"); }
};

TEST(FrameRenderer, MissingShadersAndColourMapsAreReportedByPath) {
  const TemporaryFolder folder;
  const HomeFolder home(folder.path());
  synthetic::State state = synthetic::tank(0.05);
  FrameRenderer renderer(state.scene);
  ImageSettings settings;
  EXPECT_THAT([&] { renderer.draw(settings, state.snapshot, state.depth); },
              ThrowsMessage<InputError>(HasSubstr((folder.path() / "assets").string())));
  std::filesystem::copy(std::filesystem::path(EISPH_SOURCE_DIR) / "assets", folder.path() / "assets",
                        std::filesystem::copy_options::recursive);
  EXPECT_THAT([&] { renderer.draw(settings, state.snapshot, state.depth); },
              ThrowsMessage<InputError>(HasSubstr((folder.path() / "shaders" / "particle.vert").string())));
}

TEST(FrameRenderer, AMissingShaderIsReportedAtTheStartWhenTheSceneNeedsIt) {
  const TemporaryFolder folder;
  const HomeFolder home(folder.path());
  Scene scene = synthetic::tank_scene(0.05);
  scene.images.emplace_back();
  EXPECT_THROW(FrameRenderer{scene}, InputError);
}

}  // namespace
}  // namespace eisph
