#include "compare/report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eisph {

namespace {

/// A metric of a case, or its wall clock or speed, that is to be found in two reports.
struct NamedValue {
  std::string name;
  std::string unit;
  double value;
};

std::vector<NamedValue> named_values(const CaseReport& report) {
  std::vector<NamedValue> values;
  for (const Metric& metric : report.metrics) values.push_back({metric.name, metric.unit, metric.value});
  values.push_back({"wall clock", "s", report.run.wall_clock});
  values.push_back({"particle-steps per second", "1/s", report.run.particle_steps_per_second});
  return values;
}

std::vector<MetricChange> changes_of(const CaseReport& now) {
  std::vector<MetricChange> changes;
  for (const NamedValue& value : named_values(now)) {
    changes.push_back({now.name, value.name, value.unit, std::nullopt, value.value});
  }
  return changes;
}

}  // namespace

bool Metric::holds() const {
  return !std::isnan(value) && (!lower || value >= *lower) && (!upper || value <= *upper);
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
    for (MetricChange& change : changes_of(report)) changes.push_back(std::move(change));
  }
  const std::size_t known = changes.size();
  for (const CaseReport& report : earlier.cases) {
    for (const NamedValue& value : named_values(report)) {
      const auto end = changes.begin() + static_cast<std::ptrdiff_t>(known);
      const auto same = std::find_if(changes.begin(), end, [&](const MetricChange& change) {
        return change.case_name == report.name && change.metric == value.name;
      });
      if (same != end) {
        same->before = value.value;
      } else {
        changes.push_back({report.name, value.name, value.unit, value.value, std::nullopt});
      }
    }
  }
  return changes;
}

}  // namespace eisph
