#pragma once

#include "app/comparison/comparison_writer.hpp"
#include "app/comparison/photo_comparison.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

namespace eisph {

/// The comparison that a scene names, carried out beside its run. Without one it does nothing and costs
/// nothing.
class InSituComparison {
 public:
  /// Reads the comparison and its photographs, and sets scene.output.comparison to their times. Throws
  /// InputError, also for a photograph that is later than the end of the scene. `folder` is where the results
  /// go.
  InSituComparison(Scene& scene, const std::filesystem::path& folder);
  InSituComparison(const InSituComparison&) = delete;
  InSituComparison& operator=(const InSituComparison&) = delete;

  /// To be handed the states at the times of the photographs, by one thread; empty without a comparison.
  [[nodiscard]] std::function<void(const Snapshot&)> observer();
  /// Writes the report on the times that were compared.
  void finish();

  [[nodiscard]] std::size_t compared() const { return comparison_ ? comparison_->times().size() : 0; }
  [[nodiscard]] std::filesystem::path report() const { return writer_->report(); }

 private:
  const Scene& scene_;
  std::optional<PhotoComparison> comparison_;
  std::optional<ComparisonWriter> writer_;
};

}  // namespace eisph
