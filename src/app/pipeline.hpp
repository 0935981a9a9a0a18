#pragma once

#include "app/output_plan.hpp"
#include "app/worker.hpp"
#include "core/snapshot.hpp"
#include "render/image.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace eisph {

/// A state and what is to be made of it.
struct Publication {
  std::shared_ptr<const Snapshot> snapshot;
  DueOutputs due;
};

/// A drawn frame on its way to its file.
struct Frame {
  std::string file_name;
  double time = 0.0;  ///< s
  Image image;
};

/// What the threads beside the simulation do. Each function is made by its factory on the thread that calls
/// it. A factory may be empty: then nothing of that sort is done and no thread is started for it.
struct PipelineStages {
  using Write = std::function<void(const Publication&)>;
  using Draw = std::function<Frame(const Snapshot&, const DueFrame&)>;
  using Encode = std::function<void(Frame)>;

  std::function<Write()> make_write;
  std::function<Draw()> make_draw;
  std::function<Encode()> make_encode;  ///< needed with make_draw
};

/// The way of published states to files: one thread records (probes, states, depth grids), one draws, one
/// encodes. Records are never dropped; frames are, if the policy says so. Used by the simulation's thread; an
/// exception of a stage comes out of the next call.
class Pipeline {
 public:
  Pipeline(const PipelineStages& stages, std::size_t queue_length, QueuePolicy frame_policy);

  /// Hands a state over. Waits while a queue is full that drops nothing.
  void publish(const Publication& publication);
  /// Throws what a stage has thrown, if any has.
  void check() const { latch_.rethrow_if_failed(); }
  /// Waits until everything published is on disk and ends the threads. Throws what a stage has thrown.
  void finish();

  [[nodiscard]] std::uint64_t frames_written() const { return frames_written_.load(); }
  [[nodiscard]] std::uint64_t frames_dropped() const { return frames_dropped_; }

 private:
  Worker<Publication>::Handler make_draw_handler(const PipelineStages& stages);
  Worker<Frame>::Handler make_encode_handler(const PipelineStages& stages);

  FailureLatch latch_;
  std::atomic<std::uint64_t> frames_written_{0};
  std::uint64_t frames_dropped_ = 0;
  // In this order, because a worker must be gone before the one that it feeds.
  std::optional<Worker<Frame>> encoder_;
  std::optional<Worker<Publication>> renderer_;
  std::optional<Worker<Publication>> writer_;
};

}  // namespace eisph
