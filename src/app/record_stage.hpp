#pragma once

#include "app/gauge_history.hpp"
#include "app/pipeline.hpp"
#include "app/run_files.hpp"
#include "core/scene.hpp"
#include "io/csv_table.hpp"
#include "io/pvd_collection.hpp"
#include "probe/depth_grid.hpp"
#include "probe/probe_set.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>

namespace eisph {

/// Writes everything of a run besides frames: tables of the probes, particle and object states, depth grids.
/// Used by one thread.
class RecordStage {
 public:
  /// `history`, if there is one, is told of the gauges' records too.
  RecordStage(const Scene& scene, RunFiles files, GaugeHistory* history = nullptr);

  void write(const Publication& publication);

  /// Distances of neighbours in the ledger so far.
  [[nodiscard]] const NeighbourHistory& neighbours() const { return probes_.neighbours(); }

 private:
  void write_state(const Snapshot& snapshot);
  void write_object_state(const Snapshot& snapshot);
  void write_depth_grid(const Snapshot& snapshot);

  RunFiles files_;
  CsvFolder tables_;
  GaugeHistory::Tap tap_;
  GaugeHistory* history_;
  ProbeSet probes_;
  DepthGridBuilder depth_builder_;
  PvdCollection particles_index_;
  PvdCollection objects_index_;
  PvdCollection depth_index_;
  std::size_t states_ = 0;
  std::size_t depth_grids_ = 0;
  std::shared_ptr<const ObjectParticles> written_objects_;
  std::filesystem::path objects_file_;
};

}  // namespace eisph
