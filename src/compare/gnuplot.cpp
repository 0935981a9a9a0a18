#include "compare/gnuplot.hpp"

#include "compare/plot.hpp"
#include "compare/whole_file.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace eisph {

namespace {

/// A folder for the script and the messages of gnuplot; it goes with everything in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "eisph_plot_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error(fmt::format("{}: cannot be made", pattern));
    }
    path_ = pattern;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Where the program is; empty if it is nowhere on the PATH.
std::filesystem::path find_gnuplot() {
  const char* variable = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
  std::string_view rest = variable != nullptr ? variable : "";
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    if (folder.empty()) continue;
    std::filesystem::path program = std::filesystem::path(folder) / "gnuplot";
    if (::access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

/// Runs a program with its output and its messages in files; its exit code, minus the signal that ended it.
int run_child(std::array<std::string, 3> arguments, const std::filesystem::path& out,
              const std::filesystem::path& messages) {
  std::array<char*, 4> pointers{arguments[0].data(), arguments[1].data(), arguments[2].data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int kCreate = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), kCreate, 0666);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), kCreate, 0600);
  pid_t process = 0;
  const int error = posix_spawn(&process, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw std::runtime_error(
        fmt::format("{}: cannot be run: {}", arguments[0], std::generic_category().message(error)));
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// Length of the UTF-8 character that begins at `text`; 0 if none does.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const std::size_t length = byte(0) < 0x80   ? 1
                             : byte(0) < 0xC2 ? 0
                             : byte(0) < 0xE0 ? 2
                             : byte(0) < 0xF0 ? 3
                             : byte(0) < 0xF5 ? 4
                                              : 0;
  if (length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0U) != 0x80U) return 0;
  }
  return length;
}

}  // namespace

bool has_gnuplot() { return !find_gnuplot().empty(); }

void require_gnuplot() {
  if (has_gnuplot()) return;
  throw std::runtime_error(
      "gnuplot, which draws the plots, is not on the PATH: install the package gnuplot-nox");
}

std::string gnuplot_quoted(std::string_view text) {
  // Between single quotes gnuplot takes every character as it stands. Two of them should be one, but not at
  // the beginning of a string (gnuplot 5.4): the typographic apostrophe ends none.
  std::string quoted = "'";
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      quoted += '?';
    } else if (length == 1 && (static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7F)) {
      quoted += ' ';
    } else if (text[0] == '\'') {
      quoted += "\u2019";
    } else {
      quoted += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return quoted + "'";
}

std::string gnuplot_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.9g}", value) : "NaN";
}

std::string gnuplot_preamble(int width, int height) {
  return fmt::format(
      "set terminal pngcairo noenhanced size {},{} font 'DejaVu Sans,12' background '#ffffff'\n"
      "set encoding utf8\n"
      "set border 15 linecolor rgb '#404040' linewidth 1\n"
      "set grid linetype 1 linecolor rgb '#e0e0e0' linewidth 1\n"
      "set tics textcolor rgb '#202020'\n"
      "set format '%g'\n",
      width, height);
}

void run_gnuplot(const std::filesystem::path& png, const std::string& script) {
  require_gnuplot();
  const ScratchFolder scratch;
  write_whole_file(scratch / "script", script);
  // The drawing goes to gnuplot's output, not to a file that the script names: some names mean a pipe to it.
  const int code = run_child({find_gnuplot().string(), "--default-settings", (scratch / "script").string()},
                             scratch / "picture", scratch / "messages");
  if (code != 0) {
    throw std::runtime_error(fmt::format("{}: gnuplot failed ({}): {}", png.string(), code,
                                         read_whole_file(scratch / "messages")));
  }
  write_whole_file(png, read_whole_file(scratch / "picture"));
}

}  // namespace eisph
