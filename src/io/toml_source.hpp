#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace eisph {

/// What sort of file a TomlSource reads.
struct TomlKind {
  std::string expected;  ///< as in "a scene file (TOML) is expected"
  std::string example;   ///< of an override
  /// Completes the parsed file before the overrides are laid over it, except those of `first_key`.
  std::function<void(toml::table&)> complete = [](toml::table&) {};
  std::string first_key = {};
};

/// A file as parsed, with the overrides of the command line laid over it, and the place that every key came
/// from. Keys are addressed by dotted paths; elements of a list by their number from 0: "image.0.width".
class TomlSource {
 public:
  /// Throws InputError for a file that cannot be read or is not TOML, and for an override that has no place.
  TomlSource(const std::filesystem::path& file, const std::vector<std::string>& overrides,
             const TomlKind& kind);

  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] std::string file() const { return file_; }

  /// Remembers that `path` was read from `node`.
  void record(const std::string& path, const toml::node& node);
  [[nodiscard]] bool given(const std::string& path) const { return entries_.count(path) != 0; }
  /// Number of entries of the list `name` ([[name]]).
  [[nodiscard]] std::size_t list_size(const std::string& name) const;

  /// Makes `file`, which stands at `path`, one that can be opened from here: names count from the folder of
  /// this file. Throws InputError unless it is there.
  void resolve_file(std::filesystem::path& file, const std::string& path) const;

  /// Throws InputError: place, key, the value that stands there, problem.
  [[noreturn]] void fail(const std::string& path, const std::string& problem) const;
  /// The same for a value that need not stand in the file.
  [[noreturn]] void fail(const std::string& path, const std::string& value, const std::string& problem) const;

 private:
  struct Entry {
    std::string place;  ///< "file:line" or the override
    std::string value;  ///< empty for a table
  };

  void apply_override(const std::string& assignment, const std::string& example);
  [[nodiscard]] std::string place_of(const std::string& path) const;

  std::string file_;
  toml::table root_;
  std::map<std::string, Entry> entries_;
  std::map<std::string, std::string> overrides_;  ///< path to the text after --set
};

}  // namespace eisph
