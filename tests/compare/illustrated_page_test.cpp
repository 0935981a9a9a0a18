#include "compare/illustrated_page.hpp"

#include "compare/whole_file.hpp"
#include "core/child_program.hpp"
#include "core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(IllustratedPage, HoldsItsSectionsWithTextEscapedAndPicturesEmbedded) {
  const ScratchFolder folder;
  write_whole_file(folder / "picture.png", "not really a picture");
  IllustratedPage page{
      .title = "Depth < 5 mm & more", .subtitle = "eisph", .warning = "synthetic", .sections = {}};
  page.sections.push_back({.title = "Statistics",
                           .paragraphs = {"first", ""},
                           .tables = {{.caption = "Table", .columns = {"a", "b"}, .rows = {{"1", "<2>"}}}},
                           .figures = {{folder / "picture.png", "A \"figure\""}}});
  write_illustrated_page(folder / "page.html", page);
  const std::string html = read_whole_file(folder / "page.html");
  EXPECT_THAT(html, HasSubstr("<h1>Depth &lt; 5 mm &amp; more</h1>"));
  EXPECT_THAT(html, HasSubstr("synthetic"));
  EXPECT_THAT(html, HasSubstr("<p>first</p>"));
  EXPECT_THAT(html, HasSubstr("<td>&lt;2&gt;</td>"));
  EXPECT_THAT(html, HasSubstr("base64,bm90IHJlYWxseSBhIHBpY3R1cmU="));
  EXPECT_THAT(html, Not(HasSubstr("picture.png")));
  EXPECT_THAT(html, Not(HasSubstr("<p></p>")));
}

TEST(IllustratedPage, AMissingPictureLeavesNoPage) {
  const ScratchFolder folder;
  IllustratedPage page{.title = "t", .subtitle = {}, .warning = {}, .sections = {}};
  page.sections.push_back(
      {.title = "s", .paragraphs = {}, .tables = {}, .figures = {{folder / "none.png", "c"}}});
  EXPECT_THROW(write_illustrated_page(folder / "page.html", page), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "page.html"));
}

}  // namespace
}  // namespace eisph
