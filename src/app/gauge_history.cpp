#include "app/gauge_history.hpp"

#include "compare/number_table.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kSameTime = 1e-9;  ///< s

}  // namespace

bool draws_gauges(const Scene& scene) {
  return std::any_of(scene.images.begin(), scene.images.end(),
                     [](const ImageSettings& image) { return !image.gauges.empty(); });
}

std::vector<GaugeCurve> read_gauge_curves(const RunFiles& files, const std::vector<std::string>& gauges) {
  std::vector<GaugeCurve> curves;
  curves.reserve(gauges.size());
  for (const std::string& name : gauges) {
    const NumberTable table = read_number_table(files.folder / fmt::format("gauge_{}.csv", name));
    curves.push_back({name, table.column("time"), table.column("surface")});
  }
  return curves;
}

GaugeHistory::GaugeHistory(const Scene& scene) {
  for (const ImageSettings& image : scene.images) {
    for (const std::string& gauge : image.gauges) curves_[gauge].name = gauge;
  }
}

std::size_t GaugeHistory::Tap::open_table(const TableHeader& header) {
  const std::size_t table = next_->open_table(header);
  constexpr std::string_view kPrefix = "gauge_";
  if (history_ != nullptr && header.name.starts_with(kPrefix)) {
    const std::string gauge = header.name.substr(kPrefix.size());
    if (history_->keeps(gauge)) gauge_of_table_[table] = gauge;
  }
  return table;
}

void GaugeHistory::Tap::append_row(std::size_t table, std::span<const double> row) {
  next_->append_row(table, row);
  const auto gauge = gauge_of_table_.find(table);
  if (gauge != gauge_of_table_.end()) history_->add(gauge->second, row[0], row[2]);
}

void GaugeHistory::add(const std::string& gauge, double time, double surface) {
  const std::lock_guard lock(mutex_);
  GaugeCurve& curve = curves_.at(gauge);
  curve.time.push_back(time);
  curve.surface.push_back(surface);
}

void GaugeHistory::advance(double time) {
  {
    const std::lock_guard lock(mutex_);
    recorded_ = time;
  }
  changed_.notify_all();
}

void GaugeHistory::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

std::vector<GaugeCurve> GaugeHistory::up_to(double time, const std::vector<std::string>& gauges) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return closed_ || recorded_ >= time - kSameTime; });
  std::vector<GaugeCurve> curves;
  curves.reserve(gauges.size());
  for (const std::string& name : gauges) {
    const GaugeCurve& all = curves_.at(name);
    const auto end = std::upper_bound(all.time.begin(), all.time.end(), time + kSameTime);
    const auto count = end - all.time.begin();
    curves.push_back({name, {all.time.begin(), end}, {all.surface.begin(), all.surface.begin() + count}});
  }
  return curves;
}

}  // namespace eisph
