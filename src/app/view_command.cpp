#include "app/commands.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/run_files.hpp"
#include "app/view/live_simulation.hpp"
#include "app/view/recorded_run.hpp"
#include "app/view/viewer.hpp"
#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "render/gl_window.hpp"

#include <chrono>
#include <cstdint>
#include <limits>
#include <ostream>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>
#include <fmt/ostream.h>

namespace eisph {

namespace {

constexpr std::chrono::milliseconds kFrameTime(33);  ///< least time between two drawings
constexpr double kIdleTime = 0.2;                    ///< s, between two looks at the source without input

/// ImGui's input from a window.
class WindowInput {
 public:
  explicit WindowInput(const GlWindow& window) { ImGui_ImplGlfw_InitForOpenGL(window.handle(), true); }
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;
  ~WindowInput() { ImGui_ImplGlfw_Shutdown(); }
  static void take() { ImGui_ImplGlfw_NewFrame(); }
};

/// What is to be looked at, and the folder of what the viewer writes.
struct Subject {
  Scene scene;
  std::unique_ptr<StateSource> source;
  std::filesystem::path folder;
};

Subject open_subject(const ViewOptions& options) {
  Subject subject;
  if (std::filesystem::is_directory(options.subject)) {
    const RunFiles files{options.subject};
    if (!std::filesystem::is_regular_file(files.scene())) {
      throw InputError(
          fmt::format("{}: is not the folder of a run: it has no scene.toml", options.subject.string()));
    }
    subject.scene = load_scene(files.scene(), options.overrides, std::numeric_limits<std::uint64_t>::max());
    subject.source = std::make_unique<RecordedRun>(options.subject);
    subject.folder = options.out.value_or(options.subject / "view");
    return subject;
  }
  subject.scene = load_scene(options.subject, options.overrides);
  const auto make = [scene = subject.scene, threads = options.threads] {
    return Simulation::create(scene, threads);
  };
  subject.source = std::make_unique<LiveSimulation>(subject.scene, make);
  subject.folder = options.out.value_or(std::filesystem::path("out") / subject.scene.name / "view");
  return subject;
}

}  // namespace

int view_command(const ViewOptions& options, std::ostream& out) {
  const InterruptWatcher interrupt;
  // The window first: without a display nothing is simulated.
  const auto window = std::make_shared<GlWindow>(
      WindowSettings{.width = options.width, .height = options.height, .title = "eisph", .visible = true});
  const Subject subject = open_subject(options);
  const float scale = options.scale > 0.0 ? static_cast<float>(options.scale) : window->scale();
  Viewer viewer(window, subject.scene, *subject.source, {.scale = scale, .folder = subject.folder});
  const WindowInput input(*window);
  glfwSetWindowTitle(window->handle(), fmt::format("eisph: {}", subject.scene.name).c_str());
  glfwSwapInterval(0);
  if (options.until) subject.source->run_to(*options.until);

  bool going_on = true;
  while (going_on) {
    const auto start = std::chrono::steady_clock::now();
    if (viewer.busy() || options.until) {
      glfwPollEvents();
    } else {
      glfwWaitEventsTimeout(kIdleTime);
    }
    WindowInput::take();
    viewer.draw(0);
    window->present();
    const SourceStatus status = subject.source->status();
    const bool until_met =
        options.until && (status.time >= *options.until || status.at_end || !status.message.empty());
    going_on = glfwWindowShouldClose(window->handle()) == GLFW_FALSE && !interrupt.requested() && !until_met;
    std::this_thread::sleep_until(start + kFrameTime);
  }
  const SourceStatus status = subject.source->status();
  fmt::print(out, "{}: t = {:.6g} s, {} steps", subject.scene.name, status.time, status.steps);
  if (status.carrier_steps_per_second > 0.0) {
    fmt::print(out, ", {:.3g} million particle-steps/s", 1e-6 * status.carrier_steps_per_second);
  }
  fmt::print(out, "; {} pictures{}\n", viewer.frames_written(),
             viewer.frames_written() > 0 ? " in " + subject.folder.string() : "");
  if (!status.message.empty()) throw BlowUpError(status.message);
  return interrupt.requested() ? kInterrupted : 0;
}

}  // namespace eisph
