#include "io/schema_value.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eisph {

bool NumberRange::contains(double value) const {
  return std::isfinite(value) && (low_excluded ? value > low : value >= low) &&
         (high_excluded ? value < high : value <= high);
}

std::string NumberRange::text() const {
  const bool bounded_below = std::isfinite(low);
  const bool bounded_above = std::isfinite(high);
  if (bounded_below && bounded_above && !low_excluded && !high_excluded)
    return fmt::format("from {} to {}", low, high);
  std::string text;
  if (bounded_below) text = fmt::format("{} {}", low_excluded ? "above" : "at least", low);
  if (bounded_below && bounded_above) text += " and ";
  if (bounded_above) text += fmt::format("{} {}", high_excluded ? "below" : "at most", high);
  return text;
}

bool read_number(const toml::node& node, const NumberRange& range, double& value) {
  if (!node.is_number()) return false;
  const double number = *node.value<double>();
  if (!range.contains(number)) return false;
  value = number;
  return true;
}

bool read_integer(const toml::node& node, const NumberRange& range, long long& value) {
  if (!node.is_integer()) return false;
  const long long number = *node.value_exact<int64_t>();
  if (!range.contains(static_cast<double>(number))) return false;
  value = number;
  return true;
}

bool read_bool(const toml::node& node, bool& value) {
  if (!node.is_boolean()) return false;
  value = *node.value_exact<bool>();
  return true;
}

bool read_text(const toml::node& node, std::string& value) {
  if (!node.is_string()) return false;
  value = *node.value_exact<std::string>();
  return true;
}

bool read_name(const toml::node& node, std::string& value) {
  std::string text;
  if (!read_text(node, text) || !is_name(text)) return false;
  value = text;
  return true;
}

bool read_names(const toml::node& node, std::vector<std::string>& values) {
  if (!node.is_array()) return false;
  std::vector<std::string> names;
  for (const toml::node& element : *node.as_array()) {
    if (!read_name(element, names.emplace_back())) return false;
  }
  values = names;
  return true;
}

bool read_numbers(const toml::node& node, std::vector<double>& values) {
  if (!node.is_array()) return false;
  std::vector<double> numbers;
  for (const toml::node& element : *node.as_array()) {
    if (!read_number(element, any_number(), numbers.emplace_back())) return false;
  }
  values = numbers;
  return true;
}

bool read_ascending(const toml::node& node, const NumberRange& range, std::vector<double>& values) {
  std::vector<double> numbers;
  if (!read_numbers(node, numbers)) return false;
  const auto in_range = [&](double number) { return range.contains(number); };
  const auto not_rising = [](double first, double second) { return second <= first; };
  if (!std::all_of(numbers.begin(), numbers.end(), in_range)) return false;
  if (std::adjacent_find(numbers.begin(), numbers.end(), not_rising) != numbers.end()) return false;
  values = numbers;
  return true;
}

bool read_vector(const toml::node& node, int dimension, Vec3d& value) {
  std::vector<double> numbers;
  if (!read_numbers(node, numbers) || numbers.size() != static_cast<std::size_t>(dimension)) return false;
  value = dimension == 2 ? Vec3d(numbers[0], 0.0, numbers[1]) : Vec3d(numbers[0], numbers[1], numbers[2]);
  return true;
}

std::string write_number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string write_bool(bool value) { return value ? "true" : "false"; }

std::string write_text(const std::string& value) {
  std::string text = "\"";
  for (const char character : value) {
    if (character == '"' || character == '\\') {
      text += fmt::format("\\{}", character);
    } else if (static_cast<unsigned char>(character) < 0x20 || character == 0x7F) {
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(character));
    } else {
      text += character;
    }
  }
  return text + "\"";
}

std::string write_names(const std::vector<std::string>& values) {
  std::vector<std::string> texts(values.size());
  std::transform(values.begin(), values.end(), texts.begin(), write_text);
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string write_numbers(const std::vector<double>& values) {
  std::vector<std::string> texts(values.size());
  std::transform(values.begin(), values.end(), texts.begin(), write_number);
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string write_vector(const Vec3d& value, int dimension) {
  if (dimension == 2) return write_numbers({value.x(), value.z()});
  return write_numbers({value.x(), value.y(), value.z()});
}

namespace {

/// The value in one line, however long.
std::string whole_text(const toml::node& node) {
  if (node.is_table()) return "{...}";
  if (node.is_string()) return write_text(*node.value_exact<std::string>());
  if (node.is_floating_point()) return write_number(*node.value_exact<double>());
  if (node.is_array()) {
    std::vector<std::string> elements;
    for (const toml::node& element : *node.as_array()) elements.push_back(whole_text(element));
    return fmt::format("[{}]", fmt::join(elements, ", "));
  }
  std::ostringstream stream;
  node.visit([&](const auto& typed) { stream << typed; });
  return stream.str();
}

}  // namespace

std::string node_text(const toml::node& node) {
  constexpr std::size_t kLongest = 80;
  const std::string text = whole_text(node);
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + " ...";
}

bool is_name(const std::string& text) {
  constexpr auto kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !text.empty() && text.find_first_not_of(kAllowed) == std::string::npos;
}

namespace {

/// Levenshtein distance: insertions, deletions and replacements that turn one word into the other.
std::size_t edit_distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates) {
  std::string nearest;
  std::size_t least = std::max<std::size_t>(3, word.size() / 2 + 1);
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace eisph
