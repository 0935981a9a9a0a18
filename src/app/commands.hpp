#pragma once

#include <array>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// Exit code of a run that was asked to stop, as a shell reports Ctrl-C.
inline constexpr int kInterrupted = 130;

struct RunOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value
  int threads = 1;
  std::optional<std::filesystem::path> out;  ///< folder of the run; default out/<scene>
  std::optional<double> until;               ///< s, earlier end
  bool quiet = false;
  bool frames = true;
  std::string context = "auto";  ///< of the frames: auto, osmesa, egl or window
};

/// Simulates a scene and writes its outputs. Progress goes to `progress`, the report at the end to `out`.
/// Returns the exit code. Throws InputError before anything is written, and BlowUpError after everything is.
[[nodiscard]] int run_command(const RunOptions& options, std::ostream& out, std::ostream& progress);

struct CheckOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;
  int threads = 1;
};

/// Prints what a scene would simulate and write, and what is doubtful about it.
[[nodiscard]] int check_command(const CheckOptions& options, std::ostream& out);

struct RenderOptions {
  std::filesystem::path run_folder;
  std::vector<std::string> images;  ///< names; empty: all
  std::vector<std::string> overrides;
  std::vector<double> times;                 ///< s; empty: all saved states
  std::optional<std::filesystem::path> out;  ///< default <run folder>/rendered
  std::string context = "auto";              ///< auto, osmesa, egl or window
};

/// Draws frames from the saved states of a run.
[[nodiscard]] int render_command(const RenderOptions& options, std::ostream& out);

struct VideoOptions {
  std::filesystem::path run_folder;
  std::optional<std::filesystem::path> frames;  ///< folder of the frames, default <run folder>/frames
  std::vector<std::string> images;              ///< names; empty: all
  double rate = 25.0;                           ///< frames per second
  std::optional<std::filesystem::path> out;     ///< folder of the videos, default <run folder>/video
};

/// Joins the frames of a run to videos. Throws InputError if there are none, or no ffmpeg.
[[nodiscard]] int video_command(const VideoOptions& options, std::ostream& out);

struct ViewOptions {
  std::filesystem::path subject;  ///< scene file, or folder of a run
  std::vector<std::string> overrides;
  int threads = 1;
  int width = 1280;                          ///< of the window
  int height = 760;                          ///< of the window
  double scale = 0.0;                        ///< of letters and controls; 0: as the display asks
  std::optional<double> until;               ///< s: plays at once, and closes the window there
  std::optional<std::filesystem::path> out;  ///< of pictures and the log; default out/<scene>/view, RUN/view
};

/// Opens a window on a running simulation or on the saved states of a run. Throws InputError when there is no
/// display, and BlowUpError after a simulation that blew up.
[[nodiscard]] int view_command(const ViewOptions& options, std::ostream& out);

struct ValidateOptions {
  std::vector<std::string> cases;  ///< names; empty: all of the mode
  bool quick = false;              ///< short runs; the default
  bool full = false;               ///< published resolutions and durations
  bool list = false;               ///< only tell what cases there are
  std::filesystem::path out = std::filesystem::path("out") / "validate";
  std::optional<std::filesystem::path> against;  ///< folder of an earlier report
  int threads = 1;
  bool quiet = false;
};

/// Runs cases, compares them with theory and measurement and writes report.html and report.json. Returns the
/// exit code: kLimitsMissed if a limit does not hold.
[[nodiscard]] int validate_command(const ValidateOptions& options, std::ostream& out, std::ostream& progress);

struct ParetoOptions {
  std::vector<std::string> cases;  ///< names; empty: all
  std::vector<std::string> only;   ///< parts of the names of settings; empty: all
  bool full = false;               ///< published spacings and durations
  bool list = false;               ///< only tell what cases there are
  int repeats = 3;                 ///< runs of each setting
  std::filesystem::path peers;     ///< runs of other programs; empty: none
  std::filesystem::path out = std::filesystem::path("out") / "pareto";
  bool quiet = false;
};

/// Runs schemes, time steps and spacings on cases with known results and writes cost against error: a table
/// and charts for each case, pareto.json and report.html.
[[nodiscard]] int pareto_command(const ParetoOptions& options, std::ostream& out, std::ostream& progress);

struct StabilityOptions {
  std::vector<std::string> cases;  ///< names; empty: all
  std::vector<std::string> only;   ///< parts of the names of schemes; empty: all
  bool full = false;               ///< five time steps and two spacings instead of two and one, longer runs
  bool list = false;               ///< only tell what cases there are
  std::filesystem::path out = std::filesystem::path("out") / "stability";
  int threads = 1;
  bool quiet = false;
};

/// Runs every scheme on hard cases over time step and spacing and tells where it is stable, degraded or blown
/// up: atlas.csv, atlas.json, coloured maps and report.html.
[[nodiscard]] int stability_command(const StabilityOptions& options, std::ostream& out);

struct CompareOptions {
  std::filesystem::path comparison;
  std::vector<std::string> overrides;
  std::optional<std::filesystem::path> run;  ///< folder of the run; default: the one that the file names
  std::optional<std::filesystem::path> out;  ///< default <run>/comparison
  bool quiet = false;
};

/// Compares a run's saved depths with photographs and writes pictures, statistics and a report. Throws
/// InputError before anything is written.
[[nodiscard]] int compare_command(const CompareOptions& options, std::ostream& out);

struct PhotographOptions {
  std::filesystem::path run_folder;
  std::optional<std::filesystem::path> camera;  ///< settings file
  std::vector<std::string> overrides;
  std::vector<double> times;                  ///< s; empty: all saved times
  std::optional<std::filesystem::path> out;   ///< default <run>/photographs
  std::optional<std::array<double, 4>> area;  ///< x_min, y_min, x_max, y_max, m
  bool quiet = false;
};

/// Makes synthetic photographs of a run, of the empty tank and of still water, and the comparison file that
/// goes with them.
[[nodiscard]] int photograph_command(const PhotographOptions& options, std::ostream& out);

}  // namespace eisph
