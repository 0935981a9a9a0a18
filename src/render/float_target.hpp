#pragma once

#include "render/gl_object.hpp"

#include <optional>

namespace eisph {

/// Framebuffer in memory of one or two 32-bit floats per sample, for passes that feed others.
class FloatTarget {
 public:
  enum class Depth { None, Buffer };

  /// Size in samples. Throws std::runtime_error when the driver cannot provide it.
  FloatTarget(const GlFunctions& gl, int width, int height, int channels, Depth depth, GLint filter);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const GlTexture& texture() const { return texture_; }

  /// Directs drawing here.
  void bind() const;
  /// Directs drawing here and clears to zero.
  void begin() const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture texture_;
  std::optional<GlTexture> depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace eisph
