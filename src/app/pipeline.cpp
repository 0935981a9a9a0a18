#include "app/pipeline.hpp"

#include <utility>

namespace eisph {

Pipeline::Pipeline(const PipelineStages& stages, std::size_t queue_length, QueuePolicy frame_policy) {
  if (stages.make_draw) {
    encoder_.emplace(queue_length, QueuePolicy::KeepAll, latch_,
                     [this, stages] { return make_encode_handler(stages); });
    renderer_.emplace(queue_length, frame_policy, latch_,
                      [this, stages] { return make_draw_handler(stages); });
  }
  if (stages.make_write) {
    writer_.emplace(queue_length, QueuePolicy::KeepAll, latch_, [make_write = stages.make_write] {
      return [write = make_write()](const Publication& publication) { write(publication); };
    });
  }
}

Worker<Publication>::Handler Pipeline::make_draw_handler(const PipelineStages& stages) {
  return [this, draw = stages.make_draw()](const Publication& publication) {
    for (const DueFrame& due : publication.due.frames) encoder_->push(draw(*publication.snapshot, due));
  };
}

Worker<Frame>::Handler Pipeline::make_encode_handler(const PipelineStages& stages) {
  return [this, encode = stages.make_encode()](Frame frame) {
    encode(std::move(frame));
    frames_written_.fetch_add(1);
  };
}

void Pipeline::publish(const Publication& publication) {
  check();
  if (writer_) writer_->push(publication);
  if (renderer_ && !publication.due.frames.empty()) {
    const auto result = renderer_->push(publication);
    if (result.dropped) frames_dropped_ += result.dropped->due.frames.size();
  }
  check();
}

void Pipeline::finish() {
  if (writer_) writer_->finish();
  if (renderer_) renderer_->finish();
  if (encoder_) encoder_->finish();
  check();
}

}  // namespace eisph
