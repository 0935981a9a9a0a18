#pragma once

#include "app/bounded_queue.hpp"
#include "app/failure_latch.hpp"

#include <functional>
#include <thread>
#include <utility>

namespace eisph {

/// A thread that handles the items of its own bounded queue in order. Its handler is made and destroyed on
/// that thread, as a drawing context has to be. An exception ends the worker and closes its queue, so that no
/// producer waits for it, and is kept in the latch.
template <typename T>
class Worker {
 public:
  using Handler = std::function<void(T)>;
  using HandlerFactory = std::function<Handler()>;

  Worker(std::size_t queue_length, QueuePolicy policy, FailureLatch& latch, HandlerFactory make_handler)
      : queue_(queue_length, policy),
        latch_(latch),
        thread_([this, make = std::move(make_handler)] { work(make); }) {}

  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  ~Worker() {
    queue_.cancel();
    if (thread_.joinable()) thread_.join();
  }

  typename BoundedQueue<T>::PushResult push(T item) { return queue_.push(std::move(item)); }

  /// Handles what is queued, then ends the thread.
  void finish() {
    queue_.close();
    if (thread_.joinable()) thread_.join();
  }

 private:
  void work(const HandlerFactory& make_handler) noexcept {
    try {
      const Handler handle = make_handler();
      while (auto item = queue_.pop()) handle(std::move(*item));
    } catch (...) {
      latch_.set(std::current_exception());
      queue_.cancel();
    }
  }

  BoundedQueue<T> queue_;
  FailureLatch& latch_;
  std::thread thread_;
};

}  // namespace eisph
