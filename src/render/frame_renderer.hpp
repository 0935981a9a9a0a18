#pragma once

#include "core/boundary_particles.hpp"
#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "render/colour_map.hpp"
#include "render/gauge_plot.hpp"
#include "render/gl_context.hpp"
#include "render/image.hpp"
#include "render/render_options.hpp"
#include "render/renderer_threads.hpp"

#include <memory>
#include <string>
#include <vector>

namespace eisph {

/// Draws frames without a display. Made, used and destroyed on one thread; any number may be at work on
/// different threads. Owns its graphics context.
class FrameRenderer {
 public:
  /// Throws InputError when the graphics context, a shader or the font is missing. The graphics context is
  /// made here if an image of the scene needs it, otherwise when a particle picture is first asked for.
  /// `context` is drawn in instead, if given; it may be shared on its thread.
  explicit FrameRenderer(const Scene& scene, const ParticlePictureOptions& options = {},
                         std::shared_ptr<GlContext> context = nullptr);
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;
  ~FrameRenderer();

  /// One frame: the picture with title, time, colour bar, length scale and caption, or several pictures and
  /// the curves of gauges in one. The settings need not be among the scene's, but pictures that they name as
  /// panels have to be. `curves` are for settings.gauges, in that order. Throws InputError for settings that
  /// cannot be drawn.
  Image draw(const ImageSettings& settings, const Snapshot& snapshot, const DepthGrid& depth,
             const std::vector<GaugeCurve>& curves = {}, const BoundaryParticles& boundary = {});
  /// The particle picture alone, without captions, as the name of a texture whose first row is the lowest. It
  /// holds the picture until the next one is drawn.
  GLuint paint(const ImageSettings& settings, const Snapshot& snapshot, const DepthGrid& depth,
               const BoundaryParticles& boundary, int width, int height);
  /// A table of assets/colour_maps. Throws InputError for an unknown name.
  [[nodiscard]] const ColourMap& colour_map(const std::string& name);

  /// What draws the particles, for logs; empty as long as nothing does.
  [[nodiscard]] std::string context_description() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace eisph
