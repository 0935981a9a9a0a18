#pragma once

#include "render/gl_functions.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace eisph {

/// Where a drawing context comes from.
enum class ContextKind {
  Automatic,  ///< EGL on a graphics card if there is one, else OSMesa, else EGL in software
  OsMesa,     ///< Mesa's software renderer, in memory
  Egl,        ///< without a display, on a graphics card or in software
  Window,     ///< of a display
};

/// auto, osmesa, egl or window.
[[nodiscard]] std::string_view context_name(ContextKind kind);
/// Throws InputError with the names for any other one.
[[nodiscard]] ContextKind context_kind(std::string_view name);

/// An OpenGL 3.3 core context, wherever it comes from. Used by the thread that made it.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;

  virtual void make_current() = 0;
  [[nodiscard]] virtual const GlFunctions& functions() const = 0;
  [[nodiscard]] virtual ContextKind kind() const = 0;

  /// Kind, driver and version, for logs. The context has to be current.
  [[nodiscard]] std::string description() const;
};

/// A context to draw frames with; that of a window is one that is never shown. Throws InputError, naming the
/// Debian package, when what `kind` needs is missing.
[[nodiscard]] std::unique_ptr<GlContext> create_context(ContextKind kind);

}  // namespace eisph
