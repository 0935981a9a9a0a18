#pragma once

#include "render/gl_context.hpp"

#include <filesystem>
#include <memory>

namespace eisph {

/// EGL without a display or a surface: on the first graphics card that gives OpenGL 3.3, otherwise in
/// software. The library is opened at run time.
class EglContext final : public GlContext {
 public:
  /// Throws InputError when the library cannot be opened or gives no context.
  explicit EglContext(const std::filesystem::path& library = "libEGL.so.1");
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext() override;

  void make_current() override;
  [[nodiscard]] const GlFunctions& functions() const override { return functions_; }
  [[nodiscard]] ContextKind kind() const override { return ContextKind::Egl; }
  /// Whether the processor does the drawing.
  [[nodiscard]] bool software() const { return software_; }

 private:
  struct Library;

  /// Whether `display` (an EGLDisplay) gives a context; it is then current.
  bool open(void* display);

  std::unique_ptr<Library> library_;
  void* display_ = nullptr;
  void* context_ = nullptr;
  bool software_ = true;
  GlFunctions functions_;
};

}  // namespace eisph
