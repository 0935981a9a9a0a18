#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace eisph {

/// Where a run stands.
struct ProgressState {
  double time = 0.0;       ///< s, simulated
  double end_time = 0.0;   ///< s
  double time_step = 0.0;  ///< s
  std::uint64_t step = 0;
  std::uint64_t particles = 0;
  double wall_time = 0.0;              ///< s since the time loop began
  const char* carriers = "particles";  ///< or cells
};

/// One line, cut to `width` characters: share done, simulated time, step, time step, particles, fluid
/// particle steps per second of wall clock and the time still needed.
[[nodiscard]] std::string progress_line(const ProgressState& state, std::size_t width);

/// "1 h 02 min", "3 min 20 s", "12 s", "1.7 s".
[[nodiscard]] std::string duration_text(double seconds);

enum class ProgressStyle { Live, Plain, Quiet };

/// Prints progress: one line that is overwritten (Live), a line now and then (Plain), or nothing.
class ProgressReporter {
 public:
  ProgressReporter(std::ostream& out, ProgressStyle style, std::size_t width);
  /// Ends a live line that is still open, so that what follows has a line of its own.
  ~ProgressReporter();
  ProgressReporter(const ProgressReporter&) = delete;
  ProgressReporter& operator=(const ProgressReporter&) = delete;

  /// Prints if enough wall time has passed since the last time.
  void update(const ProgressState& state);
  /// Prints the last state.
  void finish(const ProgressState& state);

 private:
  void print(const ProgressState& state);
  void end_line();

  std::ostream& out_;
  ProgressStyle style_;
  std::size_t width_;
  double next_ = 0.0;  ///< s of wall time
  bool line_open_ = false;
};

/// Live on a terminal, plain elsewhere; of the standard error stream.
[[nodiscard]] ProgressStyle progress_style_of_terminal(bool quiet);
/// Columns of the terminal behind the standard error stream; 80 if unknown.
[[nodiscard]] std::size_t terminal_width();

}  // namespace eisph
