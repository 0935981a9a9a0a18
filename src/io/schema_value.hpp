#pragma once

#include "core/shape.hpp"

#include <limits>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace eisph {

/// Numbers that a key accepts.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;
  bool high_excluded = false;

  [[nodiscard]] bool contains(double value) const;
  /// "above 0", "from 0 to 1"; empty if every number is in range.
  [[nodiscard]] std::string text() const;
};

[[nodiscard]] inline NumberRange any_number() { return {}; }
[[nodiscard]] inline NumberRange above(double low) { return {.low = low, .low_excluded = true}; }
[[nodiscard]] inline NumberRange at_least(double low) { return {.low = low}; }
[[nodiscard]] inline NumberRange between(double low, double high) { return {.low = low, .high = high}; }
[[nodiscard]] inline NumberRange above_to(double low, double high) {
  return {.low = low, .high = high, .low_excluded = true};
}

// TOML values to C++ values. Each returns false, and leaves the result alone, if the value is not of the type
// or out of range. Whole numbers pass as numbers; infinities and not-a-number do not.
[[nodiscard]] bool read_number(const toml::node& node, const NumberRange& range, double& value);
[[nodiscard]] bool read_integer(const toml::node& node, const NumberRange& range, long long& value);
[[nodiscard]] bool read_bool(const toml::node& node, bool& value);
[[nodiscard]] bool read_text(const toml::node& node, std::string& value);
/// Letters, digits, "_" and "-": what can be part of a file name.
[[nodiscard]] bool read_name(const toml::node& node, std::string& value);
/// A list of names.
[[nodiscard]] bool read_names(const toml::node& node, std::vector<std::string>& values);
/// Numbers in range, each above the one before.
[[nodiscard]] bool read_ascending(const toml::node& node, const NumberRange& range,
                                  std::vector<double>& values);
[[nodiscard]] bool read_numbers(const toml::node& node, std::vector<double>& values);
/// [x, y, z], in two dimensions [x, z].
[[nodiscard]] bool read_vector(const toml::node& node, int dimension, Vec3d& value);

// C++ values to TOML text that reads back to the same value.
[[nodiscard]] std::string write_number(double value);
[[nodiscard]] std::string write_bool(bool value);
[[nodiscard]] std::string write_text(const std::string& value);
[[nodiscard]] std::string write_names(const std::vector<std::string>& values);
[[nodiscard]] std::string write_numbers(const std::vector<double>& values);
[[nodiscard]] std::string write_vector(const Vec3d& value, int dimension);

/// The value as it would stand in a file, shortened if it is long.
[[nodiscard]] std::string node_text(const toml::node& node);

[[nodiscard]] bool is_name(const std::string& text);
/// The candidate most like `word`, or nothing if none is close.
[[nodiscard]] std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace eisph
