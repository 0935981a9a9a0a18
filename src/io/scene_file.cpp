#include "io/scene_file.hpp"

#include "core/assets.hpp"
#include "io/scene_check.hpp"
#include "io/scene_defaults.hpp"
#include "io/scene_keys.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <utility>

namespace eisph {

namespace {

/// The images that stand in for missing ones depend on the dimension, and may be overridden themselves.
void add_default_images(toml::table& root) {
  if (root.contains("image")) return;
  toml::array images;
  images.push_back(toml::table{{"name", "particles"}});
  if (root["dimension"].value_or(3) == 3)
    images.push_back(toml::table{{"name", "depth"}, {"kind", "depth_map"}});
  root.insert_or_assign("image", std::move(images));
}

TomlKind scene_kind() {
  return {.expected = "a scene file (TOML)",
          .example = "particles.spacing=0.01 or image.0.width=640",
          .complete = add_default_images,
          .first_key = "dimension"};
}

}  // namespace

std::uint64_t available_memory_bytes() {
  std::ifstream stream("/proc/meminfo");
  for (std::string line; std::getline(stream, line);) {
    constexpr std::string_view kLabel = "MemAvailable:";
    if (line.rfind(kLabel, 0) == 0) return std::stoull(line.substr(kLabel.size())) * 1024U;
  }
  return std::numeric_limits<std::uint64_t>::max();
}

Scene load_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                 std::uint64_t available_memory) {
  TomlSource source(file, overrides, scene_kind());
  Scene scene;
  scene.source_file = file.string();
  SectionReader reader{.source = source, .dimension = source.root()["dimension"].value_or(3) == 2 ? 2 : 3};
  scene_keys().read(reader, "", source.root(), scene);
  complete_scene(scene, source);
  check_settings(scene, source);
  check_geometry(scene, source, available_memory);
  return scene;
}

std::string resolved_scene_toml(const Scene& scene) {
  SectionWriter writer{.dimension = scene.dimension, .text = ""};
  scene_keys().write(writer, "", scene);
  return writer.text;
}

std::string scene_schema_text() {
  SchemaWriter writer{.text =
                          "Keys of a scene file (TOML). SI units. A key that is not required takes its "
                          "default when missing.\n"
                          "Solids and water are boxes, upright cylinders or spheres.\n\n[top of the file]\n"};
  scene_keys().describe(writer, "");
  return writer.text;
}

std::vector<std::string> colour_map_names() {
  std::vector<std::string> names = {"grey_depth"};
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(home_folder() / "assets" / "colour_maps", error)) {
    if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace eisph
