#include "render/particle_painter.hpp"

#include "render/point_margin.hpp"

#include <cstddef>

namespace eisph {

static_assert(sizeof(ParticleVertex) == 4 * sizeof(float));

ParticlePainter::ParticlePainter(const GlFunctions& gl, const std::filesystem::path& shaders)
    : gl_(gl), program_(gl, shaders, "particle"), vertex_array_(gl), vertices_(gl), colour_map_(gl) {
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ParticleVertex), nullptr);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, sizeof(ParticleVertex),
                         reinterpret_cast<const void*>(offsetof(ParticleVertex, value)));
  gl.BindTexture(GL_TEXTURE_2D, colour_map_.name());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void ParticlePainter::draw(const OffscreenTarget& target, const CameraView& camera, int samples_per_pixel,
                           const std::vector<ParticleVertex>& particles, float radius, const ColourMap& map,
                           double lower, double upper) const {
  if (particles.empty()) return;
  static_assert(sizeof(Colour) == 3 * sizeof(float));
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, colour_map_.name());
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, ColourMap::kSize, 1, 0, GL_RGB, GL_FLOAT, map.table().data());
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(particles.size() * sizeof(ParticleVertex)),
                 particles.data(), GL_STREAM_DRAW);
  program_.use();
  program_.set("view", camera.view());
  program_.set("projection", camera.projection());
  program_.set("radius", radius);
  program_.set("focal_length", static_cast<float>(camera.focal_length() * samples_per_pixel));
  program_.set("lower", static_cast<float>(lower));
  program_.set("upper", static_cast<float>(upper));
  program_.set("colour_map", 0);
  const PointMargin margin(gl_, program_, target.width(), target.height());
  gl_.BindVertexArray(vertex_array_.name());
  gl_.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(particles.size()));
}

}  // namespace eisph
