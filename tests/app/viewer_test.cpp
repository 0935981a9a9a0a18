// The viewer's interface in a context without a display, driven through ImGui's input, and in a real window.

#include "app/view/viewer.hpp"

#include "io/temporary_folder.hpp"
#include "render/gl_window.hpp"
#include "render/golden.hpp"
#include "render/offscreen_target.hpp"
#include "render/os_mesa_context.hpp"
#include "render/synthetic_scene.hpp"
#include "render/virtual_display.hpp"

#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <gmock/gmock.h>
#include <imgui.h>

namespace eisph {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 1366;
constexpr int kHeight = 768;
constexpr int kRightKey = GLFW_KEY_RIGHT;

/// A source that shows one state and notes what it is told.
class SourceDouble final : public StateSource {
 public:
  explicit SourceDouble(const Snapshot& snapshot) : snapshot_(std::make_shared<const Snapshot>(snapshot)) {
    ProbePlot plot{.title = "gauge_a", .unit = "m", .x = {}, .series = {{"level", {}}, {"surface", {}}}};
    for (int k = 0; k <= 80; ++k) {
      plot.x.push_back(0.01 * k);
      plot.series[0].values.push_back(0.1 * std::exp(-0.02 * k));
      plot.series[1].values.push_back(k < 20 ? std::nan("") : 0.05 + 0.0005 * k);
    }
    plots_ = std::make_shared<const std::vector<ProbePlot>>(std::vector<ProbePlot>{plot});
    now.time = snapshot.time;
    now.time_step = 1.5e-3;
    now.steps = 270;
    now.carriers = snapshot.size();
    now.carrier_steps_per_second = 1.85e6;
    now.stage_times = {{"gradient", 80.0}, {"pressure", 120.0}};
  }
  [[nodiscard]] std::shared_ptr<const Snapshot> latest() override { return snapshot_; }
  [[nodiscard]] SourceStatus status() const override { return now; }
  [[nodiscard]] std::shared_ptr<const std::vector<ProbePlot>> plots() const override { return plots_; }
  void play() override { orders += "play "; }
  void pause() override { orders += "pause "; }
  void step() override { orders += "step "; }
  void restart() override { orders += "restart "; }
  void run_to(double) override { orders += "run_to "; }
  [[nodiscard]] const std::vector<double>& saved_times() const override { return times; }
  void show(std::size_t state) override { orders += "show " + std::to_string(state) + " "; }
  [[nodiscard]] bool takes_parameters() const override { return times.empty(); }
  void set_parameters(const RunningParameters&) override { orders += "parameters "; }
  void record(double, Recorder take) override { recorder = std::move(take); }

  [[nodiscard]] std::string take_orders() { return std::exchange(orders, {}); }

  SourceStatus now;
  std::string orders;
  std::vector<double> times;
  Recorder recorder;

 private:
  std::shared_ptr<const Snapshot> snapshot_;
  std::shared_ptr<const std::vector<ProbePlot>> plots_;
};

class ViewerTest : public testing::Test {
 protected:
  /// A round of the interface, as a window would ask for it.
  Image round(Viewer& viewer, int width = kWidth, int height = kHeight) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
    io.DeltaTime = 1.0F / 60.0F;
    if (!target_ || target_->width() != width || target_->height() != height) {
      target_.emplace(context_->functions(), width, height);
    }
    viewer.draw(target_->framebuffer());
    return target_->read();
  }
  void press(Viewer& viewer, int key) {
    ImGui::GetIO().KeysDown[key] = true;
    round(viewer);
    ImGui::GetIO().KeysDown[key] = false;
    round(viewer);
  }
  void click(Viewer& viewer, float x, float y) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(x, y);
    round(viewer);
    io.MouseDown[0] = true;
    round(viewer);
    io.MouseDown[0] = false;
    round(viewer);
  }
  void drag(Viewer& viewer, int button, ImVec2 from, ImVec2 to) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = from;
    round(viewer);
    io.MouseDown[button] = true;
    round(viewer);
    io.MousePos = to;
    round(viewer);
    io.MouseDown[button] = false;
    round(viewer);
  }
  [[nodiscard]] ViewerOptions options(float scale = 1.0F) const {
    return {.scale = scale, .folder = folder_.path() / "view"};
  }

  TemporaryFolder folder_;
  std::shared_ptr<GlContext> context_ = std::make_shared<OsMesaContext>();
  synthetic::State state_ = synthetic::tank(0.025);
  SourceDouble source_{state_.snapshot};
  std::optional<OffscreenTarget> target_;
};

TEST_F(ViewerTest, FitsALaptop) {
  Viewer viewer(context_, state_.scene, source_, options());
  round(viewer);
  expect_golden("viewer", round(viewer));
}

TEST_F(ViewerTest, LooksTheSameOnAScreenOfTwiceAsManyPixels) {
  Viewer viewer(context_, state_.scene, source_, options(2.0F));
  round(viewer, 2 * kWidth, 2 * kHeight);
  const Image large = round(viewer, 2 * kWidth, 2 * kHeight);
  Image half(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) std::copy_n(large.pixel(2 * x, 2 * y), 3, half.pixel(x, y));
  }
  const Image expected =
      read_png(std::filesystem::path(EISPH_SOURCE_DIR) / "tests/render/golden/viewer.png").image;
  // Letters are sharper and lines of one pixel are not everywhere met, but nothing stands elsewhere.
  EXPECT_LT(different_pixels(half, expected), 0.08);
}

TEST_F(ViewerTest, KeysDriveTheSource) {
  Viewer viewer(context_, state_.scene, source_, options());
  round(viewer);
  press(viewer, ' ');
  EXPECT_EQ(source_.take_orders(), "play ");
  source_.now.playing = true;
  EXPECT_TRUE(viewer.busy());
  press(viewer, ' ');
  EXPECT_EQ(source_.take_orders(), "pause ");
  press(viewer, kRightKey);
  EXPECT_EQ(source_.take_orders(), "step ");
  press(viewer, 'R');
  EXPECT_EQ(source_.take_orders(), "restart ");
}

TEST_F(ViewerTest, KeysChangeThePicture) {
  Viewer viewer(context_, state_.scene, source_, options());
  const Image before = round(viewer);
  EXPECT_EQ(viewer.settings().picture.field, "speed");
  press(viewer, 'F');
  EXPECT_EQ(viewer.settings().picture.field, "velocity_x");
  EXPECT_EQ(viewer.settings().picture.colour_map, "blue_red");
  press(viewer, '4');
  EXPECT_EQ(viewer.settings().picture.camera->up, Vec3d::UnitY());
  press(viewer, 'O');
  EXPECT_EQ(viewer.settings().picture.camera->projection, Projection::Orthographic);
  press(viewer, 'B');
  EXPECT_TRUE(viewer.settings().picture.dark_background);
  press(viewer, 'D');
  EXPECT_FALSE(viewer.settings().side_panel);
  EXPECT_GT(different_pixels(before, round(viewer)), 0.3);
}

TEST_F(ViewerTest, TheHelpPanelComesAndGoes) {
  Viewer viewer(context_, state_.scene, source_, options());
  round(viewer);
  const Image before = round(viewer);
  press(viewer, 'H');
  round(viewer);
  expect_golden("viewer_help", round(viewer));
  press(viewer, GLFW_KEY_ESCAPE);
  EXPECT_LT(different_pixels(before, round(viewer)), 0.001);
}

TEST_F(ViewerTest, TheMousePlaysTurnsMovesAndZooms) {
  Viewer viewer(context_, state_.scene, source_, options());
  round(viewer);
  click(viewer, 40.0F, 37.0F);  // the first button below the title
  EXPECT_EQ(source_.take_orders(), "play ");
  const Camera start = *viewer.settings().picture.camera;
  drag(viewer, 0, ImVec2(600.0F, 400.0F), ImVec2(700.0F, 400.0F));
  const Camera turned = *viewer.settings().picture.camera;
  EXPECT_NEAR((turned.eye - turned.target).norm(), (start.eye - start.target).norm(), 1e-9);
  EXPECT_GT((turned.eye - start.eye).norm(), 0.5);
  EXPECT_NEAR(turned.eye.z(), start.eye.z(), 1e-9);
  drag(viewer, 1, ImVec2(600.0F, 400.0F), ImVec2(650.0F, 420.0F));
  EXPECT_GT((viewer.settings().picture.camera->target - turned.target).norm(), 0.05);
  const double distance = (start.eye - start.target).norm();
  ImGui::GetIO().MouseWheel = 2.0F;
  round(viewer);
  const Camera& near = *viewer.settings().picture.camera;
  EXPECT_NEAR((near.eye - near.target).norm(), 0.88 * 0.88 * distance, 1e-6 * distance);
}

// Places of the headers below are those of the golden picture.
constexpr float kCutHeader = 413.0F;
constexpr float kShowHeader = 438.0F;
constexpr float kParametersHeader = 463.0F;
constexpr float kRow = 25.0F;

TEST_F(ViewerTest, AHandleTakesAClipPlaneAlongItsAxis) {
  Viewer viewer(context_, state_.scene, source_, options());
  const Image whole = round(viewer);
  click(viewer, 100.0F, kCutHeader);
  click(viewer, 18.0F, kCutHeader + kRow);
  ASSERT_TRUE(viewer.settings().cut[0]) << "x from";
  EXPECT_EQ(viewer.settings().cut_at[0], 0.0);
  constexpr int kColumns = kWidth - 600;
  const Camera camera = *viewer.settings().picture.camera;
  const CameraView view(camera, kHeight, kColumns, kHeight, drawn_bounds(state_.scene));
  const Bounds box = framed_bounds(state_.scene);
  const auto on_screen = [&](double x) {
    Vec3d centre = 0.5 * (box.lower + box.upper);
    centre.x() = x;
    const Vec3d at = view.project(centre);
    return ImVec2(300.0F + static_cast<float>(at.x()), static_cast<float>(at.y()));
  };
  drag(viewer, 0, on_screen(0.0), on_screen(0.2));
  EXPECT_NEAR(viewer.settings().cut_at[0], 0.2, 0.03);
  EXPECT_EQ(*viewer.settings().picture.camera, camera) << "the picture does not turn meanwhile";
  EXPECT_GT(different_pixels(whole, round(viewer)), 0.005);
}

TEST_F(ViewerTest, ShowsEverySortOfParticle) {
  Viewer viewer(context_, state_.scene, source_, options());
  const Image before = round(viewer);
  click(viewer, 100.0F, kShowHeader);
  click(viewer, 18.0F, kShowHeader + 8.0F * kRow);
  EXPECT_TRUE(viewer.settings().picture.draw_ghosts);
  const Image with_ghosts = round(viewer);
  EXPECT_GT(different_pixels(before, with_ghosts), 0.01);
  click(viewer, 18.0F, kShowHeader + 9.0F * kRow);
  EXPECT_TRUE(viewer.settings().picture.draw_virtual_particles);
  EXPECT_GT(different_pixels(with_ghosts, round(viewer)), 0.01);
  click(viewer, 18.0F, kShowHeader + 2.0F * kRow);
  EXPECT_EQ(viewer.settings().picture.style, WaterStyle::Surface);
}

TEST_F(ViewerTest, AppliesParametersAndLogsThem) {
  Viewer viewer(context_, state_.scene, source_, options());
  round(viewer);
  click(viewer, 100.0F, kParametersHeader);
  EXPECT_EQ(source_.take_orders(), "");
  click(viewer, 100.0F, kParametersHeader + 5.0F * kRow);
  EXPECT_EQ(source_.take_orders(), "parameters ");
  ASSERT_FALSE(viewer.log().empty());
  EXPECT_THAT(viewer.log().front(), HasSubstr("phi = 0.17"));
}

TEST_F(ViewerTest, ScrubsThroughSavedStates) {
  source_.times = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5};
  source_.now.time = 0.4;
  Viewer viewer(context_, state_.scene, source_, options());
  round(viewer);
  press(viewer, GLFW_KEY_LEFT);
  EXPECT_EQ(source_.take_orders(), "pause show 3 ");
  click(viewer, 20.0F, 87.0F);  // the left end of the slider
  EXPECT_EQ(source_.take_orders(), "pause show 0 ");
}

TEST_F(ViewerTest, ScreenshotsAndRecordingsAreFrames) {
  state_.scene.images.clear();
  Viewer viewer(context_, state_.scene, source_, options());
  round(viewer);
  press(viewer, 'S');
  ASSERT_EQ(viewer.frames_written(), 1U);
  const PngFile file = read_png(folder_.path() / "view" / "frames" / "view_0000.png");
  EXPECT_EQ(file.image.width, 1280);
  ImageSettings settings;
  settings.camera = viewer.settings().picture.camera;
  const Image frame = FrameRenderer(state_.scene).draw(settings, state_.snapshot, state_.depth);
  EXPECT_EQ(file.image.rgb, frame.rgb) << "the same as a frame of a run";

  press(viewer, 'V');
  ASSERT_TRUE(source_.recorder);
  source_.recorder(state_.snapshot);
  EXPECT_EQ(viewer.frames_written(), 2U);
  press(viewer, 'V');
  EXPECT_FALSE(source_.recorder);
  std::ifstream log(folder_.path() / "view" / "view.log");
  std::stringstream text;
  text << log.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("recording every"));
  EXPECT_THAT(text.str(), HasSubstr("view_0001.png"));
}

TEST_F(ViewerTest, ShowsWhatWentWrong) {
  source_.now.message = "the run blew up at t = 0.25 s";
  Viewer viewer(context_, state_.scene, source_, options());
  const Image with = round(viewer);
  source_.now.message.clear();
  EXPECT_GT(different_pixels(with, round(viewer)), 5e-4);
}

TEST_F(ViewerTest, DrawsTheSameInAWindow) {
  const VirtualDisplay display("1600x900x24");
  const auto window = std::make_shared<GlWindow>(
      WindowSettings{.width = kWidth, .height = kHeight, .title = "eisph", .visible = true});
  Viewer viewer(window, state_.scene, source_, options());
  ImGui_ImplGlfw_InitForOpenGL(window->handle(), true);
  Image image(kWidth, kHeight);
  for (int k = 0; k < 3; ++k) {
    glfwPollEvents();
    ImGui_ImplGlfw_NewFrame();
    viewer.draw(0);
    const GlFunctions& gl = window->functions();
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.ReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    window->present();
  }
  Image upright(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    std::copy_n(image.pixel(0, kHeight - 1 - y), 3 * kWidth, upright.pixel(0, y));
  }
  expect_golden("viewer", upright);
  ImGui_ImplGlfw_Shutdown();
}

}  // namespace
}  // namespace eisph
