#include "app/frame_stage.hpp"

#include "app/build_info.hpp"
#include "boundary/boundary_particles.hpp"
#include "render/png_file.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace eisph {

FrameStage::FrameStage(const Scene& scene, ContextKind context)
    : scene_(scene), images_(scene.images), depth_builder_(scene), renderer_(scene, {.context = context}) {}

bool FrameStage::any_picture(const ImageSettings& settings,
                             const std::function<bool(const ImageSettings&)>& is) const {
  if (settings.kind != ImageKind::Panels) return is(settings);
  return std::any_of(images_.begin(), images_.end(), [&](const ImageSettings& image) {
    return image.kind != ImageKind::Panels &&
           std::count(settings.panels.begin(), settings.panels.end(), image.name) > 0 && is(image);
  });
}

Image FrameStage::draw(const Snapshot& snapshot, std::size_t image, const std::vector<GaugeCurve>& curves) {
  const ImageSettings& settings = images_.at(image);
  const bool needs_depth = any_picture(settings, [](const ImageSettings& picture) {
    return picture.kind == ImageKind::DepthMap || picture.field == "depth";
  });
  const bool ghosts = any_picture(settings, [](const ImageSettings& picture) { return picture.draw_ghosts; });
  const bool virtuals =
      any_picture(settings, [](const ImageSettings& picture) { return picture.draw_virtual_particles; });
  const DepthGrid depth = needs_depth ? depth_builder_.build(snapshot) : DepthGrid{};
  return renderer_.draw(settings, snapshot, depth, curves,
                        boundary_particles(scene_, snapshot, ghosts, virtuals));
}

void write_frame(const std::filesystem::path& folder, const Scene& scene, const Frame& frame) {
  write_png(folder / frame.file_name, frame.image,
            {{"Title", scene.title},
             {"Scene", scene.name},
             {"Time", fmt::format("{:.9g} s", frame.time)},
             {"Software", software_name()}});
}

}  // namespace eisph
