#include "render/png_file.hpp"

#include "render/temporary_folder.hpp"

#include <csignal>
#include <fstream>

#include <gmock/gmock.h>
#include <sys/resource.h>

namespace eisph {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Image test_image(int width, int height) {
  Image image(width, height);
  std::uint32_t random = 7;
  for (std::uint8_t& byte : image.rgb)
    byte = static_cast<std::uint8_t>((random = random * 1664525U + 1013904223U) >> 24U);
  return image;
}

std::size_t entries(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(PngFile, ReturnsEveryPixelAndText) {
  const TemporaryFolder folder;
  const Image image = test_image(37, 23);
  const PngText text = {{"Title", "A dam"}, {"time", "0.4"}, {"Author", "caf\u00e9 \u03c1"}};
  write_png(folder.path() / "a.png", image, text);
  const PngFile read = read_png(folder.path() / "a.png");
  EXPECT_EQ(read.image.width, 37);
  EXPECT_EQ(read.image.height, 23);
  EXPECT_EQ(read.image.rgb, image.rgb);
  EXPECT_EQ(read.text, text);
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(PngFile, ReplacesAnEarlierFile) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png(path, test_image(4, 4), {});
  write_png(path, test_image(6, 5), {});
  EXPECT_EQ(read_png(path).image.width, 6);
}

/// Files of the process cannot grow beyond `bytes` while it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }

 private:
  rlimit before_{};
};

TEST(PngFile, AnInterruptedWriteLeavesTheOldFileAndNoHalfOne) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png(path, test_image(4, 4), {});
  {
    const FileSizeLimit limit(20'000);
    EXPECT_THAT([&] { write_png(path, test_image(200, 200), {}); },
                ThrowsMessage<std::runtime_error>(HasSubstr(path.string())));
    EXPECT_THROW(write_png(folder.path() / "b.png", test_image(200, 200), {}), std::runtime_error);
  }
  EXPECT_EQ(read_png(path).image.width, 4);
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(PngFile, AnImageWithMissingBytesIsRefused) {
  const TemporaryFolder folder;
  Image image = test_image(8, 8);
  image.rgb.pop_back();
  EXPECT_THAT([&] { write_png(folder.path() / "a.png", image, {}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("191 bytes")));
  EXPECT_EQ(entries(folder.path()), 0U);
}

TEST(PngFile, ErrorsNameThePath) {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "no_folder" / "a.png";
  EXPECT_THAT([&] { write_png(missing, test_image(2, 2), {}); },
              ThrowsMessage<std::runtime_error>(HasSubstr(missing.string())));
  EXPECT_THAT([&] { return read_png(missing); },
              ThrowsMessage<std::runtime_error>(HasSubstr(missing.string())));
  const auto text = folder.path() / "text.png";
  std::ofstream(text) << "no picture at all";
  EXPECT_THAT([&] { return read_png(text); }, ThrowsMessage<std::runtime_error>(HasSubstr("not a PNG file")));
}

TEST(PngFile, ATruncatedFileIsReportedAsDamaged) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png(path, test_image(50, 50), {});
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_THAT([&] { return read_png(path); }, ThrowsMessage<std::runtime_error>(HasSubstr("damaged")));
}

TEST(PngFile, AKeywordOverSeventyNineCharactersIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      [&] {
        write_png(folder.path() / "a.png", test_image(2, 2), {{std::string(80, 'k'), "v"}});
      },
      ThrowsMessage<std::runtime_error>(HasSubstr("79")));
}

}  // namespace
}  // namespace eisph
