#include "app/record_stage.hpp"

#include "io/file_io.hpp"
#include "io/vtk_output.hpp"

#include <utility>

namespace eisph {

RecordStage::RecordStage(const Scene& scene, RunFiles files, GaugeHistory* history)
    : files_(std::move(files)),
      tables_(files_.folder),
      tap_(history, tables_),
      history_(history),
      probes_(scene, tap_),
      depth_builder_(scene),
      particles_index_(files_.particles_collection()),
      objects_index_(files_.objects_collection()),
      depth_index_(files_.depth_collection()) {
  if (!scene.output.particles.empty()) create_folder(files_.particles(0).parent_path());
  if (!scene.output.depth.empty()) create_folder(files_.depth(0).parent_path());
}

void RecordStage::write(const Publication& publication) {
  const Snapshot& snapshot = *publication.snapshot;
  probes_.record(snapshot);
  if (history_ != nullptr) history_->advance(snapshot.time);
  if (publication.due.particles) write_state(snapshot);
  if (publication.due.depth) write_depth_grid(snapshot);
}

void RecordStage::write_state(const Snapshot& snapshot) {
  const std::filesystem::path file = files_.particles(states_);
  write_particles(file, snapshot);
  write_object_state(snapshot);
  particles_index_.add(snapshot.time, file);  // last: a state in the index has its objects
  ++states_;
}

void RecordStage::write_object_state(const Snapshot& snapshot) {
  if (snapshot.objects->position.empty()) return;
  if (snapshot.objects != written_objects_) {
    objects_file_ = files_.objects(states_);
    write_objects(objects_file_, *snapshot.objects);
    written_objects_ = snapshot.objects;
  }
  objects_index_.add(snapshot.time, objects_file_);
}

void RecordStage::write_depth_grid(const Snapshot& snapshot) {
  const std::filesystem::path file = files_.depth(depth_grids_);
  write_depth(file, depth_builder_.build(snapshot));
  depth_index_.add(snapshot.time, file);
  ++depth_grids_;
}

}  // namespace eisph
