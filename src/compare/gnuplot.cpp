#include "compare/gnuplot.hpp"

#include "compare/plot.hpp"
#include "compare/whole_file.hpp"
#include "core/child_program.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

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

bool has_gnuplot() { return !find_program("gnuplot").empty(); }

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
  const int code = run_child_program(
      {find_program("gnuplot").string(), "--default-settings", (scratch / "script").string()},
      scratch / "picture", scratch / "messages");
  if (code != 0) {
    throw std::runtime_error(fmt::format("{}: gnuplot failed ({}): {}", png.string(), code,
                                         read_whole_file(scratch / "messages")));
  }
  write_whole_file(png, read_whole_file(scratch / "picture"));
}

}  // namespace eisph
