#include "app/run_files.hpp"

#include "core/error.hpp"
#include "io/scene_file.hpp"

#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <regex>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace eisph {
namespace {

namespace fs = std::filesystem;

/// The name of the scene that a folder holds a run of; nothing if it holds none.
std::optional<std::string> recorded_scene_name(const RunFiles& files) {
  if (fs::is_regular_file(files.summary())) {
    std::ifstream stream(files.summary());
    const auto summary = nlohmann::json::parse(stream, nullptr, false);
    if (summary.is_object() && summary.contains("scene") && summary["scene"].is_string()) {
      return summary["scene"].get<std::string>();
    }
  }
  if (!fs::is_regular_file(files.scene())) return std::nullopt;
  try {
    return load_scene(files.scene(), {}, std::numeric_limits<std::uint64_t>::max()).name;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Names of files that a run writes, by the folder they are in. A file is written under a name with an ending
/// added first.
const std::map<std::string, std::regex>& written_names() {
  static const std::string ending = R"((\.tmp|\.part)?)";
  static const std::map<std::string, std::regex> names = {
      {"", std::regex(R"((scene\.toml|run\.json|run\.log|(particles|objects|depth)\.pvd|)"
                      R"((gauge|probe|pressure_sensor|front|line|force|discharge)_.+\.csv|)"
                      R"((leading_edge|ledger)\.csv))" +
                      ending)},
      {"frames", std::regex(R"(.+_\d{4,}\.png)" + ending)},
      {"particles", std::regex(R"((particles|objects)_\d{4,}\.vtp)" + ending)},
      {"rendered", std::regex(R"(.+_(\d{4,}|t[-+.e\d]+)\.png)" + ending)},
      {"video", std::regex(R"(.+\.mp4)" + ending)},
      {"depth", std::regex(R"(depth_\d{4,}\.vti)" + ending)},
  };
  return names;
}

void remove_written_files(const fs::path& folder, const std::regex& names) {
  if (!fs::is_directory(folder)) return;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const bool file = entry.is_regular_file() || entry.is_symlink();
    if (file && std::regex_match(entry.path().filename().string(), names)) found.push_back(entry.path());
  }
  for (const fs::path& file : found) fs::remove(file);
}

}  // namespace

fs::path RunFiles::particles(std::size_t index) const {
  return folder / "particles" / fmt::format("particles_{:04}.vtp", index);
}

fs::path RunFiles::objects(std::size_t index) const {
  return folder / "particles" / fmt::format("objects_{:04}.vtp", index);
}

fs::path RunFiles::depth(std::size_t index) const {
  return folder / "depth" / fmt::format("depth_{:04}.vti", index);
}

std::string frame_file_name(const std::string& image_name, std::size_t index) {
  return fmt::format("{}_{:04}.png", image_name, index);
}

void check_run_folder(const RunFiles& files, const std::string& scene_name) {
  const fs::path& folder = files.folder;
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) {
    throw InputError(fmt::format("{}: is a file; the output of a run needs a folder", folder.string()));
  }
  if (fs::is_empty(folder)) return;
  const auto recorded = recorded_scene_name(files);
  if (!recorded) {
    throw InputError(
        fmt::format("{}: is not empty and holds no run of eisph (no readable run.json or scene.toml); "
                    "choose another folder with --out",
                    folder.string()));
  }
  if (*recorded != scene_name) {
    throw InputError(
        fmt::format("{}: holds a run of the scene \"{}\", not of \"{}\"; choose another folder with --out",
                    folder.string(), *recorded, scene_name));
  }
}

void prepare_run_folder(const RunFiles& files) {
  fs::create_directories(files.folder);
  for (const auto& [subfolder, names] : written_names()) {
    const fs::path folder = files.folder / subfolder;
    remove_written_files(folder, names);
    // A folder that is empty now held nothing but files of the earlier run.
    if (!subfolder.empty() && fs::is_directory(folder) && fs::is_empty(folder)) fs::remove(folder);
  }
}

}  // namespace eisph
