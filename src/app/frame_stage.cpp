#include "app/frame_stage.hpp"

#include "app/build_info.hpp"
#include "render/png_file.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace eisph {

FrameStage::FrameStage(const Scene& scene, ContextKind context)
    : images_(scene.images), depth_builder_(scene), renderer_(scene, {.context = context}) {}

bool FrameStage::needs_depth(const ImageSettings& settings) const {
  if (settings.kind != ImageKind::Panels)
    return settings.kind == ImageKind::DepthMap || settings.field == "depth";
  return std::any_of(images_.begin(), images_.end(), [&](const ImageSettings& image) {
    return image.kind != ImageKind::Panels &&
           std::count(settings.panels.begin(), settings.panels.end(), image.name) > 0 && needs_depth(image);
  });
}

Image FrameStage::draw(const Snapshot& snapshot, std::size_t image, const std::vector<GaugeCurve>& curves) {
  const ImageSettings& settings = images_.at(image);
  const DepthGrid depth = needs_depth(settings) ? depth_builder_.build(snapshot) : DepthGrid{};
  return renderer_.draw(settings, snapshot, depth, curves);
}

void write_frame(const std::filesystem::path& folder, const Scene& scene, const Frame& frame) {
  write_png(folder / frame.file_name, frame.image,
            {{"Title", scene.title},
             {"Scene", scene.name},
             {"Time", fmt::format("{:.9g} s", frame.time)},
             {"Software", software_name()}});
}

}  // namespace eisph
