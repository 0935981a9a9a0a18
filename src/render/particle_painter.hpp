#pragma once

#include "core/shape.hpp"
#include "render/camera_view.hpp"
#include "render/colour_map.hpp"
#include "render/gl_object.hpp"
#include "render/offscreen_target.hpp"
#include "render/shader_program.hpp"

#include <filesystem>
#include <vector>

namespace eisph {

/// A particle on its way to the graphics driver.
struct ParticleVertex {
  Vec3f position;  ///< m
  float value;     ///< of the field that colours it
};

/// Draws particles as lit spheres: one point each, whose fragments find the sphere's normal and depth.
class ParticlePainter {
 public:
  ParticlePainter(const GlFunctions& gl, const std::filesystem::path& shaders);

  /// Into the bound `target`; `radius` in metres; `samples_per_pixel` along one axis. Values from `lower` to
  /// `upper` span the map.
  void draw(const OffscreenTarget& target, const CameraView& camera, int samples_per_pixel,
            const std::vector<ParticleVertex>& particles, float radius, const ColourMap& map, double lower,
            double upper) const;

 private:
  const GlFunctions& gl_;
  ShaderProgram program_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_;
  GlTexture colour_map_;
};

}  // namespace eisph
