#include "io/host.hpp"

#include <array>
#include <charconv>
#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

namespace eisph {

namespace {

constexpr std::string_view kSpace = " \t\"";

/// Value of the first `key` of a file of lines `key : value` or `key=value`, without blanks and quotes.
std::string value_of(const std::filesystem::path& file, std::string_view key, char separator) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t split = line.find(separator);
    if (split == std::string::npos) continue;
    const std::string name = line.substr(0, line.find_last_not_of(kSpace, split - 1) + 1);
    if (split == 0 || name != key) continue;
    const std::size_t first = line.find_first_not_of(kSpace, split + 1);
    if (first == std::string::npos) return {};
    return line.substr(first, line.find_last_not_of(kSpace) + 1 - first);
  }
  return {};
}

/// Bytes of a value like "16384 kB"; zero if there is none.
std::uint64_t bytes_of(const std::filesystem::path& file, std::string_view key) {
  const std::string text = value_of(file, key, ':');
  std::uint64_t kibibytes = 0;
  std::from_chars(text.data(), text.data() + text.size(), kibibytes);
  return 1024 * kibibytes;
}

unsigned usable_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (::sched_getaffinity(0, sizeof(cores), &cores) == 0) return static_cast<unsigned>(CPU_COUNT(&cores));
  return std::thread::hardware_concurrency();
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

rusage own_usage() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage;
}

}  // namespace

HostInfo host_info(const std::filesystem::path& root) {
  HostInfo host;
  utsname system{};
  ::uname(&system);
  host.name = system.nodename;
  host.cpu_model = value_of(root / "proc/cpuinfo", "model name", ':');
  host.cores = usable_cores();
  host.memory_bytes = bytes_of(root / "proc/meminfo", "MemTotal");
  const std::string distribution = value_of(root / "etc/os-release", "PRETTY_NAME", '=');
  const std::string kernel = fmt::format("{} {}", system.sysname, system.release);
  host.os = distribution.empty() ? kernel : fmt::format("{}, {}", distribution, kernel);
  return host;
}

std::uint64_t peak_rss_bytes() {
  // ru_maxrss would include the size that the starting process had before it turned into this program.
  const std::uint64_t bytes = bytes_of("/proc/self/status", "VmHWM");
  return bytes > 0 ? bytes : 1024 * static_cast<std::uint64_t>(own_usage().ru_maxrss);
}

void reset_peak_rss() { std::ofstream("/proc/self/clear_refs") << 5; }

double cpu_time() {
  const rusage usage = own_usage();
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string iso_time(std::chrono::system_clock::time_point time) {
  const std::time_t whole_seconds = std::chrono::system_clock::to_time_t(time);
  std::tm utc{};
  ::gmtime_r(&whole_seconds, &utc);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text.data(), length};
}

}  // namespace eisph
