#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// One figure that a case is judged by, or that is reported for information: then it has no limit.
struct Metric {
  std::string name = {};  ///< unique within its case
  double value = 0.0;
  std::string unit = "-";
  std::optional<double> lower = std::nullopt;  ///< the value must not be less
  std::optional<double> upper = std::nullopt;  ///< the value must not be more
  std::string note = {};

  [[nodiscard]] bool has_limit() const { return lower.has_value() || upper.has_value(); }
  /// Whether the value is within its limits, which count as within. Not-a-number never is.
  [[nodiscard]] bool holds() const;
};

struct ReportFigure {
  std::filesystem::path path = {};  ///< of a PNG file
  std::string caption = {};
};

struct ReportTable {
  std::string caption = {};
  std::vector<std::string> columns = {};
  std::vector<std::vector<std::string>> rows = {};
};

/// Figures of the run, or of all runs, that a case made.
struct RunFigures {
  double wall_clock = 0.0;                 ///< s
  double particle_steps_per_second = 0.0;  ///< 1/s
  std::uint64_t peak_memory_bytes = 0;
  std::uint64_t steps = 0;
  std::uint64_t particles = 0;
  std::uint64_t penetrations = 0;
  std::uint64_t lost_particles = 0;
  double compression_max = 0.0;  ///< largest number density - 1
  double compression_p95 = 0.0;
  double paired_fraction = 0.0;    ///< of the particles, with another within 0.6 spacings; largest
  double isolated_fraction = 0.0;  ///< of the particles, without another within 2 spacings; largest
  double energy_gain =
      0.0;  ///< largest rise above the lowest energy before it, divided by the initial energy
};

/// The same figures as metrics without limits, in the units that the report shows; none without a run.
[[nodiscard]] std::vector<Metric> run_metrics(const RunFigures& run);

struct CaseReport {
  std::string name = {};  ///< as on the command line; unique within a report
  std::string title = {};
  std::string source = {};       ///< whose case, with citation
  std::string description = {};  ///< what was simulated
  std::string comparison = {};   ///< what was compared with what, by which norm
  std::vector<Metric> metrics = {};
  std::vector<ReportFigure> figures = {};
  std::vector<ReportTable> tables = {};
  RunFigures run = {};
  std::vector<std::string> notes = {};
  std::string failure = {};  ///< why the case could not be carried out; empty if it could

  [[nodiscard]] std::size_t limits() const;       ///< metrics that have one
  [[nodiscard]] std::size_t limits_held() const;  ///< those that hold
  /// All limits hold and the case was carried out.
  [[nodiscard]] bool holds() const;
};

struct ReportHeader {
  std::string version = {};  ///< of the program, with its commit
  std::string host = {};     ///< processor, cores, system
  std::string date = {};     ///< ISO 8601
  std::string mode = {};     ///< quick or full
  int threads = 1;
};

struct Report {
  ReportHeader header = {};
  std::vector<CaseReport> cases = {};

  [[nodiscard]] bool holds() const;
};

/// A metric in two reports. `before` or `now` is empty where that report lacks it.
struct MetricChange {
  std::string case_name = {};
  std::string metric = {};
  std::string unit = {};
  std::optional<double> before = std::nullopt;
  std::optional<double> now = std::nullopt;

  /// now / before; not-a-number if either is missing or before is zero.
  [[nodiscard]] double ratio() const;
};
/// All metrics and run figures of both reports in the order of `now`; those that only the earlier report has
/// come last.
[[nodiscard]] std::vector<MetricChange> report_changes(const Report& now, const Report& earlier);

/// Writes one HTML file that needs nothing else: figures are embedded. With an earlier report its values
/// stand beside the new ones. Throws InputError if a figure cannot be read, std::runtime_error if the file
/// cannot be written.
void write_report_html(const std::filesystem::path& path, const Report& report,
                       const Report* earlier = nullptr);

/// Writes report.json: everything but the pictures, which are named by paths relative to the file.
///
///     {"format": "eisph report 1", "version", "host", "date", "mode", "threads", "holds",
///      "cases": [{"name", "title", "source", "description", "comparison", "failure", "holds",
///                 "metrics": [{"name", "value", "unit", "lower", "upper", "note", "holds"}],
///                 "figures": [{"path", "caption"}],
///                 "tables": [{"caption", "columns": [text], "rows": [[text]]}],
///                 "run": {"wall_clock", "particle_steps_per_second", "peak_memory_bytes", "steps",
///                         "particles", "penetrations", "lost_particles", "compression_max",
///                         "compression_p95", "paired_fraction", "isolated_fraction", "energy_gain"},
///                 "notes": [text]}]}
///
/// A value that is no number and a limit that is absent are null. Throws std::runtime_error if the file
/// cannot be written; an older one is then unchanged.
void write_report_json(const std::filesystem::path& path, const Report& report);

/// Reads it back; paths of figures are again relative to the working folder. Throws InputError naming the
/// file and what is wrong with it.
[[nodiscard]] Report read_report_json(const std::filesystem::path& path);

}  // namespace eisph
