#include "render/float_target.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

void allocate(const GlFunctions& gl, const GlTexture& texture, GLint internal_format, GLenum format,
              GLenum type, int width, int height, GLint filter) {
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, type, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

FloatTarget::FloatTarget(const GlFunctions& gl, int width, int height, int channels, Depth depth,
                         GLint filter)
    : gl_(gl), width_(width), height_(height), texture_(gl), framebuffer_(gl) {
  gl.ActiveTexture(GL_TEXTURE0);
  allocate(gl, texture_, channels == 2 ? GL_RG32F : GL_R32F, channels == 2 ? GL_RG : GL_RED, GL_FLOAT, width,
           height, filter);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  if (depth == Depth::Buffer) {
    depth_.emplace(gl);
    allocate(gl, *depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, width, height,
             GL_NEAREST);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_->name(), 0);
  }
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error(
        fmt::format("the driver provides no framebuffer of {} x {} floating-point samples", width, height));
  }
}

void FloatTarget::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, width_, height_);
}

void FloatTarget::begin() const {
  bind();
  gl_.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_.Clear(depth_ ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT);
}

}  // namespace eisph
