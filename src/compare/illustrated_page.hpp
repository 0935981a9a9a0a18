#pragma once

#include "compare/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace eisph {

/// A part of a page: paragraphs, then tables, then figures.
struct PageSection {
  std::string title = {};
  std::vector<std::string> paragraphs = {};
  std::vector<ReportTable> tables = {};
  std::vector<ReportFigure> figures = {};
};

struct IllustratedPage {
  std::string title = {};
  std::string subtitle = {};  ///< program, date, machine
  std::string warning = {};   ///< stands out at the top; empty: none
  std::vector<PageSection> sections = {};
};

/// Writes one HTML file that needs nothing else: figures are embedded. Throws InputError if a figure cannot
/// be read, std::runtime_error if the file cannot be written; an older one is then unchanged.
void write_illustrated_page(const std::filesystem::path& path, const IllustratedPage& page);

}  // namespace eisph
