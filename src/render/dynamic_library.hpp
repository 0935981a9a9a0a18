#pragma once

#include "core/error.hpp"

#include <filesystem>
#include <string>
#include <utility>

#include <dlfcn.h>
#include <fmt/format.h>

namespace eisph {

/// A library opened at run time. It is never unmapped, as drivers and what they load keep destructors that
/// run when the program ends.
class DynamicLibrary {
 public:
  /// `what` it is and the `advice` stand in messages. Throws InputError if it cannot be opened.
  DynamicLibrary(const std::filesystem::path& path, std::string what, std::string advice)
      : path_(path.string()),
        what_(std::move(what)),
        advice_(std::move(advice)),
        handle_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
    if (handle_ != nullptr) return;
    throw InputError(fmt::format("{}: {} cannot be opened ({}); {}", path_, what_,
                                 dlerror(),  // NOLINT(concurrency-mt-unsafe)
                                 advice_));
  }
  DynamicLibrary(const DynamicLibrary&) = delete;
  DynamicLibrary& operator=(const DynamicLibrary&) = delete;
  ~DynamicLibrary() { dlclose(handle_); }

  /// Sets a pointer to the function of that name; throws InputError if there is none.
  template <class Function>
  void find(const char* name, Function& function) const {
    function = reinterpret_cast<Function>(dlsym(handle_, name));
    if (function == nullptr)
      throw InputError(fmt::format("{}: {} has no {}; {}", path_, what_, name, advice_));
  }

 private:
  std::string path_;
  std::string what_;
  std::string advice_;
  void* handle_;
};

}  // namespace eisph
