#pragma once

#include "io/schema_value.hpp"
#include "io/schema_walk.hpp"
#include "io/toml_source.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace eisph {

// A KeyTable lists the keys of one section of a scene file together with the member that each sets. Reading,
// writing and the printed reference all walk the same table. `Owner` is the structure that the section fills.

template <class Owner>
struct Key {
  KeyText text;
  std::function<bool(const toml::node&, int dimension, Owner&)> read;  ///< false: not accepted
  std::function<std::string(const Owner&, int dimension)> write;       ///< empty: nothing to write
  std::function<bool(const Owner&, int dimension)> applies = [](const Owner&, int) { return true; };

  Key& required() {
    text.required = true;
    return *this;
  }
  /// Describes a default that depends on other keys.
  Key& fallback(const std::string& description) {
    text.fallback = description;
    return *this;
  }
  Key& when(const std::string& condition, std::function<bool(const Owner&, int dimension)> predicate) {
    text.condition = condition;
    applies = std::move(predicate);
    return *this;
  }
};

/// A section inside a section: how to read, write and describe it.
template <class Owner>
struct Section {
  std::string name;
  std::function<void(SectionReader&, const std::string& path, const toml::node*, Owner&)> read;
  std::function<void(SectionWriter&, const std::string& path, const Owner&)> write;
  std::function<void(SchemaWriter&, const std::string& path)> describe;
};

template <class Owner>
class KeyTable {
 public:
  // One function per type of key; `field` is a member pointer or a function from the owner to a reference.
  template <class Field>
  Key<Owner>& number(const std::string& name, const std::string& unit, Field field, const NumberRange& range,
                     const std::string& meaning) {
    const std::string type = range.text().empty() ? "a number" : "a number " + range.text();
    return add(
        {.name = name, .type = type, .unit = unit, .meaning = meaning},
        [=](const toml::node& node, int, Owner& owner) {
          return read_number(node, range, std::invoke(field, owner));
        },
        [=](const Owner& owner, int) { return write_number(std::invoke(field, owner)); });
  }

  template <class Field>
  Key<Owner>& integer(const std::string& name, const std::string& unit, Field field, const NumberRange& range,
                      const std::string& meaning) {
    return add(
        {.name = name, .type = "a whole number " + range.text(), .unit = unit, .meaning = meaning},
        [=](const toml::node& node, int, Owner& owner) {
          long long value = 0;
          if (!read_integer(node, range, value)) return false;
          auto& member = std::invoke(field, owner);
          member = static_cast<std::decay_t<decltype(member)>>(value);
          return true;
        },
        [=](const Owner& owner, int) { return std::to_string(std::invoke(field, owner)); });
  }

  template <class Field>
  Key<Owner>& boolean(const std::string& name, Field field, const std::string& meaning) {
    return add(
        {.name = name, .type = "true or false", .meaning = meaning},
        [=](const toml::node& node, int, Owner& owner) { return read_bool(node, std::invoke(field, owner)); },
        [=](const Owner& owner, int) { return write_bool(std::invoke(field, owner)); });
  }

  template <class Field>
  Key<Owner>& string(const std::string& name, Field field, const std::string& meaning) {
    return add(
        {.name = name, .type = "a text", .meaning = meaning},
        [=](const toml::node& node, int, Owner& owner) { return read_text(node, std::invoke(field, owner)); },
        [=](const Owner& owner, int) { return write_text(std::invoke(field, owner)); });
  }

  template <class Field>
  Key<Owner>& identifier(const std::string& name, Field field, const std::string& meaning) {
    return add(
        {.name = name, .type = "a name of letters, digits, _ and -", .meaning = meaning},
        [=](const toml::node& node, int, Owner& owner) { return read_name(node, std::invoke(field, owner)); },
        [=](const Owner& owner, int) { return write_text(std::invoke(field, owner)); });
  }

  /// A file or folder; where it stands, TomlSource::resolve_file() tells.
  template <class Field>
  Key<Owner>& path(const std::string& name, Field field, const std::string& meaning) {
    return add(
        {.name = name, .type = "a path, from the folder of this file", .meaning = meaning},
        [=](const toml::node& node, int, Owner& owner) {
          std::string text;
          if (!read_text(node, text) || text.empty()) return false;
          std::invoke(field, owner) = text;
          return true;
        },
        [=](const Owner& owner, int) {
          const std::filesystem::path& path = std::invoke(field, owner);
          return path.empty() ? std::string() : write_text(path.string());
        });
  }

  template <class Field>
  Key<Owner>& vector(const std::string& name, const std::string& unit, Field field,
                     const std::string& meaning) {
    return add(
        {.name = name, .type = "a list [x, y, z] of numbers, in 2D [x, z]", .unit = unit, .meaning = meaning},
        [=](const toml::node& node, int dimension, Owner& owner) {
          return read_vector(node, dimension, std::invoke(field, owner));
        },
        [=](const Owner& owner, int dimension) {
          return write_vector(std::invoke(field, owner), dimension);
        });
  }

  template <class Field>
  Key<Owner>& instants(const std::string& name, Field field, const std::string& meaning) {
    return add(
        {.name = name, .type = "a list of rising times, each at least 0", .unit = "s", .meaning = meaning},
        [=](const toml::node& node, int, Owner& owner) {
          return read_ascending(node, at_least(0.0), std::invoke(field, owner));
        },
        [=](const Owner& owner, int) { return write_numbers(std::invoke(field, owner)); });
  }

  /// One of a few words, each standing for a value of the field.
  template <class Value, class Field>
  Key<Owner>& choice(const std::string& name, Field field,
                     const std::vector<std::pair<std::string, Value>>& choices, const std::string& meaning) {
    std::string type = "one of";
    for (const auto& [word, value] : choices) type += (type == "one of" ? " \"" : ", \"") + word + "\"";
    return add(
        {.name = name, .type = type, .meaning = meaning},
        [=](const toml::node& node, int, Owner& owner) {
          std::string text;
          if (!read_text(node, text)) return false;
          for (const auto& [word, value] : choices) {
            if (word != text) continue;
            std::invoke(field, owner) = value;
            return true;
          }
          return false;
        },
        [=](const Owner& owner, int) {
          for (const auto& [word, value] : choices) {
            if (value == std::invoke(field, owner)) return write_text(word);
          }
          return std::string();
        });
  }

  /// A key of another form.
  template <class Read, class Write>
  Key<Owner>& add(const KeyText& text, Read read, Write write) {
    Key<Owner> key{.text = text, .read = std::move(read), .write = std::move(write)};
    key.text.fallback = key.write(Owner{}, 3);
    keys_.push_back(std::move(key));
    return keys_.back();
  }

  /// A section [name] that fills `field`.
  template <class Field, class Inner>
  void section(const std::string& name, Field field, const KeyTable<Inner>& table,
               const std::string& meaning) {
    sections_.push_back(
        {name,
         [=](SectionReader& reader, const std::string& path, const toml::node* node, Owner& owner) {
           const toml::table empty;
           table.read(reader, path, node == nullptr ? empty : reader.section(path, *node),
                      std::invoke(field, owner));
         },
         [=](SectionWriter& writer, const std::string& path, const Owner& owner) {
           writer.header(path, false);
           table.write(writer, path, std::invoke(field, owner));
         },
         [=](SchemaWriter& writer, const std::string& path) {
           writer.header(path, false, meaning);
           table.describe(writer, path);
         }});
  }

  /// A section [name] that may be missing; `field` is an optional.
  template <class Field, class Inner>
  void optional_section(const std::string& name, Field field, const KeyTable<Inner>& table,
                        const std::string& meaning) {
    sections_.push_back(
        {name,
         [=](SectionReader& reader, const std::string& path, const toml::node* node, Owner& owner) {
           if (node == nullptr) return;
           table.read(reader, path, reader.section(path, *node), std::invoke(field, owner).emplace());
         },
         [=](SectionWriter& writer, const std::string& path, const Owner& owner) {
           if (!std::invoke(field, owner)) return;
           writer.header(path, false);
           table.write(writer, path, *std::invoke(field, owner));
         },
         [=](SchemaWriter& writer, const std::string& path) {
           writer.header(path, false, meaning);
           table.describe(writer, path);
         }});
  }

  /// A list of sections [[name]]; `field` is a vector. With `alias_of` the entries go on the same vector as
  /// those of another list, which writes them.
  template <class Field, class Inner>
  void list(const std::string& name, Field field, const KeyTable<Inner>& table, const std::string& meaning,
            const std::string& alias_of = "") {
    sections_.push_back(
        {name,
         [=](SectionReader& reader, const std::string& path, const toml::node* node, Owner& owner) {
           if (node == nullptr) return;
           const toml::array* entries = node->as_array();
           if (entries == nullptr) reader.source.fail(path, "expected sections [[" + path + "]]");
           for (std::size_t k = 0; k < entries->size(); ++k) {
             const std::string entry_path = path + "." + std::to_string(k);
             reader.source.record(entry_path, (*entries)[k]);
             table.read(reader, entry_path, reader.section(entry_path, (*entries)[k]),
                        std::invoke(field, owner).emplace_back());
           }
         },
         [=](SectionWriter& writer, const std::string& path, const Owner& owner) {
           if (!alias_of.empty()) return;
           for (const Inner& entry : std::invoke(field, owner)) {
             writer.header(path, true);
             table.write(writer, path, entry);
           }
         },
         [=](SchemaWriter& writer, const std::string& path) {
           writer.header(path, true, meaning);
           if (alias_of.empty()) table.describe(writer, path);
         }});
  }

  void read(SectionReader& reader, const std::string& path, const toml::table& values, Owner& owner) const {
    const std::string prefix = path.empty() ? "" : path + ".";
    reject_unknown(reader, prefix, values);
    for (const Key<Owner>& key : keys_) {
      const std::string key_path = prefix + key.text.name;
      const toml::node* node = values.get(key.text.name);
      const bool applies = key.applies(owner, reader.dimension);
      if (node == nullptr) {
        if (applies && key.text.required)
          reader.source.fail(key_path, "missing; expected " + key.text.expected());
        continue;
      }
      if (!applies) reader.source.fail(key_path, "only accepted " + key.text.condition);
      if (!key.read(*node, reader.dimension, owner)) {
        reader.source.fail(key_path, "expected " + key.text.expected());
      }
    }
    for (const Section<Owner>& inner : sections_) {
      inner.read(reader, prefix + inner.name, values.get(inner.name), owner);
    }
  }

  void write(SectionWriter& writer, const std::string& path, const Owner& owner) const {
    for (const Key<Owner>& key : keys_) {
      if (key.applies(owner, writer.dimension))
        writer.line(key.text.name, key.write(owner, writer.dimension));
    }
    for (const Section<Owner>& inner : sections_) {
      inner.write(writer, path.empty() ? inner.name : path + "." + inner.name, owner);
    }
  }

  void describe(SchemaWriter& writer, const std::string& path) const {
    for (const Key<Owner>& key : keys_) writer.key(key.text);
    for (const Section<Owner>& inner : sections_) {
      inner.describe(writer, path.empty() ? inner.name : path + "." + inner.name);
    }
  }

 private:
  /// Remembers where every value stands, and stops at one that the table does not know.
  void reject_unknown(SectionReader& reader, const std::string& prefix, const toml::table& values) const {
    std::vector<std::string> accepted;
    for (const Key<Owner>& key : keys_) accepted.push_back(key.text.name);
    for (const Section<Owner>& inner : sections_) accepted.push_back(inner.name);
    for (const auto& [name, node] : values) {
      const std::string word(name.str());
      reader.source.record(prefix + word, node);
      if (std::find(accepted.begin(), accepted.end(), word) == accepted.end()) {
        reader.fail_unknown(prefix + word, word, node, accepted);
      }
    }
  }

  std::vector<Key<Owner>> keys_;
  std::vector<Section<Owner>> sections_;
};

}  // namespace eisph
