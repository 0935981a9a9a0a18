#pragma once

#include "app/run_files.hpp"
#include "compare/number_table.hpp"
#include "compare/report.hpp"
#include "core/run_summary.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace eisph {

/// A run that a validation case asks for.
struct RunRequest {
  std::string scene;                        ///< name of a file in scenes/, without .toml
  std::string label = {};                   ///< tells the runs of a case apart; names the folder
  std::vector<std::string> overrides = {};  ///< key=value
  std::vector<double> states = {};          ///< s, times whose states are kept
  bool frames = false;                      ///< draw the scene's images at the times of the states
};

/// A finished run with its records.
struct ValidationRun {
  Scene scene;
  RunFiles files;
  RunSummary summary;
  std::vector<std::shared_ptr<const Snapshot>> states;  ///< in the order of time

  /// A table of the run: "gauge_column". Throws InputError if there is none.
  [[nodiscard]] NumberTable table(const std::string& name) const;
  /// The state at a time asked for; throws std::logic_error for another.
  [[nodiscard]] const Snapshot& state(double time) const;
  /// The frame of an image at a time asked for.
  [[nodiscard]] ReportFigure frame(const std::string& image, double time, const std::string& caption) const;
};

/// The run was asked to stop.
struct ValidationInterrupted : std::runtime_error {
  ValidationInterrupted() : std::runtime_error("interrupted") {}
};

/// Makes the runs of validation cases, one after the other, into <folder>/runs, and adds up their figures.
class Validator {
 public:
  struct Settings {
    std::filesystem::path folder;
    int threads = 1;
    bool full = false;  ///< published resolutions and durations instead of short runs
    bool quiet = false;
  };
  Validator(Settings settings, std::ostream& progress, std::function<bool()> stop_requested);

  [[nodiscard]] bool full() const { return settings_.full; }
  /// Full value in a full validation, quick value in a quick one.
  template <class Value>
  [[nodiscard]] Value pick(Value full_value, Value quick_value) const {
    return settings_.full ? full_value : quick_value;
  }

  void begin_case(const std::string& name);
  /// Throws BlowUpError if the run blows up, ValidationInterrupted if it is stopped.
  [[nodiscard]] ValidationRun run(const RunRequest& request);
  /// Where a run of the case in hand goes.
  [[nodiscard]] std::filesystem::path run_folder(const std::string& label) const;
  /// Where the case in hand puts a picture of that name.
  [[nodiscard]] std::filesystem::path figure_path(const std::string& name) const;
  /// Of the runs of the case in hand so far.
  [[nodiscard]] const RunFigures& figures() const { return figures_; }

 private:
  void add_figures(const RunSummary& summary);

  Settings settings_;
  std::ostream& progress_;
  std::function<bool()> stop_requested_;
  std::string case_;
  RunFigures figures_;
  double particle_steps_ = 0.0;
};

}  // namespace eisph
