#include "app/interrupt_watcher.hpp"

#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

namespace eisph {
namespace {

/// Whether the watcher has seen a signal, given time for it.
bool becomes_requested(const InterruptWatcher& watcher) {
  for (int wait = 0; wait < 500 && !watcher.requested(); ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return watcher.requested();
}

class InterruptWatcherTest : public ::testing::TestWithParam<int> {
 protected:
  // Whoever starts the tests may have told them to ignore the signal.
  void SetUp() override { previous_ = std::signal(GetParam(), SIG_DFL); }
  void TearDown() override { std::signal(GetParam(), previous_); }

 private:
  void (*previous_)(int) = SIG_DFL;
};

TEST_P(InterruptWatcherTest, TurnsTheFirstSignalIntoARequest) {
  const InterruptWatcher watcher;
  EXPECT_FALSE(watcher.requested());
  kill(getpid(), GetParam());
  EXPECT_TRUE(becomes_requested(watcher));
}

TEST_P(InterruptWatcherTest, LetsASecondSignalKill) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const InterruptWatcher watcher;
        kill(getpid(), GetParam());
        if (becomes_requested(watcher)) kill(getpid(), GetParam());
        std::this_thread::sleep_for(std::chrono::seconds(10));
      },
      ::testing::KilledBySignal(GetParam()), "");
}

TEST_P(InterruptWatcherTest, LeavesAnIgnoredSignalIgnored) {
  std::signal(GetParam(), SIG_IGN);
  const InterruptWatcher watcher;
  kill(getpid(), GetParam());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(watcher.requested());
}

INSTANTIATE_TEST_SUITE_P(StopSignals, InterruptWatcherTest, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace eisph
