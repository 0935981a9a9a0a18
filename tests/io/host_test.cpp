#include "io/host.hpp"

#include "io/temporary_folder.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <unistd.h>

namespace eisph {
namespace {

using testing::StartsWith;

TEST(HostInfo, ReadsTheSystemsFiles) {
  const TemporaryFolder root;
  for (const char* folder : {"proc", "etc"}) std::filesystem::create_directory(root / folder);
  put_text(root / "proc" / "cpuinfo",
           "processor\t: 0\nmodel name\t: Some CPU @ 2.5GHz: fast\n\nmodel name\t: Other\n");
  put_text(root / "proc" / "meminfo", "MemTotal:        2048 kB\nMemFree:  1 kB\n");
  put_text(root / "etc" / "os-release", "NAME=\"Debian\"\nPRETTY_NAME=\"Debian GNU/Linux 12 (bookworm)\"\n");
  const HostInfo host = host_info(root.path());
  EXPECT_EQ(host.cpu_model, "Some CPU @ 2.5GHz: fast");
  EXPECT_EQ(host.memory_bytes, 2097152U);
  EXPECT_THAT(host.os, StartsWith("Debian GNU/Linux 12 (bookworm), Linux "));
}

TEST(HostInfo, LeavesOutWhatTheSystemDoesNotTell) {
  const TemporaryFolder root;
  const HostInfo host = host_info(root.path());
  EXPECT_EQ(host.cpu_model, "");
  EXPECT_EQ(host.memory_bytes, 0U);
  EXPECT_THAT(host.os, StartsWith("Linux "));
}

TEST(HostInfo, DescribesThisMachine) {
  const HostInfo host = host_info();
  const auto pages = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES));
  const auto page_size = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  EXPECT_FALSE(host.name.empty());
  EXPECT_GE(host.cores, 1U);
  EXPECT_NEAR(static_cast<double>(host.memory_bytes), static_cast<double>(pages * page_size), 0.01 * 1e12);
}

TEST(PeakRss, GrowsWithTheMemoryInUse) {
  constexpr std::size_t kBytes = 128 << 20;
  const std::uint64_t before = peak_rss_bytes();
  const std::vector<char> block(kBytes, 1);
  EXPECT_GE(peak_rss_bytes(), before + kBytes / 2) << block.back();
  EXPECT_LT(peak_rss_bytes(), before + 16 * kBytes);
}

TEST(CpuTime, CountsWork) {
  const double before = cpu_time();
  volatile double sum = 0.0;
  while (cpu_time() < before + 0.02) sum = sum + std::sqrt(sum + 1.0);
  EXPECT_GT(cpu_time(), before);
  EXPECT_LT(cpu_time() - before, 10.0);
}

TEST(IsoTime, IsInUniversalTime) {
  using std::chrono::seconds;
  using Clock = std::chrono::system_clock;
  EXPECT_EQ(iso_time(Clock::time_point(seconds(0))), "1970-01-01T00:00:00Z");
  EXPECT_EQ(iso_time(Clock::time_point(seconds(1709209800))), "2024-02-29T12:30:00Z");
}

}  // namespace
}  // namespace eisph
