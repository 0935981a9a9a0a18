#include "compare/report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace eisph {

namespace {

std::vector<Metric> all_metrics(const CaseReport& report) {
  std::vector<Metric> metrics = report.metrics;
  for (Metric& metric : run_metrics(report.run)) metrics.push_back(std::move(metric));
  return metrics;
}

}  // namespace

bool Metric::holds() const {
  return !std::isnan(value) && (!lower || value >= *lower) && (!upper || value <= *upper);
}

std::vector<Metric> run_metrics(const RunFigures& run) {
  if (run.steps == 0) return {};
  const auto count = [](std::uint64_t number) { return static_cast<double>(number); };
  return {
      {.name = "wall clock", .value = run.wall_clock, .unit = "s"},
      {.name = "speed", .value = 1e-6 * run.particle_steps_per_second, .unit = "million particle-steps/s"},
      {.name = "particles", .value = count(run.particles)},
      {.name = "steps", .value = count(run.steps)},
      {.name = "peak memory", .value = 1e-6 * count(run.peak_memory_bytes), .unit = "MB"},
      {.name = "penetrations", .value = count(run.penetrations)},
      {.name = "particles lost", .value = count(run.lost_particles)},
      {.name = "largest compression", .value = 100.0 * run.compression_max, .unit = "%"},
      {.name = "95th percentile of the compression", .value = 100.0 * run.compression_p95, .unit = "%"},
      {.name = "particles within 0.6 dx", .value = 100.0 * run.paired_fraction, .unit = "%"},
      {.name = "isolated particles", .value = 100.0 * run.isolated_fraction, .unit = "%"},
      {.name = "energy gain", .value = 100.0 * run.energy_gain, .unit = "% of the initial energy"}};
}

std::size_t CaseReport::limits() const {
  return static_cast<std::size_t>(
      std::count_if(metrics.begin(), metrics.end(), [](const Metric& metric) { return metric.has_limit(); }));
}

std::size_t CaseReport::limits_held() const {
  return static_cast<std::size_t>(std::count_if(metrics.begin(), metrics.end(), [](const Metric& metric) {
    return metric.has_limit() && metric.holds();
  }));
}

bool CaseReport::holds() const { return failure.empty() && limits_held() == limits(); }

bool Report::holds() const {
  return std::all_of(cases.begin(), cases.end(), [](const CaseReport& report) { return report.holds(); });
}

double MetricChange::ratio() const {
  if (!before || !now || *before == 0.0) return std::numeric_limits<double>::quiet_NaN();
  return *now / *before;
}

std::vector<MetricChange> report_changes(const Report& now, const Report& earlier) {
  std::vector<MetricChange> changes;
  for (const CaseReport& report : now.cases) {
    for (const Metric& metric : all_metrics(report)) {
      changes.push_back({report.name, metric.name, metric.unit, std::nullopt, metric.value});
    }
  }
  const std::size_t known = changes.size();
  for (const CaseReport& report : earlier.cases) {
    for (const Metric& metric : all_metrics(report)) {
      const auto end = changes.begin() + static_cast<std::ptrdiff_t>(known);
      const auto same = std::find_if(changes.begin(), end, [&](const MetricChange& change) {
        return change.case_name == report.name && change.metric == metric.name;
      });
      if (same != end) {
        same->before = metric.value;
      } else {
        changes.push_back({report.name, metric.name, metric.unit, metric.value, std::nullopt});
      }
    }
  }
  return changes;
}

}  // namespace eisph
