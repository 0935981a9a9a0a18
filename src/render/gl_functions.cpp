#include "render/gl_functions.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

GlFunctions load_gl_functions(const std::function<void*(const char*)>& address_of) {
  GlFunctions gl;
#define EISPH_GL_LOAD(name, type)                           \
  gl.name = reinterpret_cast<type>(address_of("gl" #name)); \
  if (gl.name == nullptr) throw std::runtime_error("the OpenGL driver has no function gl" #name);
  EISPH_GL_FUNCTIONS(EISPH_GL_LOAD)
#undef EISPH_GL_LOAD
  return gl;
}

void check_gl(const GlFunctions& gl, const char* where) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return;
  throw std::runtime_error(fmt::format("OpenGL error 0x{:04X} after {}{}", error, where,
                                       error == GL_OUT_OF_MEMORY ? " (out of memory)" : ""));
}

}  // namespace eisph
