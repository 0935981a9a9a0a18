#pragma once

#include "render/gl_functions.hpp"

#include <memory>
#include <string>

namespace eisph {

/// An OpenGL 3.3 core context, wherever it comes from. Used by the thread that made it.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;

  virtual void make_current() = 0;
  [[nodiscard]] virtual const GlFunctions& functions() const = 0;
  /// Driver and version, for logs.
  [[nodiscard]] virtual std::string description() const = 0;
};

/// A context that draws in memory, without a display. Throws InputError when the library is missing.
[[nodiscard]] std::unique_ptr<GlContext> create_offscreen_context();

}  // namespace eisph
