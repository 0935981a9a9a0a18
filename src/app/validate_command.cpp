#include "app/build_info.hpp"
#include "app/case_choice.hpp"
#include "app/commands.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress.hpp"
#include "app/validate/cases.hpp"
#include "app/validate/validator.hpp"
#include "compare/plot.hpp"
#include "compare/report.hpp"
#include "core/error.hpp"
#include "io/file_io.hpp"
#include "io/host.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace eisph {

namespace {

/// The cases asked for, in the order of the report; without any, all of the mode.
std::vector<const ValidationCase*> chosen_cases(const ValidateOptions& options) {
  std::vector<const ValidationCase*> chosen = choose_cases("validate", validation_cases(), options.cases);
  if (options.cases.empty() && !options.full) {
    std::erase_if(chosen, [](const ValidationCase* candidate) { return !candidate->quick; });
  }
  return chosen;
}

std::optional<Report> earlier_report(const ValidateOptions& options) {
  if (!options.against) return std::nullopt;
  return read_report_json(*options.against / "report.json");
}

ReportHeader make_header(const ValidateOptions& options) {
  const BuildInfo build = build_info();
  const HostInfo host = host_info();
  ReportHeader header;
  header.version = software_name() + (build.commit.empty() ? "" : " (" + build.commit + ")");
  header.host =
      fmt::format("{}, {} cores, {}, {}", host.cpu_model, host.cores, build.instruction_set, host.os);
  header.date = iso_time(std::chrono::system_clock::now());
  header.mode = options.full ? "full" : "quick";
  header.threads = options.threads;
  return header;
}

void print_case(std::ostream& out, const CaseReport& report) {
  fmt::print(out, "{:<18} {:<6} {} of {} limits held, {}\n", report.name, report.holds() ? "holds" : "MISSED",
             report.limits_held(), report.limits(), duration_text(report.run.wall_clock));
  if (!report.failure.empty()) fmt::print(out, "    {}\n", report.failure);
  for (const Metric& metric : report.metrics) {
    if (!metric.has_limit() || metric.holds()) continue;
    std::string limits;
    if (metric.lower) limits += fmt::format(", at least {:.4g}", *metric.lower);
    if (metric.upper) limits += fmt::format(", at most {:.4g}", *metric.upper);
    fmt::print(out, "    {}: {:.4g} {}{}\n", metric.name, metric.value, metric.unit, limits);
  }
}

/// Writes both files anew, so that what is done so far can be read while the rest goes on.
void write_report(const std::filesystem::path& folder, const Report& report,
                  const std::optional<Report>& earlier) {
  write_report_html(folder / "report.html", report, earlier ? &*earlier : nullptr);
  write_report_json(folder / "report.json", report);
}

}  // namespace

int validate_command(const ValidateOptions& options, std::ostream& out, std::ostream& progress) {
  if (options.list) {
    for (const ValidationCase& known : validation_cases()) {
      fmt::print(out, "{:<18}{}{}\n", known.name, known.title, known.quick ? "" : " (only with --full)");
    }
    return kSuccess;
  }
  const InterruptWatcher interrupt;
  const std::vector<const ValidationCase*> cases = chosen_cases(options);
  const std::optional<Report> earlier = earlier_report(options);
  require_gnuplot();
  create_folder(options.out);
  Validator validator({options.out, options.threads, options.full, options.quiet}, progress,
                      [&interrupt] { return interrupt.requested(); });
  Report report;
  report.header = make_header(options);
  int code = kSuccess;
  try {
    for (const ValidationCase* chosen : cases) {
      report.cases.push_back(carry_out(*chosen, validator));
      if (!options.quiet) print_case(out, report.cases.back());
      write_report(options.out, report, earlier);
    }
    code = report.holds() ? kSuccess : kLimitsMissed;
  } catch (const ValidationInterrupted&) {
    code = kInterrupted;
  }
  if (!options.quiet) {
    fmt::print(
        out, "{}; report in {}\n",
        code == kInterrupted ? "interrupted" : (code == kSuccess ? "all limits hold" : "limits were missed"),
        (options.out / "report.html").string());
  }
  return code;
}

}  // namespace eisph
