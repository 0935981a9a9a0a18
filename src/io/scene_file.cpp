#include "io/scene_file.hpp"

#include "core/assets.hpp"
#include "io/scene_check.hpp"
#include "io/scene_defaults.hpp"
#include "io/scene_keys.hpp"

#include <algorithm>
#include <fstream>
#include <limits>

namespace eisph {

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
  SceneSource source(file, overrides);
  Scene scene;
  scene.source_file = file.string();
  SceneReader reader{.source = source, .dimension = source.root()["dimension"].value_or(3) == 2 ? 2 : 3};
  scene_keys().read(reader, "", source.root(), scene);
  complete_scene(scene, source);
  check_settings(scene, source);
  check_geometry(scene, source, available_memory);
  return scene;
}

std::string resolved_scene_toml(const Scene& scene) {
  SceneWriter writer{.dimension = scene.dimension, .text = ""};
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
