#include "core/aligned_buffer.hpp"

#include "core/pack.hpp"

#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

namespace eisph {
namespace {

TEST(AlignedBuffer, StartsOnACacheLine) {
  for (const std::size_t size : {1U, 7U, 100U, 4097U}) {
    const AlignedBuffer<float> buffer(size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.data()) % 64, 0U) << size;
  }
}

TEST(AlignedBuffer, KeepsItsContentWhenItGrowsAndWhenItIsMoved) {
  AlignedBuffer<int> buffer(10);
  for (int k = 0; k < 10; ++k) buffer[static_cast<std::size_t>(k)] = k;
  buffer.resize(5000);
  const AlignedBuffer<int> moved = std::move(buffer);
  ASSERT_EQ(moved.size(), 5000U);
  for (int k = 0; k < 10; ++k) EXPECT_EQ(moved[static_cast<std::size_t>(k)], k);
}

TEST(AlignedBuffer, KeepsItsStorageWhenItShrinksAndGrowsBack) {
  AlignedBuffer<double> buffer(1000);
  const double* storage = buffer.data();
  buffer.resize(10);
  buffer.resize(1000);
  EXPECT_EQ(buffer.data(), storage);
}

/// A list or a table is read in whole packs, up to seven elements past its end.
TEST(AlignedBuffer, AlwaysHasRoomForAPackBeyondItsLastElement) {
  AlignedBuffer<Float4> buffer;
  std::size_t least_room = 1000;
  for (std::size_t size = 1; size < 400; ++size) {
    buffer.resize(size);
    least_room = std::min(least_room, buffer.capacity() - buffer.size());
  }
  EXPECT_GE(least_room, kPackWidth - 1);
}

}  // namespace
}  // namespace eisph
