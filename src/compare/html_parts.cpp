#include "compare/html_parts.hpp"

#include "compare/html_text.hpp"
#include "compare/report_style.hpp"
#include "compare/whole_file.hpp"

#include <fmt/format.h>

namespace eisph {

std::string html_page_start(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style></head><body>\n",
      html_escaped(title), kReportStyle);
}

std::string html_page_end() { return "</body></html>\n"; }

std::string html_paragraph(const std::string& text) {
  return text.empty() ? "" : "<p>" + html_escaped(text) + "</p>\n";
}

std::string html_header_row(const std::vector<std::string>& names) {
  std::string row = "<tr>";
  for (const std::string& name : names) row += "<th>" + html_escaped(name) + "</th>";
  return row + "</tr>\n";
}

std::string html_rows(const std::string& rows) {
  return "<div class=\"scroll\"><table>\n" + rows + "</table></div>\n";
}

std::string html_table(const ReportTable& table) {
  std::string rows = html_header_row(table.columns);
  for (const std::vector<std::string>& row : table.rows) {
    rows += "<tr>";
    for (const std::string& cell : row) rows += "<td>" + html_escaped(cell) + "</td>";
    rows += "</tr>\n";
  }
  return "<h3>" + html_escaped(table.caption) + "</h3>\n" + html_rows(rows);
}

std::string html_figure(const ReportFigure& figure) {
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\">\n<figcaption>{0}</figcaption></figure>\n",
      html_escaped(figure.caption), base64(read_whole_file(figure.path)));
}

}  // namespace eisph
