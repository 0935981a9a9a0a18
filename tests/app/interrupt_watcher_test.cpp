#include "app/interrupt_watcher.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

namespace eisph {
namespace {

enum Outcome : int { kRequested = 3, kNotRequested = 4 };

/// Whether the watcher sees a signal within `patience`.
bool becomes_requested(const InterruptWatcher& watcher, std::chrono::milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!watcher.requested() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return watcher.requested();
}

/// Sends the signal so many times, each time waiting for it to be seen, and exits with what came of it.
[[noreturn]] void exit_after_signals(int signal, int count, std::chrono::milliseconds patience) {
  const InterruptWatcher watcher;
  bool requested = watcher.requested();
  for (int sent = 0; sent < count; ++sent) {
    kill(getpid(), signal);
    requested = becomes_requested(watcher, patience);
  }
  if (count > 1) std::this_thread::sleep_for(patience);
  std::_Exit(requested ? kRequested : kNotRequested);
}

/// Each case runs in a process of its own: threads that other tests have left behind do not block the
/// signals.
class InterruptWatcherTest : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    ::testing::FLAGS_gtest_death_test_style = "threadsafe";
    // Whoever starts the tests may have told them to ignore the signal.
    previous_ = std::signal(GetParam(), SIG_DFL);
  }
  void TearDown() override { std::signal(GetParam(), previous_); }

  static constexpr std::chrono::milliseconds kLong{10000};
  static constexpr std::chrono::milliseconds kShort{50};

 private:
  void (*previous_)(int) = SIG_DFL;
};

using ::testing::ExitedWithCode;
using ::testing::KilledBySignal;

TEST_P(InterruptWatcherTest, AsksForNothingWithoutASignal) {
  EXPECT_EXIT(exit_after_signals(GetParam(), 0, kLong), ExitedWithCode(kNotRequested), "");
}

TEST_P(InterruptWatcherTest, TurnsTheFirstSignalIntoARequest) {
  EXPECT_EXIT(exit_after_signals(GetParam(), 1, kLong), ExitedWithCode(kRequested), "");
}

TEST_P(InterruptWatcherTest, LetsASecondSignalKill) {
  EXPECT_EXIT(exit_after_signals(GetParam(), 2, kLong), KilledBySignal(GetParam()), "");
}

TEST_P(InterruptWatcherTest, LeavesAnIgnoredSignalIgnored) {
  EXPECT_EXIT(
      {
        std::signal(GetParam(), SIG_IGN);
        exit_after_signals(GetParam(), 1, kShort);
      },
      ExitedWithCode(kNotRequested), "");
}

INSTANTIATE_TEST_SUITE_P(StopSignals, InterruptWatcherTest, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace eisph
