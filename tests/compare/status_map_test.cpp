#include "compare/status_map.hpp"

#include "compare/picture.hpp"
#include "io/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(StatusMap, ColoursItsCells) {
  const TemporaryFolder folder;
  StatusMap map;
  map.title = "Map";
  map.columns = {"one", "two"};
  map.rows = {"upper", "lower"};
  map.cells = {{"#ff0000", ""}, {"#00ff00", "word"}, {"#00ff00", ""}, {"#00ff00", ""}};
  map.keys = {{"#ff0000", "red"}};
  const auto path = folder.path() / "map.png";
  write_status_map(path, map);
  const Picture picture = read_picture(path);
  const std::size_t red = picture.count(0xff0000);
  const std::size_t green = picture.count(0x00ff00);
  EXPECT_GT(red, 2000U);
  EXPECT_NEAR(static_cast<double>(green) / static_cast<double>(red), 2.6, 0.5)
      << "three cells with a word, against one and its key";
}

TEST(StatusMap, NeedsACellForEveryRowAndColumn) {
  StatusMap map;
  map.columns = {"one"};
  map.rows = {"upper", "lower"};
  map.cells = {{"#ff0000", ""}};
  EXPECT_THROW(write_status_map("map.png", map), std::invalid_argument);
}

}  // namespace
}  // namespace eisph
