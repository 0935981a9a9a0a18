#pragma once

#include "app/pipeline.hpp"
#include "core/scene.hpp"
#include "probe/depth_grid.hpp"
#include "render/frame_renderer.hpp"

#include <filesystem>

namespace eisph {

/// Draws the frames of a scene. Made, used and destroyed on one thread, which holds the drawing context.
class FrameStage {
 public:
  explicit FrameStage(const Scene& scene);

  /// Draws Scene::images[image]; `curves` are those of its gauges.
  [[nodiscard]] Image draw(const Snapshot& snapshot, std::size_t image,
                           const std::vector<GaugeCurve>& curves = {});

 private:
  [[nodiscard]] bool needs_depth(const ImageSettings& settings) const;

  std::vector<ImageSettings> images_;
  DepthGridBuilder depth_builder_;
  FrameRenderer renderer_;
};

/// Writes a frame into the folder, with its title, scene, time and software in the file.
void write_frame(const std::filesystem::path& folder, const Scene& scene, const Frame& frame);

}  // namespace eisph
