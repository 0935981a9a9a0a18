#include "render/solid_painter.hpp"

#include <cstddef>

namespace eisph {

namespace {

template <class Element>
void upload(const GlFunctions& gl, const GlBuffer& buffer, const std::vector<Element>& elements) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(),
                GL_STREAM_DRAW);
}

/// Two vectors side by side as attributes 0 and 1 of the bound vertex array.
void describe_two_vectors(const GlFunctions& gl, const GlBuffer& buffer) {
  static_assert(sizeof(SolidMesh::Vertex) == 2 * sizeof(Vec3f) && sizeof(Vec3f) == 3 * sizeof(float));
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
  for (const GLuint k : {0U, 1U}) {
    gl.EnableVertexAttribArray(k);
    gl.VertexAttribPointer(k, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(Vec3f),
                           reinterpret_cast<const void*>(k * sizeof(Vec3f)));
  }
}

}  // namespace

SolidPainter::SolidPainter(const GlFunctions& gl, const std::filesystem::path& shaders)
    : gl_(gl),
      surface_program_(gl, shaders, "solid"),
      edge_program_(gl, shaders, "edge"),
      surface_array_(gl),
      edge_array_(gl),
      surface_vertices_(gl),
      edge_vertices_(gl) {
  gl.BindVertexArray(surface_array_.name());
  describe_two_vectors(gl, surface_vertices_);
  gl.BindVertexArray(edge_array_.name());
  describe_two_vectors(gl, edge_vertices_);
  gl.VertexAttribDivisor(0, 1);
  gl.VertexAttribDivisor(1, 1);
}

void SolidPainter::set_clip(const std::optional<ClipBox>& clip) { clip_ = clip; }

void SolidPainter::use_clip(const ShaderProgram& program) const {
  constexpr float kEverywhere = 1e30F;
  const Vec3f lower = clip_ ? Vec3f(clip_->min.cast<float>()) : Vec3f::Constant(-kEverywhere);
  const Vec3f upper = clip_ ? Vec3f(clip_->max.cast<float>()) : Vec3f::Constant(kEverywhere);
  program.set("clip_min", lower);
  program.set("clip_max", upper);
}

void SolidPainter::draw_surface(const CameraView& camera, const std::vector<SolidMesh::Vertex>& triangles,
                                const Colour& colour) const {
  if (triangles.empty()) return;
  upload(gl_, surface_vertices_, triangles);
  surface_program_.use();
  surface_program_.set("view", camera.view());
  surface_program_.set("projection", camera.projection());
  surface_program_.set("colour", colour);
  use_clip(surface_program_);
  gl_.BindVertexArray(surface_array_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
}

void SolidPainter::draw_edges(const CameraView& camera, const std::vector<std::array<Vec3f, 2>>& edges,
                              const Colour& colour, float width, int target_width, int target_height) const {
  if (edges.empty()) return;
  upload(gl_, edge_vertices_, edges);
  edge_program_.use();
  edge_program_.set("view", camera.view());
  edge_program_.set("projection", camera.projection());
  edge_program_.set("colour", colour);
  use_clip(edge_program_);
  edge_program_.set("width", width);
  edge_program_.set("size", static_cast<float>(target_width), static_cast<float>(target_height));
  gl_.BindVertexArray(edge_array_.name());
  gl_.DrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(edges.size()));
}

}  // namespace eisph
