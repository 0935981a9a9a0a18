#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace eisph {

/// The names of the files of one run. Numbers count from 0 in the order of time.
struct RunFiles {
  std::filesystem::path folder;

  [[nodiscard]] std::filesystem::path scene() const { return folder / "scene.toml"; }
  [[nodiscard]] std::filesystem::path summary() const { return folder / "run.json"; }
  [[nodiscard]] std::filesystem::path log() const { return folder / "run.log"; }
  [[nodiscard]] std::filesystem::path frames() const { return folder / "frames"; }
  [[nodiscard]] std::filesystem::path rendered() const { return folder / "rendered"; }
  [[nodiscard]] std::filesystem::path video() const { return folder / "video"; }
  [[nodiscard]] std::filesystem::path particles_collection() const { return folder / "particles.pvd"; }
  [[nodiscard]] std::filesystem::path objects_collection() const { return folder / "objects.pvd"; }
  [[nodiscard]] std::filesystem::path depth_collection() const { return folder / "depth.pvd"; }
  [[nodiscard]] std::filesystem::path particles(std::size_t index) const;
  [[nodiscard]] std::filesystem::path objects(std::size_t index) const;
  [[nodiscard]] std::filesystem::path depth(std::size_t index) const;
};

/// "<image>_0007.png"
[[nodiscard]] std::string frame_file_name(const std::string& image_name, std::size_t index);

/// Throws InputError unless a run of the scene may be written to the folder: it does not exist, is empty, or
/// holds an earlier run of the same scene. Changes nothing.
void check_run_folder(const RunFiles& files, const std::string& scene_name);

/// Removes the files of an earlier run, and only those, and makes the folder.
void prepare_run_folder(const RunFiles& files);

}  // namespace eisph
