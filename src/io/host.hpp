#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace eisph {

/// The machine a program runs on.
struct HostInfo {
  std::string name;
  std::string cpu_model;           ///< empty if the system does not tell
  unsigned cores = 0;              ///< that this process may use
  std::uint64_t memory_bytes = 0;  ///< 0 if the system does not tell
  std::string os;                  ///< distribution and kernel
};

/// Reads proc/cpuinfo, proc/meminfo and etc/os-release below `root`.
[[nodiscard]] HostInfo host_info(const std::filesystem::path& root = "/");

/// Largest resident size of this process so far, or since reset_peak_rss(), bytes.
[[nodiscard]] std::uint64_t peak_rss_bytes();

/// Lets peak_rss_bytes() count from the present size on, where the system can (Linux); else does nothing.
void reset_peak_rss();

/// Processor time that all threads of this process have used so far, seconds, user and system.
[[nodiscard]] double cpu_time();

/// ISO 8601 in UTC, to the second: 2024-02-29T12:30:00Z.
[[nodiscard]] std::string iso_time(std::chrono::system_clock::time_point time);

}  // namespace eisph
