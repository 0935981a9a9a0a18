#pragma once

#include "core/error.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace eisph {

/// The cases asked for by name, in the order of `all`; all of them without any name. `command` is for the
/// error: throws InputError for a name that no case has.
template <class Case>
std::vector<const Case*> choose_cases(const std::string& command, const std::vector<Case>& all,
                                      const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::any_of(all.begin(), all.end(), [&](const Case& known) { return known.name == name; })) continue;
    std::string known_names;
    for (const Case& known : all) known_names += (known_names.empty() ? "" : ", ") + known.name;
    throw InputError(fmt::format("{} {}: no such case; expected {}", command, name, known_names));
  }
  std::vector<const Case*> chosen;
  for (const Case& known : all) {
    if (names.empty() || std::count(names.begin(), names.end(), known.name) > 0) chosen.push_back(&known);
  }
  return chosen;
}

/// The entries of `all` whose name, as `name_of` tells it, contains one of the texts from the beginning of a
/// word on (ISPH is not in EISPH); all of them without any text. `option` is for the error: throws InputError
/// for a text that is in no name.
template <class Entry, class NameOf>
std::vector<Entry> choose_by_text(const std::string& option, const std::vector<Entry>& all,
                                  const NameOf& name_of, const std::vector<std::string>& texts) {
  const auto has = [&](const Entry& entry, const std::string& text) {
    const std::string name = name_of(entry);
    for (std::size_t at = name.find(text); at != std::string::npos; at = name.find(text, at + 1)) {
      if (at == 0 || std::isalnum(static_cast<unsigned char>(name[at - 1])) == 0) return true;
    }
    return false;
  };
  for (const std::string& text : texts) {
    if (std::any_of(all.begin(), all.end(), [&](const Entry& entry) { return has(entry, text); })) continue;
    std::string names;
    for (const Entry& entry : all) names += (names.empty() ? "'" : ", '") + name_of(entry) + "'";
    throw InputError(fmt::format("{} {}: no name has that in it; there are {}", option, text, names));
  }
  std::vector<Entry> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [&](const Entry& entry) {
    return texts.empty() ||
           std::any_of(texts.begin(), texts.end(), [&](const std::string& text) { return has(entry, text); });
  });
  return chosen;
}

}  // namespace eisph
