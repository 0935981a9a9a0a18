#pragma once

#include "core/error.hpp"

#include <algorithm>
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

}  // namespace eisph
