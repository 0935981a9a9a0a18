#include "app/progress.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace eisph {
namespace {

constexpr double kLiveInterval = 0.2;   // s
constexpr double kPlainInterval = 5.0;  // s

std::string rate_text(double rate) {
  if (rate >= 1e6) return fmt::format("{:.2f} M", rate / 1e6);
  if (rate >= 1e3) return fmt::format("{:.1f} k", rate / 1e3);
  return fmt::format("{:.0f} ", rate);
}

}  // namespace

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0.0) return "?";
  const auto whole = static_cast<long>(std::llround(seconds));
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_line(const ProgressState& state, std::size_t width) {
  const double share = state.end_time > 0.0 ? std::clamp(state.time / state.end_time, 0.0, 1.0) : 1.0;
  const double rate = state.wall_time > 0.0 ? static_cast<double>(state.particles) *
                                                  static_cast<double>(state.step) / state.wall_time
                                            : 0.0;
  const std::string remaining =
      share > 0.0 ? duration_text(state.wall_time * (1.0 - share) / share) : std::string("?");
  std::string line = fmt::format("{:5.1f} %  t {:.4f} s  step {}  dt {:.2e} s  {} {}  {}/s  ETA {}",
                                 100.0 * share, state.time, state.step, state.time_step, state.particles,
                                 state.carriers, rate_text(rate), remaining);
  if (line.size() > width) line.resize(width);
  return line;
}

ProgressReporter::ProgressReporter(std::ostream& out, ProgressStyle style, std::size_t width)
    : out_(out), style_(style), width_(width) {}

ProgressReporter::~ProgressReporter() { end_line(); }

void ProgressReporter::update(const ProgressState& state) {
  if (style_ == ProgressStyle::Quiet || state.wall_time < next_) return;
  next_ = state.wall_time + (style_ == ProgressStyle::Live ? kLiveInterval : kPlainInterval);
  print(state);
}

void ProgressReporter::finish(const ProgressState& state) {
  if (style_ == ProgressStyle::Quiet) return;
  print(state);
  end_line();
}

void ProgressReporter::end_line() {
  if (line_open_) out_ << '\n' << std::flush;
  line_open_ = false;
}

void ProgressReporter::print(const ProgressState& state) {
  if (style_ == ProgressStyle::Live) {
    // The last column stays free: some terminals wrap when it is filled.
    const std::size_t columns = width_ > 1 ? width_ - 1 : 1;
    line_open_ = true;
    out_ << fmt::format("\r{:<{}}", progress_line(state, columns), columns) << std::flush;
  } else {
    out_ << progress_line(state, std::string::npos) << std::endl;
  }
}

ProgressStyle progress_style_of_terminal(bool quiet) {
  if (quiet) return ProgressStyle::Quiet;
  return isatty(STDERR_FILENO) != 0 ? ProgressStyle::Live : ProgressStyle::Plain;
}

std::size_t terminal_width() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

}  // namespace eisph
