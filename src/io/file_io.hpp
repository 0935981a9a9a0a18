#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace eisph {

/// A file open for writing. A failure throws std::runtime_error with the path and the system's reason.
class OutputFile {
 public:
  /// Creates the file, or empties the one that is there.
  explicit OutputFile(std::filesystem::path path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// Adds all of `bytes`, in one system call where the system allows it. If that fails, what part of them has
  /// reached the file is taken back.
  void append(std::string_view bytes);
  /// Closes the file and reports what the destructor would keep to itself.
  void close();

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;
};

/// Replaces a file as a whole: the content goes to a temporary file in the same folder, which takes the place
/// of the target on commit(). Without commit the target stays as it was.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Where to write: the target's path with ".tmp" appended.
  [[nodiscard]] const std::filesystem::path& temporary_path() const { return temporary_; }
  /// Throws std::runtime_error if the temporary file cannot be renamed.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

/// Throws std::runtime_error if the file cannot be written; it is then unchanged.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The whole content. Throws InputError if the file cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Makes a folder and those above it where they are missing. Throws std::runtime_error if that fails.
void create_folder(const std::filesystem::path& folder);

}  // namespace eisph
