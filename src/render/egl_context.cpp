#include "render/egl_context.hpp"

#include "core/error.hpp"
#include "render/dynamic_library.hpp"
#include "render/renderer_threads.hpp"

#include <array>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <vector>

#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

namespace eisph {

namespace {

constexpr const char* kPackages = "install the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri";

/// Set-up of the drivers' process-wide state is not safe against itself.
std::mutex& creation_mutex() {
  static std::mutex mutex;
  return mutex;
}

bool has_word(const char* list, const char* word) {
  if (list == nullptr) return false;
  const std::string padded = fmt::format(" {} ", list);
  return padded.find(fmt::format(" {} ", word)) != std::string::npos;
}

}  // namespace

struct EglContext::Library {
  DynamicLibrary file;
  PFNEGLGETPROCADDRESSPROC address_of = nullptr;
  PFNEGLINITIALIZEPROC initialise = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;
  PFNEGLGETCURRENTCONTEXTPROC current_context = nullptr;
  PFNEGLQUERYSTRINGPROC query_string = nullptr;
  // Extensions; null where the library has none.
  PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC device_string = nullptr;

  explicit Library(const std::filesystem::path& path) : file(path, "EGL", kPackages) {
    file.find("eglGetProcAddress", address_of);
    file.find("eglInitialize", initialise);
    file.find("eglBindAPI", bind_api);
    file.find("eglChooseConfig", choose_config);
    file.find("eglCreateContext", create_context);
    file.find("eglDestroyContext", destroy_context);
    file.find("eglMakeCurrent", make_current);
    file.find("eglGetCurrentContext", current_context);
    file.find("eglQueryString", query_string);
    platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(address_of("eglGetPlatformDisplayEXT"));
    query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(address_of("eglQueryDevicesEXT"));
    device_string = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(address_of("eglQueryDeviceStringEXT"));
  }

  /// Graphics cards, without what draws in software.
  [[nodiscard]] std::vector<EGLDeviceEXT> cards() const {
    if (query_devices == nullptr || device_string == nullptr) return {};
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) return {};
    std::vector<EGLDeviceEXT> cards;
    cards.reserve(static_cast<std::size_t>(count));
    for (EGLint k = 0; k < count; ++k) {
      EGLDeviceEXT device = devices[static_cast<std::size_t>(k)];
      if (!has_word(device_string(device, EGL_EXTENSIONS), "EGL_MESA_device_software"))
        cards.push_back(device);
    }
    return cards;
  }
};

EglContext::EglContext(const std::filesystem::path& library) {
  const std::lock_guard lock(creation_mutex());
  limit_software_renderer_threads();
  library_ = std::make_unique<Library>(library);
  if (library_->platform_display == nullptr) {
    throw InputError(fmt::format("{}: this EGL draws on displays only; {}", library.string(), kPackages));
  }
  for (EGLDeviceEXT card : library_->cards()) {
    if (!open(library_->platform_display(EGL_PLATFORM_DEVICE_EXT, card, nullptr))) continue;
    software_ = false;
    break;
  }
  if (context_ == nullptr) {
    open(library_->platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  if (context_ == nullptr) {
    throw InputError(fmt::format("{}: EGL gives no OpenGL 3.3 context without a display; {}",
                                 library.string(), kPackages));
  }
  try {
    functions_ = load_gl_functions(
        [this](const char* name) { return reinterpret_cast<void*>(library_->address_of(name)); });
    const auto* renderer = reinterpret_cast<const char*>(functions_.GetString(GL_RENDERER));
    if (renderer != nullptr && std::strstr(renderer, "llvmpipe") != nullptr) software_ = true;
  } catch (...) {
    library_->destroy_context(display_, context_);
    throw;
  }
}

bool EglContext::open(void* display) {
  if (display == EGL_NO_DISPLAY || library_->initialise(display, nullptr, nullptr) == EGL_FALSE) return false;
  if (!has_word(library_->query_string(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) return false;
  if (library_->bind_api(EGL_OPENGL_API) == EGL_FALSE) return false;
  const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (library_->choose_config(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count < 1)
    return false;
  const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                            3,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            3,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
  EGLContext context = library_->create_context(display, config, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) return false;
  if (library_->make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    library_->destroy_context(display, context);
    return false;
  }
  display_ = display;
  context_ = context;
  return true;
}

// Displays are shared by all contexts of the process and stay initialised.
EglContext::~EglContext() {
  const std::lock_guard lock(creation_mutex());
  if (library_->current_context() == context_) {
    library_->make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  library_->destroy_context(display_, context_);
}

void EglContext::make_current() {
  if (library_->current_context() == context_) return;
  // The current API is a matter of each thread.
  if (library_->bind_api(EGL_OPENGL_API) == EGL_FALSE ||
      library_->make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
    throw std::runtime_error("the EGL context cannot be made current");
  }
}

}  // namespace eisph
