#pragma once

#include "io/toml_source.hpp"

#include <string>
#include <vector>

namespace eisph {

/// What the reference and the error messages say about a key.
struct KeyText {
  std::string name{};
  std::string type{};  ///< as in "expected <type>", range included
  std::string unit{};
  std::string meaning{};
  std::string fallback{};   ///< the default
  std::string condition{};  ///< when the key is accepted; empty: always
  bool required = false;

  /// Type, range and unit.
  [[nodiscard]] std::string expected() const;
};

/// Reads sections out of a source into their structures.
struct SectionReader {
  TomlSource& source;
  int dimension = 3;

  /// The table under `path`, or an error if something else stands there.
  [[nodiscard]] const toml::table& section(const std::string& path, const toml::node& node) const;
  [[noreturn]] void fail_unknown(const std::string& path, const std::string& name, const toml::node& node,
                                 const std::vector<std::string>& accepted) const;
};

/// Collects the text of a resolved scene.
struct SectionWriter {
  int dimension = 3;
  std::string text;

  void header(const std::string& path, bool repeated);
  void line(const std::string& name, const std::string& value);
};

/// Collects the reference of all keys.
struct SchemaWriter {
  std::string text;

  void header(const std::string& path, bool repeated, const std::string& meaning);
  void key(const KeyText& key);
};

}  // namespace eisph
