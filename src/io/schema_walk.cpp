#include "io/schema_walk.hpp"

#include "io/schema_value.hpp"

#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eisph {

namespace {

constexpr std::size_t kColumns = 110;

/// Breaks `text` at spaces; the first line follows `lead`, the others are indented by `indent`.
std::string wrapped(const std::string& lead, const std::string& text, std::size_t indent) {
  std::string result;
  std::string line = lead;
  bool fresh = true;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!fresh && line.size() + 1 + word.size() > kColumns) {
      result += line + "\n";
      line = std::string(indent, ' ');
      fresh = true;
    }
    line += (fresh ? "" : " ") + word;
    fresh = false;
  }
  return result + line + "\n";
}

}  // namespace

std::string KeyText::expected() const { return unit.empty() ? type : fmt::format("{}, in {}", type, unit); }

const toml::table& SectionReader::section(const std::string& path, const toml::node& node) const {
  if (!node.is_table()) source.fail(path, fmt::format("expected a section [{}]", path));
  return *node.as_table();
}

void SectionReader::fail_unknown(const std::string& path, const std::string& name, const toml::node& node,
                                 const std::vector<std::string>& accepted) const {
  const std::string nearest = nearest_word(name, accepted);
  const std::string hint = nearest.empty() ? "" : fmt::format("did you mean {}? ", nearest);
  source.fail(path, fmt::format("unknown {}; {}accepted here: {}", node.is_table() ? "section" : "key", hint,
                                fmt::join(accepted, ", ")));
}

void SectionWriter::header(const std::string& path, bool repeated) {
  text += repeated ? fmt::format("\n[[{}]]\n", path) : fmt::format("\n[{}]\n", path);
}

void SectionWriter::line(const std::string& name, const std::string& value) {
  if (!value.empty()) text += fmt::format("{} = {}\n", name, value);
}

void SchemaWriter::header(const std::string& path, bool repeated, const std::string& meaning) {
  text += wrapped(repeated ? fmt::format("\n[[{}]] ", path) : fmt::format("\n[{}] ", path), meaning, 4);
}

void SchemaWriter::key(const KeyText& key) {
  std::string facts = key.expected();
  if (!key.condition.empty()) facts += fmt::format("; {}", key.condition);
  if (key.required) {
    facts += "; required";
  } else if (!key.fallback.empty()) {
    facts += fmt::format("; default {}", key.fallback);
  }
  text += wrapped(fmt::format("  {:<22} ", key.name), facts, 25);
  text += wrapped("      ", key.meaning, 6);
}

}  // namespace eisph
