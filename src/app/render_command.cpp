#include "app/commands.hpp"
#include "app/frame_stage.hpp"
#include "app/gauge_history.hpp"
#include "app/output_plan.hpp"
#include "app/run_files.hpp"
#include "app/saved_states.hpp"
#include "core/error.hpp"
#include "io/file_io.hpp"
#include "io/scene_file.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace eisph {
namespace {

/// Places in Scene::images of the images asked for.
std::vector<std::size_t> chosen_images(const Scene& scene, const std::vector<std::string>& names) {
  std::string available;
  for (const ImageSettings& image : scene.images) available += (available.empty() ? "" : ", ") + image.name;
  for (const std::string& name : names) {
    const bool known = std::any_of(scene.images.begin(), scene.images.end(),
                                   [&name](const ImageSettings& image) { return image.name == name; });
    if (!known)
      throw InputError(fmt::format("--image {}: the scene has no such image; it has {}", name, available));
  }
  std::vector<std::size_t> chosen;
  for (std::size_t image = 0; image < scene.images.size(); ++image) {
    const bool wanted = names.empty() || std::count(names.begin(), names.end(), scene.images[image].name) > 0;
    if (wanted) chosen.push_back(image);
  }
  return chosen;
}

/// The name that the run gave, or would have given, to its frame of that time; else one with the time.
std::string file_name(const ImageSettings& image, double time) {
  if (image.schedule.is_due(time, OutputPlan::kTolerance)) {
    return frame_file_name(image.name, count_due(image.schedule, time) - 1);
  }
  return fmt::format("{}_t{:.6g}.png", image.name, time);
}

}  // namespace

int render_command(const RenderOptions& options, std::ostream& out) {
  const RunFiles files{options.run_folder};
  if (!std::filesystem::is_regular_file(files.scene())) {
    throw InputError(
        fmt::format("{}: is not the folder of a run: it has no scene.toml", options.run_folder.string()));
  }
  // Drawing needs far less memory than the simulation that the scene describes.
  const Scene scene = load_scene(files.scene(), options.overrides, std::numeric_limits<std::uint64_t>::max());
  const std::vector<std::size_t> images = chosen_images(scene, options.images);
  const std::vector<SavedState> states = select_states(saved_states(files), options.times);
  const std::filesystem::path folder = options.out.value_or(files.rendered());
  FrameStage stage(scene, context_kind(options.context));
  create_folder(folder);

  std::size_t written = 0;
  for (const SavedState& state : states) {
    const Snapshot snapshot = read_state(state);
    for (const std::size_t image : images) {
      const std::string name = file_name(scene.images[image], snapshot.time);
      const std::vector<GaugeCurve> curves = read_gauge_curves(files, scene.images[image].gauges);
      write_frame(folder, scene, {name, snapshot.time, stage.draw(snapshot, image, curves)});
      ++written;
    }
  }
  const std::string context = stage.context_description();
  fmt::print(out, "{} frames in {}{}\n", written, folder.string(),
             context.empty() ? "" : fmt::format(", drawn by {}", context));
  return kSuccess;
}

}  // namespace eisph
