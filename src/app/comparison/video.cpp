#include "app/comparison/video.hpp"

#include "core/child_program.hpp"
#include "io/file_io.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

/// A path as ffmpeg's list of files wants it.
std::string quoted(const std::filesystem::path& path) {
  std::string text = "'";
  for (const char letter : std::filesystem::absolute(path).string())
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

std::string picture_list(const std::vector<std::filesystem::path>& pictures, double seconds_each) {
  std::string list = "ffconcat version 1.0\n";
  for (const auto& picture : pictures)
    list += fmt::format("file {}\nduration {}\n", quoted(picture), seconds_each);
  // The last duration counts only if another file follows it.
  return list + fmt::format("file {}\n", quoted(pictures.back()));
}

}  // namespace

bool has_ffmpeg() { return !find_program("ffmpeg").empty(); }

void write_video(const std::filesystem::path& path, const std::vector<std::filesystem::path>& pictures,
                 double seconds_each, double rate) {
  if (pictures.empty()) return;
  const ScratchFolder scratch;
  write_file_atomically(scratch / "list", picture_list(pictures, seconds_each));
  AtomicFile target(path);
  const int code = run_child_program({find_program("ffmpeg").string(),
                                      "-nostdin",
                                      "-loglevel",
                                      "error",
                                      "-y",
                                      "-f",
                                      "concat",
                                      "-safe",
                                      "0",
                                      "-i",
                                      (scratch / "list").string(),
                                      "-vf",
                                      "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p",
                                      "-t",
                                      fmt::format("{}", seconds_each * static_cast<double>(pictures.size())),
                                      "-r",
                                      fmt::format("{}", rate),
                                      "-c:v",
                                      "libx264",
                                      "-movflags",
                                      "+faststart",
                                      "-f",
                                      "mp4",
                                      target.temporary_path().string()},
                                     scratch / "output", scratch / "messages");
  if (code != 0) {
    throw std::runtime_error(
        fmt::format("{}: ffmpeg failed ({}): {}", path.string(), code, read_file(scratch / "messages")));
  }
  target.commit();
}

}  // namespace eisph
