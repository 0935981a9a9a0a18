#include "render/png_codec.hpp"

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

namespace eisph {

namespace {

void on_error(png_structp png, png_const_charp message) {
  auto* complaint = static_cast<PngComplaint*>(png_get_error_ptr(png));
  std::snprintf(complaint->message, sizeof complaint->message, "%s", message);
  std::longjmp(png_jmpbuf(png), 1);
}

void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

class PngWriter {
 public:
  PngWriter() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint_, on_error, on_warning)) {
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
  }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

  /// Holds no object with a destructor, since libpng leaves it by longjmp.
  bool write(std::FILE* file, const PngLayout& layout, const png_byte* pixels, std::size_t row_bytes,
             png_text* text, int text_count) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_init_io(png_, file);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(layout.width), static_cast<png_uint_32>(layout.height),
                 layout.bit_depth, layout.colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png_, 1);
    png_set_compression_strategy(png_, Z_RLE);
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    if (text_count > 0) png_set_text(png_, info_, text, text_count);
    png_write_info(png_, info_);
    for (int row = 0; row < layout.height; ++row)
      png_write_row(png_, pixels + static_cast<std::size_t>(row) * row_bytes);
    png_write_end(png_, info_);
    return true;
  }
  [[nodiscard]] const char* message() const { return complaint_.message; }

 private:
  PngComplaint complaint_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

std::vector<png_text> as_chunks(const std::filesystem::path& path, const PngText& text) {
  std::vector<png_text> chunks;
  for (const auto& [key, value] : text) {
    if (key.empty() || key.size() > 79)
      fail_png(path, fmt::format("text keyword '{}' has not 1 to 79 characters", key));
    const bool ascii = std::all_of(value.begin(), value.end(), [](unsigned char c) { return c < 0x80; });
    png_text chunk{};
    chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<png_charp>(key.c_str());
    chunk.text = const_cast<png_charp>(value.c_str());
    chunk.text_length = ascii ? value.size() : 0;
    chunk.itxt_length = ascii ? 0 : value.size();
    chunks.push_back(chunk);
  }
  return chunks;
}

/// Removes the file unless it was moved to its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path final_path)
      : final_path_(std::move(final_path)), path_(final_path_) {
    path_ += ".part";
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    if (!moved_) std::filesystem::remove(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void move_to_final_name() {
    std::error_code error;
    std::filesystem::rename(path_, final_path_, error);
    if (error) fail_png(final_path_, "cannot be replaced: " + error.message());
    moved_ = true;
  }

 private:
  std::filesystem::path final_path_;
  std::filesystem::path path_;
  bool moved_ = false;
};

std::string reason() { return std::generic_category().message(errno); }

}  // namespace

void fail_png(const std::filesystem::path& path, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: {}", path.string(), what));
}

PngReader::PngReader()
    : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint_, on_error, on_warning)) {
  if (png_ != nullptr) info_ = png_create_info_struct(png_);
  if (info_ == nullptr) throw std::bad_alloc();
}

PngReader::~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

bool PngReader::start(std::FILE* file) {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  png_init_io(png_, file);
  png_read_info(png_, info_);
  layout_ = {static_cast<int>(png_get_image_width(png_, info_)),
             static_cast<int>(png_get_image_height(png_, info_)), png_get_bit_depth(png_, info_),
             png_get_color_type(png_, info_)};
  return true;
}

bool PngReader::read_header(std::FILE* file) {
  if (!start(file)) return false;
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  png_set_strip_alpha(png_);
  png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  return true;
}

bool PngReader::read_header_as_rgb(std::FILE* file) {
  if (!start(file)) return false;
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  png_set_expand(png_);
  png_set_strip_16(png_);
  png_set_strip_alpha(png_);
  png_set_gray_to_rgb(png_);
  png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  return true;
}

bool PngReader::read_rows(png_bytep* rows) {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  png_read_image(png_, rows);
  png_read_end(png_, info_);
  return true;
}

PngLayout PngReader::layout() const { return layout_; }

PngText PngReader::text() const {
  png_textp chunks = nullptr;
  const int count = png_get_text(png_, info_, &chunks, nullptr);
  PngText result;
  for (int k = 0; k < count; ++k) result.emplace_back(chunks[k].key, chunks[k].text);
  return result;
}

void write_png_rows(const std::filesystem::path& path, const PngLayout& layout, const png_byte* pixels,
                    std::size_t row_bytes, const PngText& text) {
  std::vector<png_text> chunks = as_chunks(path, text);
  TemporaryFile temporary(path);
  PngStream file(std::fopen(temporary.path().c_str(), "wb"), std::fclose);
  if (!file) fail_png(path, "cannot be written: " + reason());
  PngWriter writer;
  if (!writer.write(file.get(), layout, pixels, row_bytes, chunks.data(), static_cast<int>(chunks.size()))) {
    fail_png(path, fmt::format("cannot be written: {}", writer.message()));
  }
  if (std::fclose(file.release()) != 0) fail_png(path, "cannot be written: " + reason());
  temporary.move_to_final_name();
}

PngStream open_png(const std::filesystem::path& path) {
  PngStream file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail_png(path, "cannot be read: " + reason());
  return file;
}

}  // namespace eisph
