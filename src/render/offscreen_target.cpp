#include "render/offscreen_target.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

void allocate_texture(const GlFunctions& gl, const GlTexture& texture, GLint internal_format, GLenum format,
                      GLenum type, int width, int height) {
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, type, nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  }
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  }
}

}  // namespace

OffscreenTarget::OffscreenTarget(const GlFunctions& gl, int width, int height)
    : gl_(gl), width_(width), height_(height), colour_(gl), depth_(gl), framebuffer_(gl) {
  GLint largest = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (width > largest || height > largest) {
    throw std::runtime_error(fmt::format("an image of {} x {} samples is over the {} that the driver draws",
                                         width, height, largest));
  }
  allocate_texture(gl, colour_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
  allocate_texture(gl, depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, width, height);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error(
        fmt::format("the driver provides no framebuffer of {} x {} samples", width, height));
  }
}

void OffscreenTarget::begin(const Colour& background) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, width_, height_);
  gl_.ClearColor(background.red, background.green, background.blue, 1.0F);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Image OffscreenTarget::read() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  Image image(width_, height_);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  // GL's first row is the lowest.
  for (int row = 0; row < height_ / 2; ++row) {
    std::swap_ranges(image.pixel(0, row), image.pixel(0, row) + 3 * static_cast<std::ptrdiff_t>(width_),
                     image.pixel(0, height_ - 1 - row));
  }
  check_gl(gl_, "drawing a frame");
  return image;
}

}  // namespace eisph
