#include "app/bounded_queue.hpp"

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

using std::chrono::milliseconds;

TEST(BoundedQueue, HandsItemsOverInOrder) {
  BoundedQueue<int> queue(3, QueuePolicy::KeepAll);
  for (const int item : {1, 2, 3}) EXPECT_TRUE(queue.push(item).accepted);
  for (const int item : {1, 2, 3}) EXPECT_EQ(queue.pop(), item);
}

TEST(BoundedQueue, OfItemsThatAreAllKeptMakesTheProducerWaitWhileItIsFull) {
  BoundedQueue<int> queue(1, QueuePolicy::KeepAll);
  queue.push(1);
  std::atomic<bool> pushed{false};
  std::thread producer([&] {
    queue.push(2);
    pushed = true;
  });
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_FALSE(pushed);
  EXPECT_EQ(queue.pop(), 1);
  producer.join();
  EXPECT_TRUE(pushed);
  EXPECT_EQ(queue.pop(), 2);
}

TEST(BoundedQueue, OfTheLatestItemsGivesUpTheOldestOneWhenItIsFull) {
  BoundedQueue<int> queue(2, QueuePolicy::LatestOnly);
  EXPECT_FALSE(queue.push(1).dropped.has_value());
  EXPECT_FALSE(queue.push(2).dropped.has_value());
  EXPECT_EQ(queue.push(3).dropped, 1);
  EXPECT_EQ(queue.push(4).dropped, 2);
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_EQ(queue.pop(), 4);
}

TEST(BoundedQueue, ThatIsClosedHandsOutWhatIsInsideAndTakesNothingMore) {
  BoundedQueue<int> queue(2, QueuePolicy::KeepAll);
  queue.push(1);
  queue.close();
  EXPECT_FALSE(queue.push(2).accepted);
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_FALSE(queue.pop().has_value());
}

TEST(BoundedQueue, ThatIsCancelledDiscardsWhatIsInside) {
  BoundedQueue<std::shared_ptr<int>> queue(2, QueuePolicy::KeepAll);
  const auto item = std::make_shared<int>(1);
  queue.push(item);
  EXPECT_EQ(item.use_count(), 2);
  queue.cancel();
  EXPECT_EQ(item.use_count(), 1);
  EXPECT_FALSE(queue.pop().has_value());
}

TEST(BoundedQueue, ClosingReleasesAWaitingProducerAndAWaitingConsumer) {
  BoundedQueue<int> full(1, QueuePolicy::KeepAll);
  full.push(1);
  std::atomic<bool> accepted{true};
  std::thread producer([&] { accepted = full.push(2).accepted; });
  BoundedQueue<int> empty(1, QueuePolicy::KeepAll);
  std::atomic<bool> received{true};
  std::thread consumer([&] { received = empty.pop().has_value(); });
  std::this_thread::sleep_for(milliseconds(20));
  full.close();
  empty.close();
  producer.join();
  consumer.join();
  EXPECT_FALSE(accepted);
  EXPECT_FALSE(received);
}

TEST(BoundedQueue, LosesAndDoublesNothingBetweenSeveralProducersAndConsumers) {
  constexpr int kThreads = 3;
  constexpr int kItems = 500;
  BoundedQueue<int> queue(4, QueuePolicy::KeepAll);
  std::vector<std::atomic<int>> seen(static_cast<std::size_t>(kThreads) * kItems);
  std::vector<std::thread> producers;
  std::vector<std::thread> consumers;
  for (int thread = 0; thread < kThreads; ++thread) {
    producers.emplace_back([&queue, thread] {
      for (int item = 0; item < kItems; ++item) queue.push(thread * kItems + item);
    });
    consumers.emplace_back([&queue, &seen] {
      while (const auto item = queue.pop()) ++seen[static_cast<std::size_t>(*item)];
    });
  }
  for (std::thread& producer : producers) producer.join();
  queue.close();
  for (std::thread& consumer : consumers) consumer.join();
  for (const auto& count : seen) ASSERT_EQ(count, 1);
}

}  // namespace
}  // namespace eisph
