#include "render/os_mesa_context.hpp"

#include "render/dynamic_library.hpp"
#include "render/renderer_threads.hpp"

#include <cstdlib>
#include <mutex>
#include <stdexcept>

namespace eisph {

namespace {

// From GL/osmesa.h, which cannot be included beside glcorearb.h.
constexpr int kOsMesaFormat = 0x22;
constexpr int kOsMesaDepthBits = 0x30;
constexpr int kOsMesaStencilBits = 0x31;
constexpr int kOsMesaProfile = 0x33;
constexpr int kOsMesaCoreProfile = 0x34;
constexpr int kOsMesaContextMajorVersion = 0x36;
constexpr int kOsMesaContextMinorVersion = 0x37;
constexpr int kRgba = 0x1908;

/// Mesa's set-up of its process-wide state is not safe against itself.
std::mutex& creation_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

struct OsMesaContext::Library {
  DynamicLibrary file;
  void* (*create)(const int*, void*) = nullptr;
  void (*destroy)(void*) = nullptr;
  unsigned char (*make_current)(void*, void*, unsigned, int, int) = nullptr;
  void* (*current)() = nullptr;
  void (*(*address_of)(const char*))() = nullptr;

  explicit Library(const std::filesystem::path& path)
      : file(path, "the software renderer", "install the Debian package libosmesa6") {
    file.find("OSMesaCreateContextAttribs", create);
    file.find("OSMesaDestroyContext", destroy);
    file.find("OSMesaMakeCurrent", make_current);
    file.find("OSMesaGetCurrentContext", current);
    file.find("OSMesaGetProcAddress", address_of);
  }
};

void limit_software_renderer_threads() {
  // One rasteriser thread: the caller waits while it works, so that drawing takes one core.
  setenv("LP_NUM_THREADS", "1", 0);  // NOLINT(concurrency-mt-unsafe)
}

OsMesaContext::OsMesaContext(const std::filesystem::path& library) {
  const std::lock_guard lock(creation_mutex());
  limit_software_renderer_threads();
  library_ = std::make_unique<Library>(library);
  const std::array<int, 15> attributes = {kOsMesaFormat,
                                          kRgba,
                                          kOsMesaDepthBits,
                                          24,
                                          kOsMesaStencilBits,
                                          8,
                                          kOsMesaProfile,
                                          kOsMesaCoreProfile,
                                          kOsMesaContextMajorVersion,
                                          3,
                                          kOsMesaContextMinorVersion,
                                          3,
                                          0,
                                          0,
                                          0};
  context_ = library_->create(attributes.data(), nullptr);
  if (context_ == nullptr) throw std::runtime_error("the software renderer gives no OpenGL 3.3 core context");
  try {
    make_current();
    functions_ = load_gl_functions(
        [this](const char* name) { return reinterpret_cast<void*>(library_->address_of(name)); });
  } catch (...) {
    library_->destroy(context_);
    throw;
  }
}

OsMesaContext::~OsMesaContext() {
  const std::lock_guard lock(creation_mutex());
  if (library_->current() == context_) library_->make_current(nullptr, nullptr, 0, 0, 0);
  library_->destroy(context_);
}

void OsMesaContext::make_current() {
  if (library_->current() == context_) return;
  if (library_->make_current(context_, window_.data(), GL_UNSIGNED_BYTE, kWindowSize, kWindowSize) == 0) {
    throw std::runtime_error("the software renderer's context cannot be made current");
  }
}

}  // namespace eisph
