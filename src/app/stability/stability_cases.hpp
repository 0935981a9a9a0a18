#pragma once

#include <string>
#include <vector>

namespace eisph {

/// A flow that schemes find hard.
struct StabilityCase {
  std::string name;
  std::string title;
  std::string scene;  ///< in scenes/, without .toml
  std::vector<std::string> overrides = {};
  /// Changes of the scene that are run one after the other; the worst counts. Empty: one run.
  std::vector<std::vector<std::string>> variants = {};
};

[[nodiscard]] std::vector<StabilityCase> stability_cases(bool full);

/// A scheme whose time step is swept; `step_key` is phi or the Courant number, `step` its default.
struct StabilityScheme {
  std::string name;
  std::vector<std::string> overrides;
  std::string step_key;
  double step;
};

[[nodiscard]] const std::vector<StabilityScheme>& stability_schemes();

/// Time steps of the atlas over the default ones of the schemes.
inline constexpr double kQuickStepFactors[] = {1.0, 2.0};
inline constexpr double kFullStepFactors[] = {0.5, 1.0, 1.5, 2.0, 3.0};

}  // namespace eisph
