#pragma once

#include "render/colour.hpp"
#include "render/gl_object.hpp"
#include "render/image.hpp"

namespace eisph {

/// Framebuffer in memory with a colour and a depth texture.
class OffscreenTarget {
 public:
  /// Size in pixels. Throws std::runtime_error when the driver cannot provide it.
  OffscreenTarget(const GlFunctions& gl, int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const GlTexture& colour() const { return colour_; }
  [[nodiscard]] const GlTexture& depth() const { return depth_; }
  [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }

  /// Directs drawing here and clears.
  void begin(const Colour& background) const;
  /// What was drawn; waits for it.
  [[nodiscard]] Image read() const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture colour_;
  GlTexture depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace eisph
