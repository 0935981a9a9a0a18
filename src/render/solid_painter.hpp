#pragma once

#include "core/scene.hpp"
#include "render/camera_view.hpp"
#include "render/gl_object.hpp"
#include "render/shader_program.hpp"
#include "render/solid_mesh.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

namespace eisph {

/// Draws lit surfaces and line segments.
class SolidPainter {
 public:
  SolidPainter(const GlFunctions& gl, const std::filesystem::path& shaders);

  /// From now on nothing outside the box is drawn.
  void set_clip(const std::optional<ClipBox>& clip);
  void draw_surface(const CameraView& camera, const std::vector<SolidMesh::Vertex>& triangles,
                    const Colour& colour) const;
  /// `width` in samples; target size in samples.
  void draw_edges(const CameraView& camera, const std::vector<std::array<Vec3f, 2>>& edges,
                  const Colour& colour, float width, int target_width, int target_height) const;

 private:
  void use_clip(const ShaderProgram& program) const;

  const GlFunctions& gl_;
  std::optional<ClipBox> clip_;
  ShaderProgram surface_program_;
  ShaderProgram edge_program_;
  GlVertexArray surface_array_;
  GlVertexArray edge_array_;
  GlBuffer surface_vertices_;
  GlBuffer edge_vertices_;
};

}  // namespace eisph
