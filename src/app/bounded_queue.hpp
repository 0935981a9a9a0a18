#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace eisph {

enum class QueuePolicy {
  KeepAll,     ///< a producer waits while the queue is full
  LatestOnly,  ///< a full queue gives up its oldest item instead
};

/// A queue of limited length between threads, for any number of producers and consumers.
template <typename T>
class BoundedQueue {
 public:
  struct PushResult {
    bool accepted = false;     ///< false once the queue is closed
    std::optional<T> dropped;  ///< the item that had to go (LatestOnly)
  };

  /// A capacity of 0 is taken as 1.
  BoundedQueue(std::size_t capacity, QueuePolicy policy)
      : capacity_(std::max<std::size_t>(capacity, 1)), policy_(policy) {}

  PushResult push(T item) {
    PushResult result;
    {
      std::unique_lock lock(mutex_);
      if (policy_ == QueuePolicy::KeepAll) {
        space_.wait(lock, [this] { return closed_ || items_.size() < capacity_; });
      }
      if (closed_) return result;
      if (items_.size() >= capacity_) {
        result.dropped = std::move(items_.front());
        items_.pop_front();
      }
      items_.push_back(std::move(item));
      result.accepted = true;
    }
    available_.notify_one();
    return result;
  }

  /// Waits for an item; nothing once the queue is closed and empty.
  std::optional<T> pop() {
    std::optional<T> item;
    {
      std::unique_lock lock(mutex_);
      available_.wait(lock, [this] { return closed_ || !items_.empty(); });
      if (items_.empty()) return item;
      item = std::move(items_.front());
      items_.pop_front();
    }
    space_.notify_one();
    return item;
  }

  /// Takes no more items; those inside can still be popped.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    space_.notify_all();
    available_.notify_all();
  }

  /// Takes no more items and discards those inside.
  void cancel() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
      items_.clear();
    }
    space_.notify_all();
    available_.notify_all();
  }

 private:
  const std::size_t capacity_;
  const QueuePolicy policy_;
  std::mutex mutex_;
  std::condition_variable space_;
  std::condition_variable available_;
  std::deque<T> items_;
  bool closed_ = false;
};

}  // namespace eisph
