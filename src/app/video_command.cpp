#include "app/commands.hpp"
#include "app/comparison/video.hpp"
#include "app/run_files.hpp"
#include "core/error.hpp"
#include "io/file_io.hpp"

#include <algorithm>
#include <map>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

namespace eisph {
namespace {

/// Frames of each image in the order of their numbers: the files <image>_<number>.png of the folder.
std::map<std::string, std::vector<std::filesystem::path>> sequences(const std::filesystem::path& folder) {
  std::map<std::string, std::vector<std::filesystem::path>> frames;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string stem = entry.path().stem().string();
      const std::size_t line = stem.rfind('_');
      if (entry.path().extension() != ".png" || line == std::string::npos || line + 1 == stem.size())
        continue;
      const bool numbered = stem.find_first_not_of("0123456789", line + 1) == std::string::npos;
      if (numbered) frames[stem.substr(0, line)].push_back(entry.path());
    }
  }
  if (frames.empty()) {
    throw InputError(fmt::format("{}: holds no frames <image>_<number>.png", folder.string()));
  }
  for (auto& [image, files] : frames) {
    // More digits are larger numbers: the number is padded with zeros to four.
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
      const std::string first = a.filename().string();
      const std::string second = b.filename().string();
      return first.size() != second.size() ? first.size() < second.size() : first < second;
    });
  }
  return frames;
}

}  // namespace

int video_command(const VideoOptions& options, std::ostream& out) {
  const RunFiles files{options.run_folder};
  const std::filesystem::path folder = options.frames.value_or(files.frames());
  const auto frames = sequences(folder);
  std::vector<std::string> images = options.images;
  if (images.empty()) {
    images.reserve(frames.size());
    for (const auto& [image, pictures] : frames) images.push_back(image);
  }
  for (const std::string& image : images) {
    if (frames.contains(image)) continue;
    std::vector<std::string> known;
    known.reserve(frames.size());
    for (const auto& [name, pictures] : frames) known.push_back(name);
    throw InputError(fmt::format("--image {}: {} has no frames of it; it has those of {}", image,
                                 folder.string(), fmt::join(known, ", ")));
  }
  if (!has_ffmpeg()) {
    throw InputError("video: ffmpeg is not installed; install the Debian package ffmpeg");
  }
  const std::filesystem::path target = options.out.value_or(files.video());
  create_folder(target);
  for (const std::string& image : images) {
    const std::filesystem::path file = target / (image + ".mp4");
    write_video(file, frames.at(image), 1.0 / options.rate, options.rate);
    fmt::print(out, "{}: {} frames, {:.3g} s\n", file.string(), frames.at(image).size(),
               static_cast<double>(frames.at(image).size()) / options.rate);
  }
  return kSuccess;
}

}  // namespace eisph
