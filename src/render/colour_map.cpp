#include "render/colour_map.hpp"

#include "core/assets.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eisph {

namespace {

std::vector<std::string> known_maps(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool parse_row(const std::string& line, Colour& colour) {
  char rest = 0;
  const int fields = std::sscanf(line.c_str(), " %f , %f , %f %c", &colour.red, &colour.green, &colour.blue,
                                 &rest);  // NOLINT
  const auto valid = [](float channel) { return channel >= 0.0F && channel <= 1.0F; };
  return fields == 3 && valid(colour.red) && valid(colour.green) && valid(colour.blue);
}

}  // namespace

ColourMap ColourMap::load(const std::string& name) {
  const std::filesystem::path folder = home_folder() / "assets" / "colour_maps";
  const std::filesystem::path path = folder / (name + ".csv");
  const bool plain_name = name.find('/') == std::string::npos && !name.empty();
  if (!plain_name || !std::filesystem::exists(path)) {
    throw InputError(fmt::format("colour_map = \"{}\": no such table in {}; accepted: {}", name,
                                 folder.string(), fmt::join(known_maps(folder), ", ")));
  }
  return read(path);
}

ColourMap ColourMap::read(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: cannot be read", path.string()));
  Table table{};
  int rows = 0;
  int line_number = 0;
  for (std::string line; std::getline(file, line);) {
    ++line_number;
    if (line.empty() || line.front() == '#') continue;
    Colour colour;
    if (!parse_row(line, colour)) {
      throw InputError(fmt::format("{}:{}: '{}': three numbers from 0 to 1 with commas between are expected",
                                   path.string(), line_number, line));
    }
    if (rows < kSize) table[static_cast<std::size_t>(rows)] = colour;
    ++rows;
  }
  if (rows != kSize)
    throw InputError(fmt::format("{}: {} colours, {} are expected", path.string(), rows, kSize));
  return ColourMap(table);
}

ColourMap ColourMap::two_colours(const Colour& first, const Colour& second) {
  Table table{};
  std::fill(table.begin(), table.begin() + kSize / 2, first);
  std::fill(table.begin() + kSize / 2, table.end(), second);
  return ColourMap(table);
}

Colour ColourMap::at(double fraction) const {
  if (!(fraction > 0.0)) return table_.front();
  if (fraction >= 1.0) return table_.back();
  const double row = fraction * (kSize - 1);
  const auto lower = static_cast<std::size_t>(row);
  return mix(table_[lower], table_[std::min<std::size_t>(lower + 1, kSize - 1)],
             static_cast<float>(row - static_cast<double>(lower)));
}

}  // namespace eisph
