#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace eisph {

/// A growable array of trivial elements on cache-line boundaries. Growing keeps the content and leaves new
/// elements uninitialised; shrinking keeps the storage, so that a time step does not allocate.
template <class T>
class AlignedBuffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  AlignedBuffer() = default;
  explicit AlignedBuffer(std::size_t size) { resize(size); }
  AlignedBuffer(const AlignedBuffer&) = delete;
  AlignedBuffer& operator=(const AlignedBuffer&) = delete;
  AlignedBuffer(AlignedBuffer&& other) noexcept { swap(other); }
  AlignedBuffer& operator=(AlignedBuffer&& other) noexcept {
    swap(other);
    return *this;
  }
  ~AlignedBuffer() { std::free(data_); }  // NOLINT(cppcoreguidelines-no-malloc)

  /// Storage grows by an eighth more than asked for, to keep the peak memory close to the need.
  void resize(std::size_t size) {
    if (size + kSlack > capacity_) grow(size + size / 8 + kSlack);
    size_ = size;
  }
  /// Like resize, without storage to spare.
  void resize_exactly(std::size_t size) {
    if (size + kSlack > capacity_) grow(size + kSlack);
    size_ = size;
  }
  void fill(const T& value) { std::fill_n(data_, size_, value); }
  void swap(AlignedBuffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] std::size_t bytes() const { return capacity_ * sizeof(T); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

 private:
  static constexpr std::size_t kAlignment = 64;
  static constexpr std::size_t kSlack = 16;  ///< whole packs may be read past the end

  void grow(std::size_t capacity) {
    const std::size_t bytes = (capacity * sizeof(T) + kAlignment - 1) / kAlignment * kAlignment;
    T* fresh = static_cast<T*>(std::aligned_alloc(kAlignment, bytes));
    if (fresh == nullptr) throw std::bad_alloc();
    if (size_ > 0) std::copy_n(data_, size_, fresh);
    // What lies past the end may be read as part of a pack and is then ignored; it must still be a number.
    std::fill(fresh + size_, fresh + capacity, T{});
    std::free(data_);  // NOLINT(cppcoreguidelines-no-malloc)
    data_ = fresh;
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace eisph
