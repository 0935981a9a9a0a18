#include "compare/illustrated_page.hpp"

#include "compare/html_parts.hpp"
#include "compare/html_text.hpp"
#include "compare/whole_file.hpp"

#include <fmt/format.h>

namespace eisph {

void write_illustrated_page(const std::filesystem::path& path, const IllustratedPage& page) {
  std::string html = html_page_start(page.title);
  html += fmt::format("<h1>{}</h1>\n", html_escaped(page.title));
  if (!page.subtitle.empty()) html += fmt::format("<p class=\"faint\">{}</p>\n", html_escaped(page.subtitle));
  if (!page.warning.empty())
    html += fmt::format("<p class=\"verdict bad\"><b>{}</b></p>\n", html_escaped(page.warning));
  for (const PageSection& section : page.sections) {
    html += fmt::format("<h2>{}</h2>\n", html_escaped(section.title));
    for (const std::string& text : section.paragraphs) html += html_paragraph(text);
    for (const ReportTable& table : section.tables) html += html_table(table);
    for (const ReportFigure& figure : section.figures) html += html_figure(figure);
  }
  write_whole_file(path, html + html_page_end());
}

}  // namespace eisph
