#pragma once

#include "render/png_file.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <png.h>

namespace eisph {

// libpng, with its errors as return values and files replaced as a whole.

/// Throws std::runtime_error that names the path.
[[noreturn]] void fail_png(const std::filesystem::path& path, const std::string& what);

/// What libpng complained about; it then jumps back to the setjmp of the calling function.
struct PngComplaint {
  char message[200] = "";
};

/// How pixels lie in a row.
struct PngLayout {
  int width = 0;
  int height = 0;
  int bit_depth = 8;  ///< of a channel; 16-bit channels have their high byte first
  int colour_type = PNG_COLOR_TYPE_RGB;
};

class PngReader {
 public:
  PngReader();
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader();

  /// Reads the header and leaves pixels as they are in the file, but without transparency.
  bool read_header(std::FILE* file);
  /// The same, with pixels as 8-bit RGB.
  bool read_header_as_rgb(std::FILE* file);
  bool read_rows(png_bytep* rows);
  /// Of the file.
  [[nodiscard]] PngLayout layout() const;
  [[nodiscard]] std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
  [[nodiscard]] PngText text() const;
  [[nodiscard]] const char* message() const { return complaint_.message; }

 private:
  bool start(std::FILE* file);

  PngComplaint complaint_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  PngLayout layout_;
};

/// Writes rows to a temporary file that then takes the place of `path`.
void write_png_rows(const std::filesystem::path& path, const PngLayout& layout, const png_byte* pixels,
                    std::size_t row_bytes, const PngText& text);

using PngStream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
/// Throws if the file cannot be opened.
[[nodiscard]] PngStream open_png(const std::filesystem::path& path);

}  // namespace eisph
