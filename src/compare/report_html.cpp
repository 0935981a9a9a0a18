#include "compare/html_parts.hpp"
#include "compare/html_text.hpp"
#include "compare/report.hpp"
#include "compare/whole_file.hpp"

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

/// The values of an earlier report by case and metric.
using EarlierValues = std::map<std::pair<std::string, std::string>, MetricChange>;

std::string number_text(double value) {
  if (std::isnan(value)) return "not a number";
  const double size = std::abs(value);
  return value == std::round(value) && size < 1e6 ? fmt::format("{:.0f}", value)
                                                  : fmt::format("{:.4g}", value);
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return html_escaped(unit.empty() || unit == "-" ? number : number + " " + unit);
}

std::string limit_text(const Metric& metric) {
  if (metric.lower && metric.upper) {
    return fmt::format("{} to {}", number_text(*metric.lower), number_text(*metric.upper));
  }
  if (metric.lower) return "at least " + number_text(*metric.lower);
  if (metric.upper) return "at most " + number_text(*metric.upper);
  return "";
}

std::string result_text(bool holds) {
  return holds ? R"(<span class="holds">holds</span>)" : R"(<span class="fails">DOES NOT HOLD</span>)";
}

std::string labelled(const std::string& label, const std::string& text) {
  return text.empty() ? "" : fmt::format("<p><b>{}</b> {}</p>\n", label, html_escaped(text));
}

std::string number_cell(const std::string& text) { return "<td class=\"number\">" + text + "</td>"; }

std::string earlier_cells(const CaseReport& report, const std::string& metric, const EarlierValues* earlier) {
  if (earlier == nullptr) return "";
  const auto found = earlier->find({report.name, metric});
  if (found == earlier->end() || !found->second.before) return number_cell("none") + number_cell("");
  const double ratio = found->second.ratio();
  return number_cell(number_text(*found->second.before)) +
         number_cell(std::isnan(ratio) ? "" : fmt::format("{:.3f}", ratio));
}

std::string metric_table(const CaseReport& report, const EarlierValues* earlier) {
  if (report.metrics.empty()) return "";
  std::string rows =
      "<tr><th>Quantity</th><th class=\"number\">Value</th><th>Unit</th><th>Limit</th><th>Result</th>";
  if (earlier != nullptr) rows += "<th class=\"number\">Earlier</th><th class=\"number\">Ratio</th>";
  rows += "<th>Note</th></tr>\n";
  for (const Metric& metric : report.metrics) {
    const bool fails = metric.has_limit() && !metric.holds();
    rows += fails ? "<tr class=\"fails-row\">" : "<tr>";
    rows += "<td>" + html_escaped(metric.name) + "</td>" + number_cell(number_text(metric.value)) + "<td>" +
            html_escaped(metric.unit) + "</td><td>" + limit_text(metric) + "</td><td>" +
            (metric.has_limit() ? result_text(!fails) : "for information") + "</td>" +
            earlier_cells(report, metric.name, earlier) + "<td>" + html_escaped(metric.note) + "</td></tr>\n";
  }
  return html_rows(rows);
}

std::string run_table(const CaseReport& report, const EarlierValues* earlier) {
  std::string rows = "<tr><th>Figure</th><th class=\"number\">Value</th><th>Unit</th>";
  if (earlier != nullptr) rows += "<th class=\"number\">Earlier</th><th class=\"number\">Ratio</th>";
  rows += "</tr>\n";
  for (const Metric& metric : run_metrics(report.run)) {
    rows += "<tr><td>" + html_escaped(metric.name) + "</td>" + number_cell(number_text(metric.value)) +
            "<td>" + html_escaped(metric.unit) + "</td>" + earlier_cells(report, metric.name, earlier) +
            "</tr>\n";
  }
  return "<h3>Runs</h3>\n" + html_rows(rows);
}

std::string anchor(std::size_t number) { return fmt::format("case-{}", number + 1); }

std::string case_section(const CaseReport& report, std::size_t number, const EarlierValues* earlier) {
  std::string html = fmt::format("<h2 id=\"{}\">{} <span class=\"faint\">({})</span></h2>\n", anchor(number),
                                 html_escaped(report.title), html_escaped(report.name));
  html += labelled("Source:", report.source) + labelled("Simulated:", report.description) +
          labelled("Compared:", report.comparison);
  if (!report.failure.empty()) {
    html += fmt::format("<p class=\"verdict bad\"><b>This case could not be carried out:</b> {}</p>\n",
                        html_escaped(report.failure));
  }
  html += metric_table(report, earlier);
  for (const ReportFigure& figure : report.figures) html += html_figure(figure);
  for (const ReportTable& table : report.tables) html += html_table(table);
  if (!report.notes.empty()) html += "<h3>Notes</h3>\n";
  for (const std::string& note : report.notes) html += html_paragraph(note);
  if (report.run.steps > 0) html += run_table(report, earlier);
  return html;
}

/// The figures of a case that have limits, those first that do not hold.
std::string key_errors(const CaseReport& report) {
  std::string text;
  for (const bool holds : {false, true}) {
    for (const Metric& metric : report.metrics) {
      if (!metric.has_limit() || metric.holds() != holds) continue;
      if (!text.empty()) text += "<br>";
      text += fmt::format("{}{} {} <span class=\"faint\">({})</span>", holds ? "" : "<b>DOES NOT HOLD:</b> ",
                          html_escaped(metric.name), with_unit(number_text(metric.value), metric.unit),
                          limit_text(metric));
    }
  }
  return text;
}

std::string summary_table(const Report& report) {
  std::string rows =
      "<tr><th>Case</th><th>Result</th><th class=\"number\">Limits held</th><th>Figures with limits</th>"
      "<th class=\"number\">Wall clock</th><th class=\"number\">Million particle-steps per "
      "second</th></tr>\n";
  for (std::size_t k = 0; k < report.cases.size(); ++k) {
    const CaseReport& one = report.cases[k];
    const bool has_run = one.run.steps > 0;
    rows += one.holds() ? "<tr>" : "<tr class=\"fails-row\">";
    rows += fmt::format(
        "<td><a href=\"#{}\">{}</a></td><td>{}</td>", anchor(k), html_escaped(one.name),
        one.failure.empty() ? result_text(one.holds()) : "<span class=\"fails\">NOT CARRIED OUT</span>");
    rows += number_cell(fmt::format("{} of {}", one.limits_held(), one.limits())) + "<td class=\"wide\">" +
            key_errors(one) + "</td>" +
            number_cell(has_run ? fmt::format("{:.1f} s", one.run.wall_clock) : "") +
            number_cell(has_run ? fmt::format("{:.2f}", 1e-6 * one.run.particle_steps_per_second) : "") +
            "</tr>\n";
  }
  return html_rows(rows);
}

std::string verdict(const Report& report) {
  std::size_t limits = 0;
  std::size_t held = 0;
  std::size_t failures = 0;
  for (const CaseReport& one : report.cases) {
    limits += one.limits();
    held += one.limits_held();
    failures += one.failure.empty() ? 0 : 1;
  }
  std::string text = report.holds() ? fmt::format("All {} limits hold.", limits)
                                    : fmt::format("{} of {} limits do not hold.", limits - held, limits);
  if (failures > 0)
    text += fmt::format(" {} of {} cases could not be carried out.", failures, report.cases.size());
  return fmt::format("<p class=\"verdict{}\"><b>{}</b></p>\n", report.holds() ? "" : " bad", text);
}

/// What only the earlier report has.
std::string missing_table(const std::vector<MetricChange>& changes) {
  std::string rows;
  for (const MetricChange& change : changes) {
    if (change.now) continue;
    rows += "<tr><td>" + html_escaped(change.case_name) + "</td><td>" + html_escaped(change.metric) +
            "</td>" + number_cell(with_unit(number_text(*change.before), change.unit)) + "</tr>\n";
  }
  if (rows.empty()) return "";
  return "<h2>Only in the earlier report</h2>\n" +
         html_rows(html_header_row({"Case", "Quantity", "Earlier value"}) + rows);
}

std::string header_html(const ReportHeader& header, const Report* earlier) {
  std::string html = "<h1>eisph: validation</h1>\n";
  html += fmt::format("<p class=\"faint\">{} · {} · {} run · {} thread{}<br>{}</p>\n",
                      html_escaped(header.version), html_escaped(header.date), html_escaped(header.mode),
                      header.threads, header.threads == 1 ? "" : "s", html_escaped(header.host));
  if (earlier != nullptr) {
    html += fmt::format("<p class=\"faint\">Beside an earlier report: {} · {} · {} run<br>{}</p>\n",
                        html_escaped(earlier->header.version), html_escaped(earlier->header.date),
                        html_escaped(earlier->header.mode), html_escaped(earlier->header.host));
  }
  return html;
}

}  // namespace

void write_report_html(const std::filesystem::path& path, const Report& report, const Report* earlier) {
  std::vector<MetricChange> changes;
  EarlierValues earlier_values;
  if (earlier != nullptr) {
    changes = report_changes(report, *earlier);
    for (const MetricChange& change : changes) earlier_values[{change.case_name, change.metric}] = change;
  }
  std::string html = html_page_start("eisph: validation");
  html += header_html(report.header, earlier) + verdict(report) + summary_table(report);
  for (std::size_t k = 0; k < report.cases.size(); ++k) {
    html += case_section(report.cases[k], k, earlier != nullptr ? &earlier_values : nullptr);
  }
  html += missing_table(changes) + html_page_end();
  write_whole_file(path, html);
}

}  // namespace eisph
