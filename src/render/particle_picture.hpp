#pragma once

#include "core/boundary_particles.hpp"
#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "render/camera_view.hpp"
#include "render/colour_map.hpp"
#include "render/field.hpp"
#include "render/floor_painter.hpp"
#include "render/fluid_surface.hpp"
#include "render/gl_context.hpp"
#include "render/image.hpp"
#include "render/offscreen_target.hpp"
#include "render/palette.hpp"
#include "render/particle_painter.hpp"
#include "render/render_options.hpp"
#include "render/solid_painter.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// The part of a frame that shows particles, walls and solids.
class ParticlePicture {
 public:
  ParticlePicture(const Scene& scene, std::shared_ptr<GlContext> context,
                  const ParticlePictureOptions& options);
  ParticlePicture(const ParticlePicture&) = delete;
  ParticlePicture& operator=(const ParticlePicture&) = delete;
  ~ParticlePicture();

  /// Draws width x height pixels as `camera` sees the state. `map` spans the scale. The texture holds the
  /// picture until the next one is drawn; its first row is the lowest.
  const GlTexture& paint(const ImageSettings& settings, const CameraView& camera, int width, int height,
                         const Snapshot& snapshot, const DepthGrid& depth, const BoundaryParticles& boundary,
                         const ColourMap& map, const FieldScale& scale);
  /// The picture that paint() drew last.
  [[nodiscard]] Image read() const;

  [[nodiscard]] std::string context_description() const;

  /// Spacing of the lines on the floor, m.
  [[nodiscard]] double grid_spacing() const { return grid_spacing_; }

 private:
  void draw_floor(const ImageSettings& settings, const CameraView& camera, const Palette& colours,
                  const Snapshot& snapshot);
  void draw_walls(const ImageSettings& settings, const CameraView& camera, const Palette& colours);
  void draw_wall_edges(const CameraView& camera, const Palette& colours) const;
  void draw_solids(const CameraView& camera, const Palette& colours, double time) const;
  void draw_particles(const ImageSettings& settings, const CameraView& camera, const Snapshot& snapshot,
                      const DepthGrid& depth, const ColourMap& map, const FieldScale& scale) const;
  void draw_other_particles(const ImageSettings& settings, const CameraView& camera, const Snapshot& snapshot,
                            const BoundaryParticles& boundary) const;
  [[nodiscard]] std::vector<std::uint32_t> particles_seen(const ImageSettings& settings,
                                                          const CameraView& camera,
                                                          const Snapshot& snapshot) const;
  /// Draws the water over what is in samples_; the picture with it.
  const OffscreenTarget& draw_surface(const ImageSettings& settings, const CameraView& camera,
                                      const Snapshot& snapshot, const DepthGrid& depth, const ColourMap& map,
                                      const FieldScale& scale);
  /// `shading` is the strength of the darkening behind edges.
  void resolve(const OffscreenTarget& samples, float shading, const CameraView& camera,
               const Palette& colours, int width, int height);

  Scene scene_;
  std::shared_ptr<GlContext> context_;
  ParticlePictureOptions options_;
  double grid_spacing_;
  SolidMesh obstacles_;
  ParticlePainter particle_painter_;
  SolidPainter solid_painter_;
  ShaderProgram resolve_program_;
  GlVertexArray resolve_array_;
  // Made when first asked for.
  std::optional<FluidSurface> fluid_surface_;
  std::optional<FloorPainter> floor_painter_;
  std::optional<GlassPainter> glass_painter_;
  std::optional<OffscreenTarget> samples_;
  std::optional<OffscreenTarget> pixels_;
};

}  // namespace eisph
