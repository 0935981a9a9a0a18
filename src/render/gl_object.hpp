#pragma once

#include "render/gl_functions.hpp"

#include <utility>

namespace eisph {

/// Owner of one GL name. The context must be current when it is made and when it goes.
template <auto Generate, auto Delete>
class GlObject {
 public:
  explicit GlObject(const GlFunctions& gl) : gl_(&gl) { (gl.*Generate)(1, &name_); }
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject() {
    if (name_ != 0) (gl_->*Delete)(1, &name_);
  }
  [[nodiscard]] GLuint name() const { return name_; }

 private:
  const GlFunctions* gl_;
  GLuint name_ = 0;
};

using GlBuffer = GlObject<&GlFunctions::GenBuffers, &GlFunctions::DeleteBuffers>;
using GlVertexArray = GlObject<&GlFunctions::GenVertexArrays, &GlFunctions::DeleteVertexArrays>;
using GlTexture = GlObject<&GlFunctions::GenTextures, &GlFunctions::DeleteTextures>;
using GlFramebuffer = GlObject<&GlFunctions::GenFramebuffers, &GlFunctions::DeleteFramebuffers>;

}  // namespace eisph
