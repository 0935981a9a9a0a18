#include "render/gl_context.hpp"

#include "core/error.hpp"
#include "render/egl_context.hpp"
#include "render/gl_window.hpp"
#include "render/os_mesa_context.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr std::array<std::pair<std::string_view, ContextKind>, 4> kNames = {
    {{"auto", ContextKind::Automatic},
     {"osmesa", ContextKind::OsMesa},
     {"egl", ContextKind::Egl},
     {"window", ContextKind::Window}}};

std::unique_ptr<GlContext> create_automatic_context() {
  // A software EGL gives the same pictures as OSMesa, which needs less from the system.
  try {
    auto card = std::make_unique<EglContext>();
    if (!card->software()) return card;
  } catch (const InputError&) {  // no EGL
  }
  std::string why;
  try {
    return std::make_unique<OsMesaContext>();
  } catch (const InputError& error) {
    why = error.what();
  }
  try {
    return std::make_unique<EglContext>();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}; {}", why, error.what()));
  }
}

}  // namespace

std::string_view context_name(ContextKind kind) {
  for (const auto& [name, known] : kNames) {
    if (known == kind) return name;
  }
  return "";
}

ContextKind context_kind(std::string_view name) {
  for (const auto& [known, kind] : kNames) {
    if (known == name) return kind;
  }
  throw InputError(fmt::format("--context {}: expected auto, osmesa, egl or window", name));
}

std::string GlContext::description() const {
  const GlFunctions& gl = functions();
  const auto text = [&gl](GLenum name) { return reinterpret_cast<const char*>(gl.GetString(name)); };
  return fmt::format("{}: {}, OpenGL {}", context_name(kind()), text(GL_RENDERER), text(GL_VERSION));
}

std::unique_ptr<GlContext> create_context(ContextKind kind) {
  switch (kind) {
    case ContextKind::OsMesa:
      return std::make_unique<OsMesaContext>();
    case ContextKind::Egl:
      return std::make_unique<EglContext>();
    case ContextKind::Window:
      return std::make_unique<GlWindow>(WindowSettings{});
    case ContextKind::Automatic:
      break;
  }
  return create_automatic_context();
}

}  // namespace eisph
