#pragma once

#include "render/gl_functions.hpp"
#include "render/shader_program.hpp"

#include <algorithm>
#include <array>

namespace eisph {

/// Draws points beyond the borders of the target as well while it lives, so that those of which only a part
/// reaches into the target are not left out: OpenGL clips a point by its centre. The vertex shader multiplies
/// x and y of its position by `margin`, which takes them back to where they were.
class PointMargin {
 public:
  /// The target is bound and has `width` x `height` samples; `program` is in use.
  PointMargin(const GlFunctions& gl, const ShaderProgram& program, int width, int height)
      : gl_(gl), width_(width), height_(height) {
    std::array<GLint, 2> largest{};
    gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, largest.data());
    // Points larger than the target are of particles just before the eye.
    const int room = std::min(largest[0] - width, largest[1] - height) / 2;
    const int margin = std::clamp(std::max(width, height) / 2, 0, std::max(room, 0));
    gl_.Viewport(-margin, -margin, width + 2 * margin, height + 2 * margin);
    program.set("margin", static_cast<float>(width) / static_cast<float>(width + 2 * margin),
                static_cast<float>(height) / static_cast<float>(height + 2 * margin));
  }
  PointMargin(const PointMargin&) = delete;
  PointMargin& operator=(const PointMargin&) = delete;
  ~PointMargin() { gl_.Viewport(0, 0, width_, height_); }

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
};

}  // namespace eisph
