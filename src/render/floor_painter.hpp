#pragma once

#include "core/scene.hpp"
#include "render/camera_view.hpp"
#include "render/colour.hpp"
#include "render/gl_object.hpp"
#include "render/ground_shadow.hpp"
#include "render/shader_program.hpp"

#include <filesystem>

namespace eisph {

/// Draws the floor of a tank with the shadows on it.
class FloorPainter {
 public:
  FloorPainter(const GlFunctions& gl, const std::filesystem::path& shaders, const Scene& scene);

  void draw(const CameraView& camera, const Colour& colour, const GroundLight& light) const;

 private:
  const GlFunctions& gl_;
  ShaderProgram program_;
  GlVertexArray array_;
  GlBuffer corners_;
  GlTexture light_;
};

/// Draws the walls of a tank as thin panes of glass over what is there, which stays visible and keeps its
/// depth.
class GlassPainter {
 public:
  /// The panes reach up to height `top`, m.
  GlassPainter(const GlFunctions& gl, const std::filesystem::path& shaders, const Scene& scene, double top);

  void draw(const CameraView& camera, const Colour& colour) const;

 private:
  const GlFunctions& gl_;
  ShaderProgram program_;
  GlVertexArray array_;
  GlBuffer corners_;
  GLsizei count_ = 0;
};

}  // namespace eisph
