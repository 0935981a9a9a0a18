#include "app/interrupt_watcher.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace eisph {
namespace {

sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&signals, signal);
  }
  return signals;
}

}  // namespace

InterruptWatcher::InterruptWatcher()
    : watched_(stop_signals()),
      previous_(),
      signals_(signalfd(-1, &watched_, SFD_CLOEXEC)),
      wake_(eventfd(0, EFD_CLOEXEC)) {
  if (signals_ < 0 || wake_ < 0) {
    const int error = errno;
    close(signals_);
    close(wake_);
    throw std::system_error(error, std::generic_category(), "cannot watch for Ctrl-C");
  }
  pthread_sigmask(SIG_BLOCK, &watched_, &previous_);
  thread_ = std::thread([this] { watch(); });
}

InterruptWatcher::~InterruptWatcher() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = write(wake_, &one, sizeof one);
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
  close(signals_);
  close(wake_);
}

void InterruptWatcher::watch() noexcept {
  std::array<pollfd, 2> sources = {pollfd{signals_, POLLIN, 0}, pollfd{wake_, POLLIN, 0}};
  while (true) {
    if (poll(sources.data(), sources.size(), -1) < 0 && errno != EINTR) return;
    if ((sources[1].revents & POLLIN) != 0) return;
    if ((sources[0].revents & POLLIN) == 0) continue;
    signalfd_siginfo received{};
    if (read(signals_, &received, sizeof received) != sizeof received) return;
    if (requested_.exchange(true)) {
      // Sent again with the signal let through in this thread: its default action ends the process.
      pthread_sigmask(SIG_UNBLOCK, &watched_, nullptr);
      kill(getpid(), static_cast<int>(received.ssi_signo));
    }
  }
}

}  // namespace eisph
