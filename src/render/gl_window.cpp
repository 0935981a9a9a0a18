#include "render/gl_window.hpp"

#include "core/error.hpp"
#include "render/renderer_threads.hpp"

#include <mutex>
#include <stdexcept>

#include <fmt/format.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace eisph {

namespace {

/// What GLFW last complained about.
std::string complaint() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

/// GLFW between its first and its last window.
class Library {
 public:
  static void open() {
    const std::lock_guard lock(mutex());
    if (windows()++ > 0) return;
    if (glfwInit() == GLFW_TRUE) return;
    windows() = 0;
    throw InputError(
        fmt::format("no window can be opened ({}): it takes a display, which xvfb-run (Debian package xvfb) "
                    "makes in memory; "
                    "frames need none with --context osmesa or egl",
                    complaint()));
  }
  static void close() {
    const std::lock_guard lock(mutex());
    if (--windows() == 0) glfwTerminate();
  }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  static int& windows() {
    static int count = 0;
    return count;
  }
};

}  // namespace

GlWindow::GlWindow(const WindowSettings& settings) {
  limit_software_renderer_threads();
  Library::open();
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, settings.visible ? GLFW_TRUE : GLFW_FALSE);
  window_ = glfwCreateWindow(settings.width, settings.height, settings.title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string why = complaint();
    Library::close();
    throw InputError(fmt::format(
        "the display gives no window with OpenGL 3.3 ({}); install the Debian package libgl1-mesa-dri", why));
  }
  try {
    make_current();
    functions_ =
        load_gl_functions([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
  } catch (...) {
    glfwDestroyWindow(window_);
    Library::close();
    throw;
  }
}

GlWindow::~GlWindow() {
  if (glfwGetCurrentContext() == window_) glfwMakeContextCurrent(nullptr);
  glfwDestroyWindow(window_);
  Library::close();
}

void GlWindow::make_current() {
  if (glfwGetCurrentContext() == window_) return;
  glfwMakeContextCurrent(window_);
  if (glfwGetCurrentContext() != window_)
    throw std::runtime_error("the window's context cannot be made current");
}

int GlWindow::pixel_width() const {
  int width = 0;
  glfwGetFramebufferSize(window_, &width, nullptr);
  return width;
}

int GlWindow::pixel_height() const {
  int height = 0;
  glfwGetFramebufferSize(window_, nullptr, &height);
  return height;
}

float GlWindow::scale() const {
  float across = 1.0F;
  glfwGetWindowContentScale(window_, &across, nullptr);
  return across > 0.0F ? across : 1.0F;
}

void GlWindow::present() { glfwSwapBuffers(window_); }

}  // namespace eisph
