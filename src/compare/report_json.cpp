#include "compare/report.hpp"
#include "compare/whole_file.hpp"
#include "core/error.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace eisph {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "eisph report 1";

Json limit_json(const std::optional<double>& limit) { return limit ? Json(*limit) : Json(nullptr); }

Json metric_json(const Metric& metric) {
  return {{"name", metric.name},
          {"value", metric.value},
          {"unit", metric.unit},
          {"lower", limit_json(metric.lower)},
          {"upper", limit_json(metric.upper)},
          {"note", metric.note},
          {"holds", metric.holds()}};
}

Json run_json(const RunFigures& run) {
  return {{"wall_clock", run.wall_clock},
          {"particle_steps_per_second", run.particle_steps_per_second},
          {"peak_memory_bytes", run.peak_memory_bytes},
          {"steps", run.steps},
          {"particles", run.particles},
          {"penetrations", run.penetrations},
          {"lost_particles", run.lost_particles},
          {"compression_max", run.compression_max},
          {"compression_p95", run.compression_p95},
          {"paired_fraction", run.paired_fraction},
          {"isolated_fraction", run.isolated_fraction},
          {"energy_gain", run.energy_gain}};
}

Json case_json(const CaseReport& report, const std::filesystem::path& folder) {
  Json json{{"name", report.name},
            {"title", report.title},
            {"source", report.source},
            {"description", report.description},
            {"comparison", report.comparison},
            {"failure", report.failure},
            {"holds", report.holds()}};
  json["metrics"] = Json::array();
  for (const Metric& metric : report.metrics) json["metrics"].push_back(metric_json(metric));
  json["figures"] = Json::array();
  for (const ReportFigure& figure : report.figures) {
    const std::filesystem::path path = std::filesystem::proximate(figure.path, folder);
    json["figures"].push_back({{"path", path.generic_string()}, {"caption", figure.caption}});
  }
  json["tables"] = Json::array();
  for (const ReportTable& table : report.tables) {
    Json table_json;
    table_json["caption"] = table.caption;
    table_json["columns"] = table.columns;
    table_json["rows"] = table.rows;
    json["tables"].push_back(std::move(table_json));
  }
  json["run"] = run_json(report.run);
  json["notes"] = report.notes;
  return json;
}

/// null stands for what is not a number.
double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::optional<double> limit(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

RunFigures run_of(const Json& json) {
  RunFigures run;
  run.wall_clock = number(json.at("wall_clock"));
  run.particle_steps_per_second = number(json.at("particle_steps_per_second"));
  json.at("peak_memory_bytes").get_to(run.peak_memory_bytes);
  json.at("steps").get_to(run.steps);
  json.at("particles").get_to(run.particles);
  json.at("penetrations").get_to(run.penetrations);
  json.at("lost_particles").get_to(run.lost_particles);
  run.compression_max = number(json.at("compression_max"));
  run.compression_p95 = number(json.at("compression_p95"));
  // Reports of earlier versions lack them.
  run.paired_fraction = number(json.value("paired_fraction", Json()));
  run.isolated_fraction = number(json.value("isolated_fraction", Json()));
  run.energy_gain = number(json.at("energy_gain"));
  return run;
}

CaseReport case_of(const Json& json, const std::filesystem::path& folder) {
  CaseReport report;
  json.at("name").get_to(report.name);
  json.at("title").get_to(report.title);
  json.at("source").get_to(report.source);
  json.at("description").get_to(report.description);
  json.at("comparison").get_to(report.comparison);
  json.at("failure").get_to(report.failure);
  for (const Json& metric : json.at("metrics")) {
    report.metrics.push_back({.name = metric.at("name").get<std::string>(),
                              .value = number(metric.at("value")),
                              .unit = metric.at("unit").get<std::string>(),
                              .lower = limit(metric.at("lower")),
                              .upper = limit(metric.at("upper")),
                              .note = metric.at("note").get<std::string>()});
  }
  for (const Json& figure : json.at("figures")) {
    report.figures.push_back({(folder / figure.at("path").get<std::string>()).lexically_normal(),
                              figure.at("caption").get<std::string>()});
  }
  for (const Json& table : json.at("tables")) {
    report.tables.push_back({table.at("caption").get<std::string>(),
                             table.at("columns").get<std::vector<std::string>>(),
                             table.at("rows").get<std::vector<std::vector<std::string>>>()});
  }
  report.run = run_of(json.at("run"));
  json.at("notes").get_to(report.notes);
  return report;
}

}  // namespace

void write_report_json(const std::filesystem::path& path, const Report& report) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const ReportHeader& header = report.header;
  Json json{{"format", kFormat},      {"version", header.version}, {"host", header.host},
            {"date", header.date},    {"mode", header.mode},       {"threads", header.threads},
            {"holds", report.holds()}};
  json["cases"] = Json::array();
  for (const CaseReport& one : report.cases) json["cases"].push_back(case_json(one, folder));
  write_whole_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

Report read_report_json(const std::filesystem::path& path) {
  const std::string content = read_whole_file(path);
  try {
    const Json json = Json::parse(content);
    if (json.at("format") != kFormat) {
      throw InputError(fmt::format("{}: its format is not '{}'", path.string(), kFormat));
    }
    Report report;
    json.at("version").get_to(report.header.version);
    json.at("host").get_to(report.header.host);
    json.at("date").get_to(report.header.date);
    json.at("mode").get_to(report.header.mode);
    json.at("threads").get_to(report.header.threads);
    for (const Json& one : json.at("cases")) report.cases.push_back(case_of(one, path.parent_path()));
    return report;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: is no report: {}", path.string(), error.what()));
  }
}

}  // namespace eisph
