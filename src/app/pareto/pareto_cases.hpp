#pragma once

#include "app/validate/validator.hpp"

#include <functional>
#include <string>
#include <vector>

namespace eisph {

/// A scheme and a time step, as changes of a scene.
struct ParetoSetting {
  std::string scheme;  ///< name of the series in the chart: scheme and stepping
  std::string step;    ///< "phi 0.17"
  std::vector<std::string> overrides;
};

/// "EISPH, phi 0.17"
[[nodiscard]] std::string setting_name(const std::string& scheme, const std::string& step);

/// All settings that are compared, by series.
[[nodiscard]] const std::vector<ParetoSetting>& pareto_settings();

/// Those whose name contains one of the texts; all without any text. Throws InputError for a text that is
/// in no name.
[[nodiscard]] std::vector<ParetoSetting> choose_settings(const std::vector<std::string>& texts);

/// One way to tell how far off a run is.
struct ParetoError {
  std::string name;     ///< "P1"
  std::string meaning;  ///< what is compared with what, by which norm
  /// In per cent. `reference` is the run of ParetoCase::reference, if the case has one.
  std::function<double(const ValidationRun& run, const ValidationRun* reference)> evaluate;
};

/// A flow on which settings are compared.
struct ParetoCase {
  std::string name;
  std::string title;
  std::string scene;
  std::vector<double> full_spacings;   ///< m
  std::vector<double> quick_spacings;  ///< m
  double full_end = 0.0;               ///< s
  double quick_end = 0.0;              ///< s
  std::vector<ParetoError> errors;
  std::vector<std::string> reference =
      {};               ///< changes of the scene that make the reference run; none: no run
  bool states = false;  ///< keep the state at the end
};

[[nodiscard]] const std::vector<ParetoCase>& pareto_cases();

}  // namespace eisph
