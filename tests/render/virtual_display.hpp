#pragma once

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace eisph {

/// Changes an environment variable while it lives; null takes it away.
class EnvironmentVariable {
 public:
  EnvironmentVariable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  EnvironmentVariable(const EnvironmentVariable&) = delete;
  EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;
  ~EnvironmentVariable() { set(before_.empty() ? nullptr : before_.c_str()); }
  void set(const char* value) const {
    if (value != nullptr) {
      setenv(name_, value, 1);
    } else {
      unsetenv(name_);
    }
  }

 private:
  const char* name_;
  std::string before_;
};

/// As on a machine without a display.
class WithoutDisplay {
  EnvironmentVariable display_{"DISPLAY", nullptr};
  EnvironmentVariable wayland_{"WAYLAND_DISPLAY", nullptr};
};

/// A display in memory (Xvfb) while it lives, for windows of this process.
class VirtualDisplay {
 public:
  explicit VirtualDisplay(const std::string& screen = "1366x768x24") {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    server_ = fork();
    if (server_ == 0) {
      close(ends[0]);
      const std::string number = std::to_string(ends[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp",
             static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    std::string number;
    char digit = 0;
    while (read(ends[0], &digit, 1) == 1 && digit != '\n') number += digit;
    close(ends[0]);
    if (number.empty()) throw std::runtime_error("Xvfb does not start (Debian package xvfb)");
    display_.set((":" + number).c_str());
  }
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;
  ~VirtualDisplay() {
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
  }

 private:
  EnvironmentVariable display_{"DISPLAY", nullptr};
  pid_t server_ = -1;
};

}  // namespace eisph
