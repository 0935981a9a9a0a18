#pragma once

#include "render/colour.hpp"
#include "render/gl_functions.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace eisph {

/// A linked program of a vertex and a fragment shader (GLSL 330 core).
class ShaderProgram {
 public:
  /// Reads <name>.vert and <name>.frag from `folder`. Throws InputError when a file is missing, does not
  /// compile or link; the message has the file name and the driver's log.
  ShaderProgram(const GlFunctions& gl, const std::filesystem::path& folder, const std::string& name)
      : ShaderProgram(gl, folder, name, name) {}
  /// Two shaders of different names.
  ShaderProgram(const GlFunctions& gl, const std::filesystem::path& folder, const std::string& vertex_name,
                const std::string& fragment_name);
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;
  ~ShaderProgram();

  void use() const { gl_.UseProgram(program_); }
  // Uniforms of the program in use.
  void set(const char* name, int value) const { gl_.Uniform1i(location(name), value); }
  void set(const char* name, float value) const { gl_.Uniform1f(location(name), value); }
  void set(const char* name, float x, float y) const { gl_.Uniform2f(location(name), x, y); }
  void set(const char* name, const Colour& value) const {
    gl_.Uniform3f(location(name), value.red, value.green, value.blue);
  }
  void set(const char* name, const Eigen::Vector3f& value) const {
    gl_.Uniform3f(location(name), value.x(), value.y(), value.z());
  }
  void set(const char* name, const Eigen::Matrix4f& value) const {
    gl_.UniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
  }

 private:
  [[nodiscard]] GLint location(const char* name) const { return gl_.GetUniformLocation(program_, name); }

  const GlFunctions& gl_;
  GLuint program_ = 0;
};

}  // namespace eisph
