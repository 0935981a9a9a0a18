#include "compare/whole_file.hpp"

#include "core/error.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

namespace eisph {

namespace {

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

std::string read_whole_file(const std::filesystem::path& path) {
  const auto refuse = [&](int error) {
    throw InputError(fmt::format("{}: cannot be read: {}", path.string(), reason(error)));
  };
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) refuse(EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file.is_open()) refuse(errno);
  std::string content{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) refuse(EIO);
  return content;
}

void write_whole_file(const std::filesystem::path& path, std::string_view content) {
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  const auto fail = [&](int error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path.string(), reason(error)));
  };
  errno = 0;
  std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
  if (!file.is_open()) fail(errno);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) fail(errno != 0 ? errno : EIO);
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error) fail(error.value());
}

}  // namespace eisph
