#include "compare/status_map.hpp"

#include "compare/gnuplot.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr int kCellWidth = 120;  ///< pixels
constexpr int kCellHeight = 34;
constexpr int kNameWidth = 250;
constexpr int kTitleHeight = 110;
constexpr int kKeyHeight = 60;

std::string rectangle(int number, double left, double bottom, double right, double top,
                      const std::string& colour) {
  return fmt::format(
      "set object {} rectangle from {:.4f},{:.4f} to {:.4f},{:.4f} fillcolor rgb '{}' fillstyle "
      "solid 1.0 border rgb 'white' linewidth 2\n",
      number, left, bottom, right, top, colour);
}

std::string label(double x, double y, const std::string& text, const char* place) {
  return fmt::format("set label {} at {:.4f},{:.4f} {} front\n", gnuplot_quoted(text), x, y, place);
}

}  // namespace

void write_status_map(const std::filesystem::path& path, const StatusMap& map) {
  if (map.rows.empty() || map.columns.empty() || map.cells.size() != map.rows.size() * map.columns.size()) {
    throw std::invalid_argument("a status map needs a cell for every row and column");
  }
  const auto columns = static_cast<int>(map.columns.size());
  const auto rows = static_cast<int>(map.rows.size());
  const int width = kNameWidth + kCellWidth * columns + 20;
  const int height = kTitleHeight + kCellHeight * rows + kKeyHeight;
  std::string script = gnuplot_preamble(width, height);
  script += fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\nset bmargin "
      "at "
      "screen {:.5f}\n",
      static_cast<double>(kNameWidth) / width, 1.0 - 20.0 / width,
      1.0 - static_cast<double>(kTitleHeight) / height, static_cast<double>(kKeyHeight) / height);
  script += fmt::format(
      "unset grid\nunset tics\nunset border\nunset key\nset title {} offset 0,2.2\nset xrange [0:{}]\nset "
      "yrange "
      "[0:{}]\n",
      gnuplot_quoted(map.title), columns, rows);
  int number = 1;
  for (int r = 0; r < rows; ++r) {
    const double bottom = rows - 1 - r;
    script += label(-0.08, bottom + 0.5, map.rows[static_cast<std::size_t>(r)], "right");
    for (int c = 0; c < columns; ++c) {
      const StatusMap::Cell& cell = map.cells[static_cast<std::size_t>(r * columns + c)];
      script += rectangle(number++, c, bottom, c + 1.0, bottom + 1.0, cell.colour);
      if (!cell.text.empty()) script += label(c + 0.5, bottom + 0.5, cell.text, "center");
    }
  }
  for (int c = 0; c < columns; ++c) {
    script += label(c + 0.5, rows + 0.45, map.columns[static_cast<std::size_t>(c)], "center");
  }
  double x = 0.0;
  const double share =
      static_cast<double>(columns) / static_cast<double>(std::max<std::size_t>(1, map.keys.size()));
  for (const StatusMap::Key& key : map.keys) {
    script += rectangle(number++, x, -1.0, x + 0.2, -0.5, key.colour);
    script += label(x + 0.28, -0.75, key.meaning, "left");
    x += share;
  }
  run_gnuplot(path, script + "plot NaN notitle\n");
}

}  // namespace eisph
