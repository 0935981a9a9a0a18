#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace eisph {

/// Text as a string of a gnuplot script: nothing in it is a command, a substitution or markup. An apostrophe
/// becomes the typographic one, control characters become spaces, bytes that are no UTF-8 question marks.
[[nodiscard]] std::string gnuplot_quoted(std::string_view text);

/// A number of a gnuplot script; NaN where there is none.
[[nodiscard]] std::string gnuplot_number(double value);

/// First lines of a script: a PNG of this size, fonts, frame and grid.
[[nodiscard]] std::string gnuplot_preamble(int width, int height);

/// Runs a script, whose drawing becomes the file `png`. Throws std::runtime_error if gnuplot is missing or
/// complains, or the file cannot be written; an older file is then unchanged.
void run_gnuplot(const std::filesystem::path& png, const std::string& script);

}  // namespace eisph
