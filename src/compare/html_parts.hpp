#pragma once

#include "compare/report.hpp"

#include <string>
#include <vector>

namespace eisph {

// Pieces of the HTML pages that the program writes. Texts are escaped here; pictures are embedded.

/// Up to the body, with the style of all pages.
[[nodiscard]] std::string html_page_start(const std::string& title);
[[nodiscard]] std::string html_page_end();

/// Nothing for an empty text.
[[nodiscard]] std::string html_paragraph(const std::string& text);
[[nodiscard]] std::string html_header_row(const std::vector<std::string>& names);
/// A table of finished rows.
[[nodiscard]] std::string html_rows(const std::string& rows);
[[nodiscard]] std::string html_table(const ReportTable& table);
/// Throws InputError if the picture cannot be read.
[[nodiscard]] std::string html_figure(const ReportFigure& figure);

}  // namespace eisph
