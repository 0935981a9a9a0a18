#include "compare/status_map.hpp"

#include "compare/gnuplot.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr int kCellWidth = 120;  ///< pixels, at least
constexpr int kCharacterWidth = 9;
constexpr int kCellHeight = 34;
constexpr int kNameWidth = 250;
constexpr int kTitleHeight = 110;
constexpr int kKeyHeight = 60;
constexpr int kKeyWidth = 140;

std::string rectangle(int number, const std::string& from, const std::string& to, const std::string& colour) {
  return fmt::format(
      "set object {} rectangle from {} to {} fillcolor rgb '{}' fillstyle solid 1.0 border rgb 'white' "
      "linewidth 2 noclip\n",
      number, from, to, colour);
}

std::string place(double x, double y) { return fmt::format("{:.4f},{:.4f}", x, y); }
std::string screen_place(double x, double y) { return fmt::format("screen {:.5f}, screen {:.5f}", x, y); }

std::string label(const std::string& at, const std::string& text, const char* side) {
  return fmt::format("set label {} at {} {} front\n", gnuplot_quoted(text), at, side);
}

}  // namespace

void write_status_map(const std::filesystem::path& path, const StatusMap& map) {
  if (map.rows.empty() || map.columns.empty() || map.cells.size() != map.rows.size() * map.columns.size()) {
    throw std::invalid_argument("a status map needs a cell for every row and column");
  }
  const auto columns = static_cast<int>(map.columns.size());
  const auto rows = static_cast<int>(map.rows.size());
  int cell_width = kCellWidth;
  for (const std::string& name : map.columns) {
    cell_width = std::max(cell_width, kCharacterWidth * static_cast<int>(name.size()) + 10);
  }
  const int width = kNameWidth + cell_width * columns + 20;
  const int height = kTitleHeight + kCellHeight * rows + kKeyHeight;
  std::string script = gnuplot_preamble(width, height);
  script += fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\nset bmargin "
      "at screen {:.5f}\n",
      static_cast<double>(kNameWidth) / width, 1.0 - 20.0 / width,
      1.0 - static_cast<double>(kTitleHeight) / height, static_cast<double>(kKeyHeight) / height);
  script +=
      fmt::format("unset grid\nunset tics\nunset border\nunset key\nset xrange [0:{}]\nset yrange [0:{}]\n",
                  columns, rows);
  const double pixel_x = 1.0 / width;
  const double pixel_y = 1.0 / height;
  script += label(screen_place(20 * pixel_x, 1.0 - 30 * pixel_y), map.title, "left");
  int number = 1;
  for (int r = 0; r < rows; ++r) {
    const double bottom = rows - 1 - r;
    script += label(place(-0.08, bottom + 0.5), map.rows[static_cast<std::size_t>(r)], "right");
    for (int c = 0; c < columns; ++c) {
      const StatusMap::Cell& cell =
          map.cells[static_cast<std::size_t>(r) * map.columns.size() + static_cast<std::size_t>(c)];
      script += rectangle(number++, place(c, bottom), place(c + 1.0, bottom + 1.0), cell.colour);
      if (!cell.text.empty()) script += label(place(c + 0.5, bottom + 0.5), cell.text, "center");
    }
  }
  for (int c = 0; c < columns; ++c) {
    script += label(place(c + 0.5, rows + 0.6), map.columns[static_cast<std::size_t>(c)], "center");
  }
  double x = 20 * pixel_x;
  for (const StatusMap::Key& key : map.keys) {
    script += rectangle(number++, screen_place(x, 18 * pixel_y), screen_place(x + 24 * pixel_x, 38 * pixel_y),
                        key.colour);
    script += label(screen_place(x + 32 * pixel_x, 28 * pixel_y), key.meaning, "left");
    x += kKeyWidth * pixel_x;
  }
  run_gnuplot(path, script + "plot NaN notitle\n");
}

}  // namespace eisph
