#pragma once

#include "app/pipeline.hpp"
#include "core/scene.hpp"
#include "probe/depth_grid.hpp"
#include "render/frame_renderer.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace eisph {

/// Draws the frames of a scene. Made, used and destroyed on one thread, which holds the drawing context.
class FrameStage {
 public:
  /// Throws InputError when `context` cannot be had.
  explicit FrameStage(const Scene& scene, ContextKind context = ContextKind::Automatic);

  /// What draws the particles; empty if no image shows them.
  [[nodiscard]] std::string context_description() const { return renderer_.context_description(); }

  /// Draws Scene::images[image]; `curves` are those of its gauges.
  [[nodiscard]] Image draw(const Snapshot& snapshot, std::size_t image,
                           const std::vector<GaugeCurve>& curves = {});

 private:
  /// Whether it holds for the picture, or for one of the panels.
  [[nodiscard]] bool any_picture(const ImageSettings& settings,
                                 const std::function<bool(const ImageSettings&)>& is) const;

  Scene scene_;
  std::vector<ImageSettings> images_;
  DepthGridBuilder depth_builder_;
  FrameRenderer renderer_;
};

/// Writes a frame into the folder, with its title, scene, time and software in the file.
void write_frame(const std::filesystem::path& folder, const Scene& scene, const Frame& frame);

}  // namespace eisph
