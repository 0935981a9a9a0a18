#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "probe/fluid_field.hpp"

#include <optional>

namespace eisph {

/// What probes see of one snapshot: the snapshot itself and, made when it is first asked for, the water as a
/// field. Keeps references to both.
class Observation {
 public:
  Observation(const Scene& scene, const Snapshot& snapshot) : scene_(&scene), snapshot_(&snapshot) {}

  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const Snapshot& snapshot() const { return *snapshot_; }
  [[nodiscard]] const FluidField& field() {
    if (!field_) field_.emplace(*scene_, *snapshot_);
    return *field_;
  }
  [[nodiscard]] bool has_field() const { return field_.has_value(); }

 private:
  const Scene* scene_;
  const Snapshot* snapshot_;
  std::optional<FluidField> field_;
};

}  // namespace eisph
