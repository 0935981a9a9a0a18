#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace eisph {

/// Turns the first SIGINT or SIGTERM into a request to stop; a second one kills the process. To be made
/// before any other thread is started: it blocks both signals in its own thread and in those started from
/// then on, and waits for them in one of its own. A signal that the process was told to ignore stays ignored.
class InterruptWatcher {
 public:
  InterruptWatcher();
  ~InterruptWatcher();
  InterruptWatcher(const InterruptWatcher&) = delete;
  InterruptWatcher& operator=(const InterruptWatcher&) = delete;

  [[nodiscard]] bool requested() const noexcept { return requested_.load(std::memory_order_relaxed); }

 private:
  void watch() noexcept;

  sigset_t watched_;
  sigset_t previous_;
  int signals_;  ///< file descriptor of the blocked signals
  int wake_;     ///< file descriptor that ends the watching thread
  std::atomic<bool> requested_{false};
  std::thread thread_;
};

}  // namespace eisph
