#include "app/frame_stage.hpp"

#include "app/build_info.hpp"
#include "render/png_file.hpp"

#include <fmt/format.h>

namespace eisph {

FrameStage::FrameStage(const Scene& scene, ContextKind context)
    : images_(scene.images), depth_builder_(scene), renderer_(scene, {.context = context}) {}

Image FrameStage::draw(const Snapshot& snapshot, std::size_t image) {
  const ImageSettings& settings = images_.at(image);
  const bool needs_depth = settings.kind == ImageKind::DepthMap || settings.field == "depth";
  const DepthGrid depth = needs_depth ? depth_builder_.build(snapshot) : DepthGrid{};
  return renderer_.draw(settings, snapshot, depth);
}

void write_frame(const std::filesystem::path& folder, const Scene& scene, const Frame& frame) {
  write_png(folder / frame.file_name, frame.image,
            {{"Title", scene.title},
             {"Scene", scene.name},
             {"Time", fmt::format("{:.9g} s", frame.time)},
             {"Software", software_name()}});
}

}  // namespace eisph
