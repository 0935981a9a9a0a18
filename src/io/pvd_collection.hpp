#pragma once

#include <filesystem>
#include <vector>

namespace eisph {

/// A file of a time series.
struct PvdEntry {
  double time = 0.0;  ///< s
  std::filesystem::path file;
};

/// ParaView's index of a time series (.pvd). Each added file replaces the index as a whole, so that it is
/// valid at any time.
class PvdCollection {
 public:
  /// Nothing is written before the first add().
  explicit PvdCollection(std::filesystem::path path);

  /// Adds `file`, which the index names relative to its own folder. Throws std::runtime_error naming the path
  /// if the index cannot be written.
  void add(double time, const std::filesystem::path& file);

 private:
  std::filesystem::path path_;
  std::vector<PvdEntry> entries_;  ///< files relative to the folder of path_
};

/// The entries in the order of the index; relative files are given below the folder of the index. Throws
/// InputError if the file is not such an index.
[[nodiscard]] std::vector<PvdEntry> read_pvd(const std::filesystem::path& path);

}  // namespace eisph
