#include "io/toml_source.hpp"

#include "core/error.hpp"
#include "io/schema_value.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eisph {

namespace {

std::string read_whole(const std::filesystem::path& file, const std::string& expected) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!std::filesystem::is_regular_file(file) || !stream || !(text << stream.rdbuf())) {
    throw InputError(fmt::format("{}: cannot be read; {} is expected", file.string(), expected));
  }
  return text.str();
}

/// The value of an override in TOML syntax; anything else is taken as a string.
toml::table parse_value(const std::string& text) {
  try {
    toml::table parsed = toml::parse("value = " + text);
    if (parsed.size() == 1) return parsed;
  } catch (const toml::parse_error&) {  // a bare word
  }
  return toml::table{{"value", text}};
}

std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

/// Position of the element that `word` means, by number or by its name.
std::optional<std::size_t> find_element(const toml::array& list, const std::string& word) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error == std::errc() && end == word.data() + word.size() && index < list.size()) return index;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const toml::table* element = list[k].as_table();
    if (element != nullptr && (*element)["name"].value<std::string>() == word) return k;
  }
  return std::nullopt;
}

std::string element_names(const toml::array& list) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const toml::table* element = list[k].as_table();
    const auto name = element == nullptr ? std::nullopt : (*element)["name"].value<std::string>();
    names.push_back(name ? fmt::format("{} ({})", k, *name) : fmt::format("{}", k));
  }
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

TomlSource::TomlSource(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       const TomlKind& kind)
    : file_(file.string()) {
  const std::string text = read_whole(file, kind.expected);
  try {
    root_ = toml::parse(text, std::string_view(file_));
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: not valid TOML: {}", file_, error.source().begin.line,
                                 std::string_view(error.description())));
  }
  const auto comes_first = [&kind](const std::string& assignment) {
    return !kind.first_key.empty() && assignment.rfind(kind.first_key, 0) == 0;
  };
  for (const std::string& assignment : overrides) {
    if (comes_first(assignment)) apply_override(assignment, kind.example);
  }
  kind.complete(root_);
  for (const std::string& assignment : overrides) {
    if (!comes_first(assignment)) apply_override(assignment, kind.example);
  }
}

void TomlSource::apply_override(const std::string& assignment, const std::string& example) {
  const auto reject = [&](const std::string& problem) {
    throw InputError(fmt::format("{}, --set {}: {}", file_, assignment, problem));
  };
  const std::size_t equals = assignment.find('=');
  std::vector<std::string> parts = split_path(assignment.substr(0, equals));
  const bool blank = std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); });
  if (equals == std::string::npos || parts.empty() || blank) {
    reject("expected section.key=value, for example " + example);
  }
  toml::table* table = &root_;
  std::string path;
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    path += (path.empty() ? "" : ".") + parts[k];
    if (!table->contains(parts[k])) table->insert(parts[k], toml::table{});
    toml::node* node = table->get(parts[k]);
    if (toml::array* list = node->as_array(); list != nullptr) {
      const auto element = find_element(*list, parts[k + 1]);
      if (!element)
        reject(fmt::format("{} has no element {}; there are: {}", path, parts[k + 1], element_names(*list)));
      node = list->get(*element);
      ++k;
      path += fmt::format(".{}", *element);
    }
    table = node->as_table();
    if (table == nullptr) reject(fmt::format("{} is not a section", path));
    if (k + 1 == parts.size()) reject(fmt::format("{} is a section; expected {}.key=value", path, path));
  }
  toml::table parsed = parse_value(assignment.substr(equals + 1));
  parsed.get("value")->visit([&](auto& value) { table->insert_or_assign(parts.back(), std::move(value)); });
  overrides_[path + (path.empty() ? "" : ".") + parts.back()] = assignment;
}

std::string TomlSource::place_of(const std::string& path) const {
  const auto found = overrides_.find(path);
  return found == overrides_.end() ? std::string() : fmt::format("{}, --set {}", file_, found->second);
}

void TomlSource::record(const std::string& path, const toml::node& node) {
  // A table that only an override mentions has no line; it takes the place of the first such override.
  const auto below = overrides_.lower_bound(path + ".");
  const auto line = node.source().begin.line;
  Entry entry{.place = place_of(path), .value = node.is_table() ? "" : node_text(node)};
  if (entry.place.empty() && line != 0) entry.place = fmt::format("{}:{}", file_, line);
  if (entry.place.empty() && below != overrides_.end() && below->first.rfind(path + ".", 0) == 0) {
    entry.place = place_of(below->first);
  }
  if (entry.place.empty()) entry.place = file_;
  entries_[path] = entry;
}

std::size_t TomlSource::list_size(const std::string& name) const {
  const toml::array* list = root_[name].as_array();
  return list == nullptr ? 0 : list->size();
}

void TomlSource::resolve_file(std::filesystem::path& file, const std::string& path) const {
  if (file.is_relative()) file = std::filesystem::path(file_).parent_path() / file;
  file = file.lexically_normal();
  if (!std::filesystem::is_regular_file(file)) fail(path, fmt::format("there is no file {}", file.string()));
}

void TomlSource::fail(const std::string& path, const std::string& problem) const {
  const auto found = entries_.find(path);
  fail(path, found == entries_.end() ? std::string() : found->second.value, problem);
}

void TomlSource::fail(const std::string& path, const std::string& value, const std::string& problem) const {
  std::string place = file_;
  for (std::string ancestor = path; !ancestor.empty();) {
    const auto found = entries_.find(ancestor);
    if (found != entries_.end()) {
      place = found->second.place;
      break;
    }
    const std::size_t dot = ancestor.rfind('.');
    ancestor = dot == std::string::npos ? "" : ancestor.substr(0, dot);
  }
  throw InputError(fmt::format("{}: {}{}{}: {}", place, path, value.empty() ? "" : " = ", value, problem));
}

}  // namespace eisph
