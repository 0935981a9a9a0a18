#pragma once

#include <atomic>
#include <exception>
#include <mutex>

namespace eisph {

/// Keeps the first exception of several threads for the one that waits for them.
class FailureLatch {
 public:
  void set(std::exception_ptr failure) noexcept {
    const std::lock_guard lock(mutex_);
    if (failure_ == nullptr) failure_ = std::move(failure);
    failed_.store(true, std::memory_order_release);
  }

  [[nodiscard]] bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }

  void rethrow_if_failed() const {
    if (!failed()) return;
    std::exception_ptr failure;
    {
      const std::lock_guard lock(mutex_);
      failure = failure_;
    }
    std::rethrow_exception(failure);
  }

 private:
  mutable std::mutex mutex_;
  std::exception_ptr failure_;
  std::atomic<bool> failed_{false};
};

}  // namespace eisph
