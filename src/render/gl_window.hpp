#pragma once

#include "render/gl_context.hpp"
#include "render/image.hpp"

#include <string>

struct GLFWwindow;

namespace eisph {

struct WindowSettings {
  int width = 64;   ///< screen units
  int height = 64;  ///< screen units
  std::string title = "eisph";
  bool visible = false;
};

/// A window of the display and its context (GLFW). Windows belong to one thread, the main one where they are
/// shown.
class GlWindow final : public GlContext {
 public:
  /// Throws InputError when there is no display or none that gives OpenGL 3.3.
  explicit GlWindow(const WindowSettings& settings);
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;
  ~GlWindow() override;

  void make_current() override;
  [[nodiscard]] const GlFunctions& functions() const override { return functions_; }
  [[nodiscard]] ContextKind kind() const override { return ContextKind::Window; }

  [[nodiscard]] GLFWwindow* handle() const { return window_; }
  /// Pixels that the window shows now.
  [[nodiscard]] int pixel_width() const;
  [[nodiscard]] int pixel_height() const;
  /// How much larger than on a plain display things have to be drawn, as the display asks: 1, 1.5, 2.
  [[nodiscard]] float scale() const;
  /// Shows what was drawn.
  void present();

 private:
  GLFWwindow* window_ = nullptr;
  GlFunctions functions_;
};

}  // namespace eisph
