#include "render/floor_painter.hpp"

#include "render/solid_mesh.hpp"

#include <array>

namespace eisph {

namespace {

void upload_positions(const GlFunctions& gl, const GlVertexArray& array, const GlBuffer& buffer,
                      const std::vector<SolidMesh::Vertex>& vertices) {
  gl.BindVertexArray(array.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(SolidMesh::Vertex)),
                vertices.data(), GL_STREAM_DRAW);
  for (const GLuint k : {0U, 1U}) {
    gl.EnableVertexAttribArray(k);
    gl.VertexAttribPointer(k, 3, GL_FLOAT, GL_FALSE, sizeof(SolidMesh::Vertex),
                           reinterpret_cast<const void*>(k * sizeof(Vec3f)));
  }
}

}  // namespace

FloorPainter::FloorPainter(const GlFunctions& gl, const std::filesystem::path& shaders, const Scene& scene)
    : gl_(gl), program_(gl, shaders, "solid", "floor"), array_(gl), corners_(gl), light_(gl) {
  SolidMesh floor;
  add_floor(floor, scene.domain_min.x(), scene.domain_max.x(), scene.domain_min.y(), scene.domain_max.y(),
            scene.domain_min.z());
  upload_positions(gl, array_, corners_, floor.triangles);
  gl.BindTexture(GL_TEXTURE_2D, light_.name());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  program_.use();
  program_.set("lower", static_cast<float>(scene.domain_min.x()), static_cast<float>(scene.domain_min.y()));
  program_.set("upper", static_cast<float>(scene.domain_max.x()), static_cast<float>(scene.domain_max.y()));
}

void FloorPainter::draw(const CameraView& camera, const Colour& colour, const GroundLight& light) const {
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, light_.name());
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, light.columns, light.rows, 0, GL_RED, GL_FLOAT,
                 light.light.data());
  program_.use();
  program_.set("view", camera.view());
  program_.set("projection", camera.projection());
  program_.set("colour", colour);
  program_.set("ground_light", 0);
  gl_.BindVertexArray(array_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, 6);
}

GlassPainter::GlassPainter(const GlFunctions& gl, const std::filesystem::path& shaders, const Scene& scene,
                           double top)
    : gl_(gl), program_(gl, shaders, "solid", "glass"), array_(gl), corners_(gl) {
  const SolidMesh panes = wall_panes(scene, top);
  upload_positions(gl, array_, corners_, panes.triangles);
  count_ = static_cast<GLsizei>(panes.triangles.size());
}

void GlassPainter::draw(const CameraView& camera, const Colour& colour) const {
  if (count_ == 0) return;
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthMask(GL_FALSE);
  program_.use();
  program_.set("view", camera.view());
  program_.set("projection", camera.projection());
  program_.set("colour", colour);
  gl_.BindVertexArray(array_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, count_);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
}

}  // namespace eisph
