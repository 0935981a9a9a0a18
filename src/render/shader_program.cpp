#include "render/shader_program.hpp"

#include "core/error.hpp"

#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace eisph {

namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: the shader cannot be read", path.string()));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Shader {
 public:
  Shader(const GlFunctions& gl, GLenum type, const std::filesystem::path& path)
      : gl_(gl), name_(gl.CreateShader(type)) {
    try {
      compile(path);
    } catch (...) {
      gl_.DeleteShader(name_);
      throw;
    }
  }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  ~Shader() { gl_.DeleteShader(name_); }
  [[nodiscard]] GLuint name() const { return name_; }

 private:
  void compile(const std::filesystem::path& path) const {
    const std::string source = read_text(path);
    const char* text = source.c_str();
    gl_.ShaderSource(name_, 1, &text, nullptr);
    gl_.CompileShader(name_);
    GLint compiled = 0;
    gl_.GetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
    if (compiled != 0) return;
    GLint length = 0;
    gl_.GetShaderiv(name_, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl_.GetShaderInfoLog(name_, length, nullptr, log.data());
    throw InputError(fmt::format("{}: the shader does not compile:\n{}", path.string(), log.c_str()));
  }

  const GlFunctions& gl_;
  GLuint name_;
};

}  // namespace

ShaderProgram::ShaderProgram(const GlFunctions& gl, const std::filesystem::path& folder,
                             const std::string& vertex_name, const std::string& fragment_name)
    : gl_(gl) {
  const Shader vertex(gl, GL_VERTEX_SHADER, folder / (vertex_name + ".vert"));
  const Shader fragment(gl, GL_FRAGMENT_SHADER, folder / (fragment_name + ".frag"));
  program_ = gl.CreateProgram();
  gl.AttachShader(program_, vertex.name());
  gl.AttachShader(program_, fragment.name());
  gl.LinkProgram(program_);
  GLint linked = 0;
  gl.GetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked != 0) return;
  GLint length = 0;
  gl.GetProgramiv(program_, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  gl.GetProgramInfoLog(program_, length, nullptr, log.data());
  gl.DeleteProgram(program_);
  throw InputError(fmt::format("{}: {}.vert and {}.frag do not link:\n{}", folder.string(), vertex_name,
                               fragment_name, log.c_str()));
}

ShaderProgram::~ShaderProgram() { gl_.DeleteProgram(program_); }

}  // namespace eisph
