#pragma once

#include "render/colour.hpp"

#include <array>
#include <filesystem>
#include <string>

namespace eisph {

/// Table of 256 colours over the unit interval.
class ColourMap {
 public:
  static constexpr int kSize = 256;
  using Table = std::array<Colour, kSize>;

  /// Reads assets/colour_maps/<name>.csv of the home folder. Throws InputError, which lists the maps there
  /// are.
  static ColourMap load(const std::string& name);
  /// Reads a file of 256 rows red,green,blue (0 to 1); lines starting with # are comments. Throws InputError.
  static ColourMap read(const std::filesystem::path& path);
  /// First colour below 1/2, second from there on.
  static ColourMap two_colours(const Colour& first, const Colour& second);

  explicit ColourMap(const Table& table) : table_(table) {}

  /// Linear between the rows; clamped outside 0 to 1, and the lower end for not-a-number.
  [[nodiscard]] Colour at(double fraction) const;
  [[nodiscard]] const Table& table() const { return table_; }

 private:
  Table table_{};
};

}  // namespace eisph
