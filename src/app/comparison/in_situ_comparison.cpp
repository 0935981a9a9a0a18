#include "app/comparison/in_situ_comparison.hpp"

#include "app/comparison/run_depths.hpp"
#include "core/error.hpp"
#include "io/comparison_file.hpp"

#include <utility>

#include <fmt/format.h>

namespace eisph {

InSituComparison::InSituComparison(Scene& scene, const std::filesystem::path& folder) : scene_(scene) {
  if (scene.comparison.empty()) return;
  const Comparison settings = load_comparison(scene.comparison);
  for (std::size_t k = 0; k < settings.photographs.size(); ++k) {
    if (settings.photographs[k].time > scene.end_time) {
      throw InputError(fmt::format("{}: photograph.{}.time = {}: expected at most {} s, where {} ends",
                                   settings.source_file, k, settings.photographs[k].time, scene.end_time,
                                   scene.source_file));
    }
    scene.output.comparison.times.push_back(settings.photographs[k].time);
  }
  std::optional<RunDepths> other;
  if (!settings.other_run.empty()) other.emplace(settings.other_run, settings.deviation);
  comparison_.emplace(settings, scene, comparison_cell_size(scene, settings.deviation));
  writer_.emplace(*comparison_, folder, scene.name, std::move(other));
}

std::function<void(const Snapshot&)> InSituComparison::observer() {
  if (!comparison_) return {};
  writer_->begin();
  return [this](const Snapshot& snapshot) {
    const std::size_t photograph = comparison_->photograph_at(snapshot.time);
    writer_->write_time(
        comparison_->add(photograph, depths_of(scene_, comparison_->settings().deviation, snapshot)));
  };
}

void InSituComparison::finish() {
  if (writer_) writer_->write_end();
}

}  // namespace eisph
