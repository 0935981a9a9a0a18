#include "app/pareto/pareto_study.hpp"
#include "compare/illustrated_page.hpp"
#include "compare/plot.hpp"
#include "io/file_io.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace eisph {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kLevels[] = {1.0, 3.0, 10.0};  ///< errors for which the best setting is named, per cent

constexpr double kRoom = 1.5;  ///< of a chart below the least and above the largest error, as a factor

std::filesystem::path chart_path(const std::filesystem::path& folder, const ParetoResult& result,
                                 const ParetoError& error, bool pairs) {
  return folder / fmt::format("{}_{}{}.png", result.chosen->name, error.name, pairs ? "_pairs" : "");
}

std::string point_name(const ParetoPoint& point) {
  return fmt::format("{}, dx = {:g} m", setting_name(point.scheme, point.step), point.spacing);
}

/// Cost against error, a series for each scheme, the front as a line.
void write_chart(const std::filesystem::path& path, const ParetoResult& result, std::size_t error,
                 bool pairs) {
  const std::vector<CostAndError> costs = result.costs(error, pairs);
  std::vector<std::string> order;
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> series;
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (!std::isfinite(costs[k].error) || !std::isfinite(costs[k].cost)) continue;
    const std::string& name = result.points[k].scheme;
    if (series.count(name) == 0) order.push_back(name);
    series[name].first.push_back(costs[k].cost);
    series[name].second.push_back(costs[k].error);
  }
  Plot plot{.title = fmt::format("{}: {}", result.chosen->title, result.chosen->errors[error].name),
            .x_label =
                pairs ? "pair evaluations per simulated second [1/s]" : "CPU time per simulated second [s/s]",
            .y_label = "error [%]",
            .series = {}};
  plot.x_log = true;
  plot.y_log = true;
  plot.legend = LegendPosition::Below;
  PlotRange range{1e300, 0.0};
  for (const auto& [name, values] : series) {
    for (const double value : values.second)
      range = {std::min(range.least, value), std::max(range.most, value)};
  }
  if (range.most > 0.0) plot.y_range = PlotRange{range.least / kRoom, range.most * kRoom};
  Curve front;
  for (const std::size_t k : pareto_front(costs)) front.add(costs[k].cost, costs[k].error);
  plot.series.push_back({.label = "Pareto front", .curve = front, .style = SeriesStyle::Dashed, .colour = 0});
  for (const std::string& name : order) {
    plot.series.push_back({.label = name,
                           .curve = make_curve(series[name].first, series[name].second),
                           .style = SeriesStyle::Points});
  }
  write_plot(path, plot, {1000, 700});
}

/// The Pareto front by CPU time of each error of a case.
using Fronts = std::vector<std::vector<std::size_t>>;
Fronts fronts_of(const ParetoResult& result) {
  Fronts fronts;
  fronts.reserve(result.chosen->errors.size());
  for (std::size_t e = 0; e < result.chosen->errors.size(); ++e) {
    fronts.push_back(pareto_front(result.costs(e, false)));
  }
  return fronts;
}

bool is_on(const std::vector<std::size_t>& front, std::size_t point) {
  return std::find(front.begin(), front.end(), point) != front.end();
}

/// A figure that is known, by a format of the library; else a dash.
std::string known_figure(fmt::format_string<const double&> format, const double value) {
  return std::isfinite(value) ? fmt::format(format, value) : "-";
}

/// In a table of numbers an unknown one is an empty field.
std::string field(double value) { return std::isfinite(value) ? fmt::format("{:g}", value) : ""; }

/// All points of a case.
ReportTable points_table(const ParetoResult& result) {
  ReportTable table{.caption = fmt::format("{} to {:g} s", result.chosen->title, result.end),
                    .columns = {"scheme", "time step", "dx [m]", "particles", "mean dt [s]",
                                "CPU s per simulated s (least to most)", "pairs per simulated s",
                                "memory [MB]", "largest compression [%]", "energy gain [%]"},
                    .rows = {}};
  for (const ParetoError& error : result.chosen->errors) table.columns.push_back(error.name + " [%]");
  const Fronts fronts = fronts_of(result);
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    const ParetoPoint& point = result.points[k];
    std::vector<std::string> row = {point.scheme, point.step, fmt::format("{:g}", point.spacing)};
    if (!point.failure.empty()) {
      row.emplace_back("blown up");
      row.resize(table.columns.size());
      table.rows.push_back(row);
      continue;
    }
    const auto [least, most] = std::minmax_element(point.cpu_times.begin(), point.cpu_times.end());
    row.insert(row.end(), {fmt::format("{}", point.particles), fmt::format("{:.3g}", point.time_step),
                           fmt::format("{:.3g} ({:.3g} to {:.3g})", point.cpu_time(), *least, *most),
                           known_figure("{:.3g}", point.pair_evaluations),
                           known_figure("{:.1f}", 1e-6 * point.state_memory),
                           known_figure("{:.1f}", 100.0 * point.compression),
                           known_figure("{:.2g}", 100.0 * point.energy_gain)});
    for (std::size_t e = 0; e < point.errors.size(); ++e) {
      row.push_back(fmt::format("{:.2f}{}", point.errors[e], is_on(fronts[e], k) ? " (front)" : ""));
    }
    table.rows.push_back(row);
  }
  return table;
}

/// The cheapest setting for each level of error.
ReportTable best_table(const ParetoResult& result) {
  ReportTable table{.caption = "Cheapest setting for an error", .columns = {"measured by"}, .rows = {}};
  for (const double level : kLevels) table.columns.push_back(fmt::format("{:g} %", level));
  for (std::size_t e = 0; e < result.chosen->errors.size(); ++e) {
    const std::vector<CostAndError> costs = result.costs(e, false);
    std::vector<std::string> row = {result.chosen->errors[e].name};
    for (const double level : kLevels) {
      const auto best = cheapest_within(costs, level);
      row.push_back(best ? fmt::format("{}: {:.3g} s/s", point_name(result.points[*best]), costs[*best].cost)
                         : "none");
    }
    table.rows.push_back(row);
  }
  return table;
}

PageSection section_of(const std::filesystem::path& folder, const ParetoResult& result) {
  PageSection section;
  section.title = fmt::format("{} ({})", result.chosen->title, result.chosen->name);
  for (const ParetoError& error : result.chosen->errors) {
    section.paragraphs.push_back(fmt::format("{}: {}.", error.name, error.meaning));
  }
  if (result.reference_spacing > 0.0) {
    std::string text = fmt::format(
        "Reference run: EISPH at {:g} m, half the finest spacing. delta-SPH with "
        "Runge-Kutta stepping at that spacing differs from it by",
        result.reference_spacing);
    for (std::size_t e = 0; e < result.reference_spread.size(); ++e) {
      text += fmt::format("{} {:.2f} % ({})", e == 0 ? "" : ",", result.reference_spread[e],
                          result.chosen->errors[e].name);
    }
    section.paragraphs.push_back(text + ": errors below that say nothing.");
  }
  section.tables = {best_table(result), points_table(result)};
  for (const ParetoError& error : result.chosen->errors) {
    section.figures.push_back(
        {chart_path(folder, result, error, false), "Cost in CPU time, " + error.meaning + "."});
    section.figures.push_back(
        {chart_path(folder, result, error, true), "Cost in pair evaluations, which no machine changes."});
  }
  return section;
}

Json point_json(const ParetoResult& result, const Fronts& fronts, std::size_t k) {
  const ParetoPoint& point = result.points[k];
  Json json = {{"scheme", point.scheme},
               {"step", point.step},
               {"spacing", point.spacing},
               {"particles", point.particles},
               {"steps", point.steps},
               {"time_step_mean", point.time_step},
               {"cpu_times", point.cpu_times},
               {"cpu_time_median", point.cpu_time()},
               {"pair_evaluations", point.pair_evaluations},
               {"state_memory_bytes", point.state_memory},
               {"compression_max", point.compression},
               {"energy_gain", point.energy_gain},
               {"failure", point.failure}};
  Json errors = Json::object();
  for (std::size_t e = 0; e < result.chosen->errors.size(); ++e) {
    const bool has = e < point.errors.size();
    errors[result.chosen->errors[e].name] = {{"value", has ? Json(point.errors[e]) : Json()},
                                             {"on_front", is_on(fronts[e], k)}};
  }
  json["errors"] = errors;
  return json;
}

}  // namespace

void write_pareto_case(const std::filesystem::path& folder, const ParetoResult& result) {
  std::string text =
      "scheme,step,spacing [m],particles [-],steps [-],time_step_mean [s],cpu_time [s/s],cpu_time_least "
      "[s/s],"
      "cpu_time_most [s/s],pair_evaluations [1/s],state_memory [byte],compression_max [-],energy_gain [-]";
  for (const ParetoError& error : result.chosen->errors) {
    text += fmt::format(",error_{} [%],front_{} [-]", error.name, error.name);
  }
  text += ",blown_up [-]\n";
  const Fronts fronts = fronts_of(result);
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    const ParetoPoint& point = result.points[k];
    const bool ran = point.failure.empty();
    const auto [least, most] = std::minmax_element(point.cpu_times.begin(), point.cpu_times.end());
    text += fmt::format("\"{}\",\"{}\",{:g}", point.scheme, point.step, point.spacing);
    text += ran ? fmt::format(",{},{},{:g},{:g},{:g},{:g},{},{},{},{}", point.particles, point.steps,
                              point.time_step, point.cpu_time(), *least, *most, field(point.pair_evaluations),
                              field(point.state_memory), field(point.compression), field(point.energy_gain))
                : ",,,,,,,,,,";
    for (std::size_t e = 0; e < result.chosen->errors.size(); ++e) {
      text += ran ? fmt::format(",{:g},{}", point.errors[e], is_on(fronts[e], k) ? 1 : 0) : ",,";
    }
    text += ran ? ",0\n" : ",1\n";
  }
  write_file_atomically(folder / (result.chosen->name + ".csv"), text);
  for (std::size_t e = 0; e < result.chosen->errors.size(); ++e) {
    for (const bool pairs : {false, true}) {
      write_chart(chart_path(folder, result, result.chosen->errors[e], pairs), result, e, pairs);
    }
  }
}

void write_pareto_report(const std::filesystem::path& folder, const std::vector<ParetoResult>& results,
                         const std::string& subtitle) {
  Json json = {{"format", "eisph pareto 1"}, {"header", subtitle}, {"cases", Json::array()}};
  IllustratedPage page;
  page.title = "Speed against error";
  page.subtitle = subtitle;
  PageSection how;
  how.title = "How this was measured";
  how.paragraphs = {
      "Every setting ran on one thread. Cost is the CPU time of the time loop, without outputs and without "
      "the "
      "pressure of t = 0: the median of the repetitions, which ran through the settings in turn and back. "
      "Pair "
      "evaluations are the entries of neighbour lists that were read. Memory is that of the state of "
      "the solver, which only grows in a run. Runs of other programs ran once, outside; their states were "
      "looked "
      "at with the same probes, their CPU time is what they told.",
      "A point is on the Pareto front if no other one is as cheap and as accurate. Errors include those of "
      "the "
      "model against an experiment, which no setting can remove: differences below them say nothing."};
  page.sections.push_back(how);
  for (const ParetoResult& result : results) {
    page.sections.push_back(section_of(folder, result));
    Json points = Json::array();
    const Fronts fronts = fronts_of(result);
    for (std::size_t k = 0; k < result.points.size(); ++k) points.push_back(point_json(result, fronts, k));
    json["cases"].push_back({{"name", result.chosen->name},
                             {"title", result.chosen->title},
                             {"end_time", result.end},
                             {"reference_spacing", result.reference_spacing},
                             {"reference_spread", result.reference_spread},
                             {"points", points}});
  }
  write_illustrated_page(folder / "report.html", page);
  write_file_atomically(folder / "pareto.json", json.dump(2) + "\n");
}

}  // namespace eisph
