#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

/// A table of coloured cells with a word in each.
struct StatusMap {
  struct Cell {
    std::string colour = {};  ///< "#rrggbb"
    std::string text = {};
  };
  struct Key {
    std::string colour = {};
    std::string meaning = {};
  };
  std::string title = {};
  std::vector<std::string> columns = {};
  std::vector<std::string> rows = {};  ///< from top to bottom
  std::vector<Cell> cells = {};        ///< row by row
  std::vector<Key> keys = {};          ///< of the colours
};

/// Draws a PNG with gnuplot. Throws std::invalid_argument unless there is a cell for every row and column,
/// std::runtime_error if gnuplot is missing or fails or the file cannot be written.
void write_status_map(const std::filesystem::path& path, const StatusMap& map);

}  // namespace eisph
